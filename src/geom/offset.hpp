#pragma once
/// Regions grown or shrunk by a distance; equidistants of contours to one side.

#include <vector>

#include "geom/region.hpp"

namespace obrys::geom {

/// Outward (by > 0): the points within `by` of the region. Inward (by < 0): the points of the region at least -by from
/// everything outside it. Arcs stay arcs, outer corners are rounded; exact up to the weld (geom/tolerance.hpp).
[[nodiscard]] Region offset(const Region& r, double by);

/// The points within `d` > 0 of an open or closed chain of edges, on both sides, its ends rounded.
[[nodiscard]] Region band(const Contour& c, double d);

/// The equidistants of a contour, open or closed, `by` to its left (> 0) or right (< 0): the part of the boundary of
/// the band about the contour (all points within |by| of it) that lies beside its edges on that side, or about its
/// outer corners. So no point of them is nearer than |by| to any part of the contour, and stretches where a circle of
/// that radius would not fit are left out, and gaps just as wide as the circle. Chains run as the contour does and
/// stand in its order; there are several where the circle does not get past a place, some may be closed (that of a
/// closed contour, inside of a loop), none where nothing is left. The half circles about the ends of an open contour do
/// not belong to it. by = 0 gives the contour. The contour may cross itself.
[[nodiscard]] std::vector<Contour> equidistants(const Contour& c, double by);

}  // namespace obrys::geom
