#pragma once
/// Numbers of which both may be unknown (NaN): then they are the same.

#include <cmath>

#include "geom/vec.hpp"

namespace obrys::compare {

inline bool near(double a, double b, double tolerance) {
    return a == b || (std::isnan(a) && std::isnan(b)) || std::abs(a - b) <= tolerance;
}
inline bool near(const geom::Vec3& a, const geom::Vec3& b, double tolerance) {
    return near(a.x, b.x, tolerance) && near(a.y, b.y, tolerance) && near(a.z, b.z, tolerance);
}

}  // namespace obrys::compare
