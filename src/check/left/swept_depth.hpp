#pragma once
/// How deep a point lies in what a convex body of revolution sweeps on a straight way, and the plane that is nearest.
/// Millimetres.

#include <vector>

#include "geom/vec.hpp"
#include "sim/milling/track.hpp"

namespace obrys::check {

class SweptDepth {
public:
    struct Nearest {
        geom::Vec3 out;    ///< unit length
        double depth = 0;  ///< of the point behind the plane; negative before it
    };
    /// `profile`: radius and height, upwards, convex. `open_below`, `open_above`: it has no end there.
    SweptDepth(const std::vector<geom::Vec2>& profile, geom::Vec3 axis, geom::Vec3 from, geom::Vec3 way,
               bool open_below, bool open_above);
    /// All of the body lies behind that plane; no other one that is normal to its surface is nearer.
    [[nodiscard]] Nearest nearest(geom::Vec3 p) const;

private:
    /// By the slope of the normal: towards the radius and up.
    void attempt(geom::Vec2 slope, geom::Vec3 p, Nearest& best) const;
    [[nodiscard]] Nearest at_slope(geom::Vec2 slope, geom::Vec3 p) const;

    std::vector<geom::Vec2> profile_;
    sim::milling::Orientation frame_;
    geom::Vec3 from_, way_;           ///< the way in the body's frame
    std::vector<geom::Vec2> slopes_;  ///< of the profile's sides, upwards
    bool slants_ = false;             ///< the way is not level: rims sweep faces of their own
};

}  // namespace obrys::check
