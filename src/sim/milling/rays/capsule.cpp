// The inner loops: a ball or disc on a straight way, against a row of rays. Compiled without errno for square roots, so
// that the compiler can take several rays at a time.

#include <cmath>

#include "sim/milling/rays/lanes.hpp"
#include "sim/milling/rays/rows.hpp"

namespace obrys::sim::milling {

Aim aim_of(geom::Vec3 v, geom::Vec3 d) {
    constexpr double negligible = 1e-8;  // way across the rays, against the whole way: then the other error is as large
    Aim aim;
    aim.along = dot(v, d);
    const geom::Vec3 across = v - aim.along * d;
    const double way = length(across), whole = length(v);
    if (way > negligible * whole) {
        aim.way = way;
        aim.slope = aim.along / way;
        aim.sine = aim.along / whole;
        aim.e = (1 / way) * across;
    } else {
        // Any; normal to the tool's axis where the rays are.
        const geom::Vec3 e = std::fabs(d.z) < 0.5 ? cross(geom::Vec3{0, 0, 1}, d) : cross(geom::Vec3{1, 0, 0}, d);
        aim.e = (1 / length(e)) * e;
    }
    aim.beside = cross(d, aim.e);
    return aim;
}

Aims aims_of(const Track& track, geom::Vec3 d, Lie lie) {
    const geom::Vec3 level{track.v.x, track.v.y, 0};
    Aims aims;
    aims.lie = lie;
    aims.whole = aim_of(track.v, d);
    aims.level = aim_of(level, d);
    aims.flat_length = std::sqrt(d.x * d.x + d.y * d.y);
    if (aims.flat_length < 1e-6) aims.flat_length = 0;
    if (aims.flat_length > 0) {
        aims.flat_d = {d.x / aims.flat_length, d.y / aims.flat_length, 0};
        aims.flat = aim_of(level, aims.flat_d);
    }
    return aims;
}

}  // namespace obrys::sim::milling

namespace obrys::sim::milling::detail {

Capsule capsule_of(const Aim& aim, const Row& row, double t0, double t1, double radius) {
    Capsule c;
    c.square = radius * radius;
    c.from = t0 * aim.way;
    c.to = t1 * aim.way;
    c.slope = aim.slope;
    c.sine = aim.sine;
    if (aim.way == 0) {
        c.low_shift = std::fmin(t0 * aim.along, t1 * aim.along);
        c.high_shift = std::fmax(t0 * aim.along, t1 * aim.along);
    }
    c.a = dot(row.p, aim.e);
    c.a_step = dot(row.step, aim.e);
    c.n = dot(row.p, aim.beside);
    c.n_step = dot(row.step, aim.beside);
    return c;
}

OBRYS_LANES void capsule_row(const Capsule& c, int count, Spans& spans) {
    const int lanes = in_full(count);
    const double sine = c.sine;
    double* const low = spans.low.data();
    double* const high = spans.high.data();
    for (int i = 0; i < lanes; ++i) {
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

OBRYS_LANES void stretch_row(const Steps& foot, double scale, int count, Spans& spans) {
    const int lanes = in_full(count);
    double* const low = spans.low.data();
    double* const high = spans.high.data();
    for (int i = 0; i < lanes; ++i) {
        low[i] = (low[i] - (foot.at + i * foot.step)) * scale;
        high[i] = (high[i] - (foot.at + i * foot.step)) * scale;
    }
}

OBRYS_LANES void clip_row(const Steps& one, const Steps& other, int count, Spans& spans) {
    const int lanes = in_full(count);
    double* const low = spans.low.data();
    double* const high = spans.high.data();
    for (int i = 0; i < lanes; ++i) {
        const double a = one.at + i * one.step, b = other.at + i * other.step;
        low[i] = low[i] > a ? low[i] : a;
        high[i] = high[i] < b ? high[i] : b;
    }
}

OBRYS_LANES void capsule_low_row(const Capsule& c, int count, double high, Spans& spans) {
    const int lanes = in_full(count);
    const double sine = c.sine;
    double* const low = spans.low.data();
    for (int i = 0; i < lanes; ++i) {
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

OBRYS_LANES int candidates(const Spans& spans, double base, const double* gap_low, const double* gap_high, int count,
                           std::array<int, Row::most>& rays) {
    const double* const low = spans.low.data();
    const double* const high = spans.high.data();
    std::array<long long, Row::most> wanted;  // as wide as a double, so that lanes keep their places
    const int lanes = in_full(count);
    for (int i = 0; i < lanes; ++i) {
        const double from = base + low[i], to = base + high[i];
        wanted[static_cast<std::size_t>(i)] =
            static_cast<long long>(from < to) &
            (static_cast<long long>(from < gap_low[i]) | static_cast<long long>(to > gap_high[i]));
    }
    std::size_t found = 0;
    for (int i = 0; i < count; ++i) {
        rays[found] = i;
        found += wanted[static_cast<std::size_t>(i)] != 0 ? 1 : 0;
    }
    return static_cast<int>(found);
}

}  // namespace obrys::sim::milling::detail
