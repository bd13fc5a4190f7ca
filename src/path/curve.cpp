#include "path/curve.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace obrys::path {

using geom::Vec2;

namespace {

bool is_arc(const Curve& c) { return c.sweep != 0; }

struct Points {
    std::array<Vec2, 2> p{};
    std::size_t count = 0;
};

Vec2 direction(const Curve& line) {
    const double l = geom::distance(line.from, line.to);
    return l > 0 ? (1.0 / l) * (line.to - line.from) : Vec2{};
}

Points line_line(const Curve& a, const Curve& b) {
    const Vec2 u = direction(a), v = direction(b);
    const double det = geom::cross(u, v);
    if (std::abs(det) < 1e-12) return {};
    return {{a.to + (geom::cross(b.from - a.to, v) / det) * u}, 1};
}

/// Line through `p` along unit `u` with a circle; a miss by less than same_point counts as a touch.
Points line_circle(Vec2 p, Vec2 u, Vec2 centre, double radius) {
    const Vec2 foot = p + geom::dot(centre - p, u) * u;
    const double h = geom::distance(foot, centre);
    if (h > radius + same_point) return {};
    const double half = std::sqrt(std::max(0.0, (radius - h) * (radius + h)));
    return {{foot - half * u, foot + half * u}, 2};
}

Points circle_circle(Vec2 c1, double r1, Vec2 c2, double r2) {
    const double d = geom::distance(c1, c2);
    if (d < same_point || d > r1 + r2 + same_point || d < std::abs(r1 - r2) - same_point) return {};
    const Vec2 u = (1.0 / d) * (c2 - c1);
    const double along = 0.5 * (d + (r1 - r2) * (r1 + r2) / d);
    const double half = std::sqrt(std::max(0.0, (r1 - along) * (r1 + along)));
    const Vec2 base = c1 + along * u;
    return {{base - half * geom::left_of(u), base + half * geom::left_of(u)}, 2};
}

/// Common points of the lines or circles that carry a (at its end) and b (at its start).
Points carrier_points(const Curve& a, const Curve& b) {
    if (!is_arc(a) && !is_arc(b)) return line_line(a, b);
    if (!is_arc(a)) return line_circle(a.to, direction(a), b.centre, b.radius_from);
    if (!is_arc(b)) return line_circle(b.from, direction(b), a.centre, a.radius_to);
    return circle_circle(a.centre, a.radius_to, b.centre, b.radius_from);
}

/// Angle from p to q about the curve's centre in the sense of its sweep, 0 … 2π; a full turn less rounding is 0.
double angle_along(const Curve& c, Vec2 p, Vec2 q) {
    double a = std::copysign(1.0, c.sweep) * turn_between(p - c.centre, q - c.centre);
    if (a < 0) a += geom::full_turn;
    return geom::full_turn - a < std::max(1e-12, same_point / std::max(1.0, std::abs(c.radius_to)))
               ? a - geom::full_turn
               : a;
}

/// Place of p counted back from the end: exact near the end, one turn wide.
double place_from_end(const Curve& c, Vec2 p) {
    if (is_arc(c)) return extent(c) - angle_along(c, p, c.to);
    return geom::dot(p - c.from, direction(c));
}

double place_from_start(const Curve& c, Vec2 p) {
    if (is_arc(c)) return angle_along(c, c.from, p);
    return geom::dot(p - c.from, direction(c));
}

/// How far p lies past the end (or before the start) of a prolonged curve; negative where it does not.
double past_end(const Curve& c, Vec2 p) {
    if (!is_arc(c)) return geom::dot(p - c.to, direction(c));
    const double a = angle_along(c, c.to, p);
    return a <= 0.5 * geom::pi ? a : -1;
}

double before_start(const Curve& c, Vec2 p) {
    if (!is_arc(c)) return geom::dot(c.from - p, direction(c));
    const double a = angle_along(c, p, c.from);
    return a <= 0.5 * geom::pi ? a : -1;
}

Vec2 direction_at(const Curve& c, Vec2 p) {
    if (!is_arc(c)) return direction(c);
    const Vec2 radial = p - c.centre;
    return (std::copysign(1.0, c.sweep) / geom::length(radial)) * geom::left_of(radial);
}

/// Sine of the angle at which curves cross that overlap by same_point.
double touching(const Curve& a, const Curve& b) {
    const double bend = (is_arc(a) ? 1 / a.radius_to : 0) + (is_arc(b) ? 1 / b.radius_from : 0);
    return std::max(1e-12, std::sqrt(2 * same_point * bend));
}

double slack(const Curve& c) { return same_point / scale(c); }

}  // namespace

