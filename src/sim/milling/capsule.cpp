// The inner loops: a ball or disc on a straight way, against a row of rays. Compiled without errno for square roots, so
// that the compiler can take several rays at a time.

#include <cmath>

#include "sim/milling/rows.hpp"

namespace obrys::sim::milling::detail {

Capsule capsule_of(geom::Vec3 v, const Row& row, double t0, double t1, double radius) {
    constexpr double negligible = 1e-8;  // way across the rays, against the whole way: then the other error is as large
    Capsule c;
    const double along = dot(v, row.d);
    const geom::Vec3 across = v - along * row.d;
    const double way = length(across);
    c.square = radius * radius;
    geom::Vec3 e;
    if (way <= negligible * length(v)) {
        c.low_shift = std::fmin(t0 * along, t1 * along);
        c.high_shift = std::fmax(t0 * along, t1 * along);
        e = (1 / length(row.step)) * row.step;
    } else {
        e = (1 / way) * across;
        c.from = t0 * way;
        c.to = t1 * way;
        c.slope = along / way;
    }
    const geom::Vec3 beside = cross(row.d, e);
    c.a = dot(row.p, e);
    c.a_step = dot(row.step, e);
    c.n = dot(row.p, beside);
    c.n_step = dot(row.step, beside);
    return c;
}

void capsule_row(const Capsule& c, int count, Spans& spans) {
    const double sine = c.slope / std::sqrt(1 + c.slope * c.slope);
    double* const low = spans.low.data();
    double* const high = spans.high.data();
    for (int i = 0; i < count; ++i) {
        const double a = c.a + i * c.a_step, n = c.n + i * c.n_step;
        const double square = c.square - n * n;
        const double lean = sine * std::sqrt(square > 0 ? square : 0.0);
        double t = a - lean, u = a + lean;
        t = t < c.from ? c.from : t;
        t = t > c.to ? c.to : t;
        u = u < c.from ? c.from : u;
        u = u > c.to ? c.to : u;
        const double below = square - (a - t) * (a - t), above = square - (a - u) * (a - u);
        const double lower = t * c.slope + c.low_shift - std::sqrt(below > 0 ? below : 0.0);
        const double upper = u * c.slope + c.high_shift + std::sqrt(above > 0 ? above : 0.0);
        // Both radicands are negative, or neither is, but for rounding where the ray just touches.
        low[i] = below < 0 ? 1.0 : lower;
        high[i] = below < 0 ? 0.0 : upper;
    }
}

void capsule_low_row(const Capsule& c, int count, double high, Spans& spans) {
    const double sine = c.slope / std::sqrt(1 + c.slope * c.slope);
    double* const low = spans.low.data();
    for (int i = 0; i < count; ++i) {
        const double a = c.a + i * c.a_step, n = c.n + i * c.n_step;
        const double square = c.square - n * n;
        double t = a - sine * std::sqrt(square > 0 ? square : 0.0);
        t = t < c.from ? c.from : t;
        t = t > c.to ? c.to : t;
        const double below = square - (a - t) * (a - t);
        const double lower = t * c.slope + c.low_shift - std::sqrt(below > 0 ? below : 0.0);
        low[i] = below < 0 ? high : lower;
    }
    for (int i = 0; i < count; ++i) spans.high[static_cast<std::size_t>(i)] = high;
}

}  // namespace obrys::sim::milling::detail
