#pragma once
/// How far a piece lies from a contour along x.

#include "geom/contour.hpp"

namespace obrys::sim::turning {

/// Largest distance, mm, from a point of `piece` along x (the shorter way) to the contour of `region`, of which the axis
/// x = 0 is no part. Columns without contour do not count.
[[nodiscard]] double deepest_along_x(const geom::Region& piece, const geom::Region& region);

}  // namespace obrys::sim::turning
