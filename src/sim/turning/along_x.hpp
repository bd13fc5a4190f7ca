#pragma once
/// How far a piece lies from a contour along x.

#include <vector>

#include "geom/contour.hpp"
#include "geom/edge.hpp"

namespace obrys::sim::turning {

/// An edge of a contour with what is asked of it again and again.
struct Wall {
    geom::Edge edge;
    geom::Box box;
    bool arc = false;
};
[[nodiscard]] std::vector<Wall> walls_of(const geom::Region& region);

/// Largest distance, mm, from a point of `piece` along x (the shorter way) to the contour, given without its edges on
/// the axis. Columns without contour do not count.
[[nodiscard]] double deepest_along_x(const geom::Region& piece, const std::vector<Wall>& contour);

}  // namespace obrys::sim::turning
