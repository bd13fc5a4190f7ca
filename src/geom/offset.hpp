#pragma once
/// Regions grown or shrunk by a distance.

#include "geom/region.hpp"

namespace obrys::geom {

/// Outward (by > 0): the points within `by` of the region. Inward (by < 0): the points of the region at least -by from
/// everything outside it. Arcs stay arcs, outer corners are rounded; exact up to the weld (geom/tolerance.hpp).
[[nodiscard]] Region offset(const Region& r, double by);

}  // namespace obrys::geom
