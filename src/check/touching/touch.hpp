#pragma once
/// Whether a body touches what is left of a stock, by some of its places: its rim all along its way. What they say is
/// so; what they do not meet may be there all the same. Frame of the stock, mm.

#include <span>

#include "check/touching/cleared.hpp"
#include "geom/interpolation.hpp"

namespace obrys::check {

struct Touched {
    double depth = 0;  ///< of the deepest of these places, at most what was asked for; 0: none touches
    geom::Vec3 at;
};

struct Touching {
    const geom::PathElement& path;                      ///< of the tip
    geom::Vec3 axis;                                    ///< unit length
    std::span<const std::vector<geom::Vec2>> profiles;  ///< half sections: radius and height, upwards
    Zone heights;                                       ///< of the stock along the axis
    double enough = 0;                                  ///< deeper is not asked for
};
[[nodiscard]] Touched touch(Cleared& left, const Touching& body);

}  // namespace obrys::check
