#pragma once
/// Small measures of a contour of lines and arcs that readers of profiles need.

#include <optional>
#include <utility>

#include "geom/contour.hpp"

namespace obrys::shop {

[[nodiscard]] double signed_area(const geom::Contour& closed);       ///< mm2, positive counter-clockwise
[[nodiscard]] geom::Contour reversed(const geom::Contour& contour);  ///< the same edges, run the other way
/// Smallest Vec2.y of the edge from a to b.
[[nodiscard]] double lowest_y(geom::Vertex a, geom::Vec2 b);
/// Two edges (by the index of their first vertex, smaller one first) that meet elsewhere than at a shared corner.
[[nodiscard]] std::optional<std::pair<std::size_t, std::size_t>> first_crossing(const geom::Contour& closed);

}  // namespace obrys::shop
