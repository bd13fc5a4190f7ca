#pragma once
/// Set operations on regions with lines and arcs. Edges that coincide, touch or are shorter than the tolerance are
/// welded (geom/tolerance.hpp); results have material left of every edge and no slivers.

#include "geom/region.hpp"

namespace obrys::geom {

[[nodiscard]] Region unite(const Region& a, const Region& b);
[[nodiscard]] Region subtract(const Region& a, const Region& b);
[[nodiscard]] Region intersect(const Region& a, const Region& b);
/// The points about which the closed contours wind a positive number of times.
[[nodiscard]] Region positive(const std::vector<Contour>& contours);
/// A region from contours as somebody drew them: loops may run either way round and cross; material is where the
/// number of crossings from outside is odd.
[[nodiscard]] Region tidied(const std::vector<Contour>& contours);

/// The region's connected pieces, each an outer contour with the holes in it.
[[nodiscard]] std::vector<Region> pieces(const Region& r);

}  // namespace obrys::geom
