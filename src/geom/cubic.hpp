#pragma once
/// Cubic polynomials and the curves in space made of three of them, over the parameter 0..1. Nothing is approximated
/// but the length.

#include <array>
#include <utility>

#include "geom/vec.hpp"

namespace obrys::geom {

/// ((k3 t + k2) t + k1) t + k0, of any unit.
struct Polynomial3 {
    double k0 = 0, k1 = 0, k2 = 0, k3 = 0;
    bool operator==(const Polynomial3&) const = default;
};
[[nodiscard]] constexpr double value_at(const Polynomial3& p, double t) {
    return ((p.k3 * t + p.k2) * t + p.k1) * t + p.k0;
}
[[nodiscard]] constexpr double slope_at(const Polynomial3& p, double t) { return (3 * p.k3 * t + 2 * p.k2) * t + p.k1; }

/// Where the slope changes its sign, in 0 < t < 1, increasing.
struct Turns {
    std::array<double, 2> t{};
    int count = 0;
};
[[nodiscard]] Turns turns(const Polynomial3& p);
/// Smallest and largest value over 0..1; both NaN where a coefficient is not finite.
[[nodiscard]] std::pair<double, double> range(const Polynomial3& p);

struct Cubic {
    Vec3 k0, k1, k2, k3;
    bool operator==(const Cubic&) const = default;
};
[[nodiscard]] constexpr Polynomial3 component(const Cubic& c, std::size_t axis) {
    if (axis == 0) return {c.k0.x, c.k1.x, c.k2.x, c.k3.x};
    if (axis == 1) return {c.k0.y, c.k1.y, c.k2.y, c.k3.y};
    return {c.k0.z, c.k1.z, c.k2.z, c.k3.z};
}
[[nodiscard]] constexpr Vec3 point_at(const Cubic& c, double t) {
    return {value_at(component(c, 0), t), value_at(component(c, 1), t), value_at(component(c, 2), t)};
}
/// Derivative by the parameter, mm; its length is the speed.
[[nodiscard]] constexpr Vec3 derivative_at(const Cubic& c, double t) {
    return {slope_at(component(c, 0), t), slope_at(component(c, 1), t), slope_at(component(c, 2), t)};
}
/// The same curve run backwards: point_at(reversed(c), t) is point_at(c, 1 - t).
[[nodiscard]] Cubic reversed(const Cubic& c);
/// Unit vector in which the curve leaves its point at t = 0, also where the derivative vanishes there; zero vector for
/// a curve that is a point, NaN where it is not known.
[[nodiscard]] Vec3 leaving(const Cubic& c);
/// Length between two parameters by adaptive Gauss-Legendre quadrature, error below 1e-9 mm or 1e-13 of the length,
/// whichever is more. Does not need k0. NaN where the other coefficients are not known or too large to compute with.
[[nodiscard]] double curve_length(const Cubic& c, double t0 = 0, double t1 = 1);

/// Box parallel to the axes; NaN along an axis whose coefficients are not known.
struct Box3 {
    Vec3 lo, hi;
    bool operator==(const Box3&) const = default;
};
[[nodiscard]] Box3 box(const Cubic& c);

/// Into how many pieces of equal parameter the curve must be cut so that no chord leaves it by more than `tolerance`
/// mm; at least 1, at most 10 000.
[[nodiscard]] int chord_count(const Cubic& c, double tolerance);

/// The parabola through three points, at t = 0, 1/2 and 1: its tangent at `b` is parallel to the line from `a` to `c`.
[[nodiscard]] Cubic parabola(Vec3 a, Vec3 b, Vec3 c);

/// Angle between two directions in radians, 0..pi; NaN where one is zero or not known.
[[nodiscard]] double angle_between(Vec3 a, Vec3 b);

}  // namespace obrys::geom
