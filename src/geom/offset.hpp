#pragma once
/// Equidistant of a region.

#include "geom/region.hpp"

namespace obrys::geom {

/// Every point nearer than `distance` to the region (positive), or farther than -distance from its outside (negative).
/// Lines and arcs; outer corners become arcs.
[[nodiscard]] Region offset(const Region& r, double distance);

}  // namespace obrys::geom