Curve parallel(const Element& e, double d0, double d1) {
    Curve c;
    c.centre = e.centre;
    c.sweep = e.sweep;
    if (!path::is_arc(e)) {
        const Vec2 n = geom::left_of(start_direction(e));
        c.from = e.from + d0 * n;
        c.to = e.to + d1 * n;
        return c;
    }
    const double outward = -std::copysign(1.0, e.sweep) * d1;
    const double start = geom::distance(e.from, e.centre), end = geom::distance(e.to, e.centre);
    c.radius_from = start + outward;
    c.radius_to = end + outward;
    c.from = e.centre + (c.radius_from / start) * (e.from - e.centre);
    c.to = e.centre + (c.radius_to / end) * (e.to - e.centre);
    return c;
}

double extent(const Curve& c) { return is_arc(c) ? std::abs(c.sweep) : geom::distance(c.from, c.to); }

double scale(const Curve& c) { return is_arc(c) ? std::max(std::abs(c.radius_to), same_point) : 1.0; }

bool exists(const Curve& c) { return !is_arc(c) || (c.radius_from > -same_point && c.radius_to > -same_point); }

bool carriers_meet(const Curve& a, const Curve& b) { return carrier_points(a, b).count > 0; }

std::optional<Crossing> crossing_within(const Curve& a, double a_begin, const Curve& b) {
    const Points points = carrier_points(a, b);
    std::optional<Crossing> best;
    double nearest = 0;
    for (std::size_t i = 0; i < points.count; ++i) {
        const Crossing c{points.p[i], place_from_end(a, points.p[i]), place_from_start(b, points.p[i])};
        const bool on_a = c.on_a >= a_begin - slack(a) && c.on_a <= extent(a) + slack(a);
        const bool on_b = c.on_b >= -slack(b) && c.on_b <= extent(b) + slack(b);
        const double away = (extent(a) - c.on_a) * scale(a) + c.on_b * scale(b);
        if (!on_a || !on_b || (best && away >= nearest)) continue;
        best = c;
        nearest = away;
    }
    return best;
}

std::optional<Crossing> first_entry(const Curve& a, double a_begin, const Curve& b, double side) {
    if (is_arc(a) && a.radius_to <= same_point) return std::nullopt;
    if (is_arc(b) && b.radius_from <= same_point) return std::nullopt;
    const Points points = carrier_points(a, b);
    std::optional<Crossing> first;
    for (std::size_t i = 0; i < points.count; ++i) {
        const Vec2 p = points.p[i];
        const Crossing c{p, place_from_end(a, p), place_from_start(b, p)};
        const bool on_a = c.on_a >= a_begin - slack(a) && c.on_a <= extent(a) + slack(a);
        const bool on_b = c.on_b >= -slack(b) && c.on_b <= extent(b) + slack(b);
        if (!on_a || !on_b || (first && c.on_a >= first->on_a)) continue;
        if (side * geom::cross(direction_at(b, p), direction_at(a, p)) < -touching(a, b)) first = c;
    }
    return first;
}

Vec2 point_on(const Curve& c, double place) {
    if (!is_arc(c)) return c.from + place * direction(c);
    return c.centre + rotated(c.from - c.centre, std::copysign(place, c.sweep));
}

std::optional<Crossing> crossing_beyond(const Curve& a, const Curve& b) {
    const Points points = carrier_points(a, b);
    std::optional<Crossing> best;
    double nearest = 0;
    for (std::size_t i = 0; i < points.count; ++i) {
        const double past = past_end(a, points.p[i]), before = before_start(b, points.p[i]);
        const double away = past * scale(a) + before * scale(b);
        if (past < -slack(a) || before < -slack(b) || (best && away >= nearest)) continue;
        best = Crossing{points.p[i], extent(a) + past, -before};
        nearest = away;
    }
    return best;
}

}  // namespace obrys::path
