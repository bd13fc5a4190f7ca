#pragma once
/// Whether a turned part still hangs on its bar.

#include <optional>

#include "geom/region.hpp"

namespace obrys::check {

/// The thinnest section behind the part's left end.
struct Neck {
    double z = 0, thickness = 0;  ///< mm, along the radius
    double inner = 0, outer = 0;  ///< radii
};

/// Nothing where no cut behind the left end of `part` has gone halfway down to its bore or axis, and where it has gone
/// through: then nothing is to be said. (z, x) plane.
[[nodiscard]] std::optional<Neck> neck_behind(const geom::Region& part, const geom::Region& stock);

}  // namespace obrys::check
