#include "path/corner.hpp"

#include <cmath>

#include "path/curve.hpp"

namespace obrys::path {

using geom::Vec2;

namespace {

/// Changes of direction below this are tangential, within this of half a turn a reversal, rad.
constexpr double angle_tolerance = 1e-9;

CornerFailure check(const Element& a, const Element& b, double size) {
    if (!(size > 0) || !std::isfinite(size)) return CornerFailure::bad_size;
    if (!moves_in_plane(a) || !moves_in_plane(b)) return CornerFailure::too_short;
    if (geom::distance(a.to, b.from) > 1e-6) return CornerFailure::not_joined;
    const double turn = std::abs(turn_between(end_direction(a), start_direction(b)));
    if (turn < angle_tolerance) return CornerFailure::tangential;
    if (turn > geom::pi - angle_tolerance) return CornerFailure::reversal;
    return CornerFailure::none;
}

CornerResult failed(const Element& a, const Element& b, CornerFailure f) { return {f, a, {}, b}; }

/// Places (mm or rad) to which a is kept and from which b is kept.
CornerResult cut(const Element& a, double keep_to, const Element& b, double keep_from, Vec2 end, Vec2 start) {
    CornerResult r;
    r.first = a;
    r.second = b;
    r.first.to = end;
    r.second.from = start;
    if (is_arc(a)) r.first.sweep = std::copysign(keep_to, a.sweep);
    if (is_arc(b)) r.second.sweep = std::copysign(std::abs(b.sweep) - keep_from, b.sweep);
    r.inserted = line(end, start, a.w_to);
    r.inserted.tag = a.tag;
    return r;
}

/// Place at straight distance `c` from the start (or, mirrored, from the end); beyond the element where there is none.
double place_at_chord(const Element& e, Vec2 corner, double c) {
    if (!is_arc(e)) return c;
    const double diameter = 2 * geom::distance(corner, e.centre);
    return c > diameter ? 3 * geom::pi : 2 * std::asin(c / diameter);
}

double whole(const Element& e) { return is_arc(e) ? std::abs(e.sweep) : planar_length(e); }

/// The point `place` mm or rad after the start of e.
Vec2 at_place(const Element& e, double place) { return point_at(e, place / whole(e)); }

/// Straight distance between the points `leg` from the corner; the chamfer's length.
double chamfer_length(const Element& a, const Element& b, double leg) {
    const Vec2 end = at_place(a, whole(a) - place_at_chord(a, a.to, leg));
    return geom::distance(end, at_place(b, place_at_chord(b, b.from, leg)));
}

double longest_leg(const Element& e, Vec2 corner) {
    if (!is_arc(e)) return planar_length(e);
    const double radius = geom::distance(corner, e.centre);
    return 2 * radius * std::sin(0.5 * std::min(std::abs(e.sweep), geom::pi));
}

}  // namespace

CornerResult chamfer_by_leg(const Element& a, const Element& b, double leg) {
    if (const auto f = check(a, b, leg); f != CornerFailure::none) return failed(a, b, f);
    const double on_a = whole(a) - place_at_chord(a, a.to, leg), on_b = place_at_chord(b, b.from, leg);
    if (on_a < -same_point || on_b > whole(b) + same_point) return failed(a, b, CornerFailure::too_short);
    return cut(a, on_a, b, on_b, at_place(a, on_a), at_place(b, on_b));
}

CornerResult chamfer(const Element& a, const Element& b, double length) {
    if (const auto f = check(a, b, length); f != CornerFailure::none) return failed(a, b, f);
    const double turn = turn_between(end_direction(a), start_direction(b));
    double leg = length / (2 * std::cos(0.5 * turn));
    if (!is_arc(a) && !is_arc(b)) return chamfer_by_leg(a, b, leg);
    double low = 0, high = std::min(longest_leg(a, a.to), longest_leg(b, b.from));
    if (chamfer_length(a, b, high) < length) return failed(a, b, CornerFailure::too_short);
    for (int i = 0; i < 100 && high - low > 1e-14 * high; ++i) {
        leg = 0.5 * (low + high);
        (chamfer_length(a, b, leg) < length ? low : high) = leg;
    }
    return chamfer_by_leg(a, b, high);
}

CornerResult rounding(const Element& a, const Element& b, double radius) {
    if (const auto f = check(a, b, radius); f != CornerFailure::none) return failed(a, b, f);
    const double turn = turn_between(end_direction(a), start_direction(b));
    const double d = std::copysign(radius, turn);
    const Curve pa = parallel(a, d, d), pb = parallel(b, d, d);
    if (!exists(pa) || !exists(pb)) return failed(a, b, CornerFailure::too_short);
    const auto c = crossing_within(pa, 0, pb);
    if (!c) return failed(a, b, CornerFailure::too_short);
    CornerResult r = cut(a, c->on_a, b, c->on_b, at_place(a, c->on_a), at_place(b, c->on_b));
    r.inserted.centre = c->point;
    double sweep = turn_between(r.first.to - c->point, r.second.from - c->point);
    if (sweep * turn < 0) sweep += std::copysign(2 * geom::pi, turn);
    r.inserted.sweep = sweep;
    return r;
}

CornerResult insert_corner(const Element& a, const Element& b, CornerKind kind, double size) {
    switch (kind) {
        case CornerKind::chamfer: return chamfer(a, b, size);
        case CornerKind::chamfer_leg: return chamfer_by_leg(a, b, size);
        case CornerKind::rounding: return rounding(a, b, size);
        case CornerKind::none: break;
    }
    return failed(a, b, CornerFailure::bad_size);
}

double largest_corner(const Element& a, const Element& b, CornerKind kind, double size) {
    const auto failure = insert_corner(a, b, kind, size).failure;
    if (failure == CornerFailure::none) return size;
    if (failure != CornerFailure::too_short) return 0;
    double low = 0, high = size;
    while (high - low > 1e-9) {
        const double middle = 0.5 * (low + high);
        (insert_corner(a, b, kind, middle).ok() ? low : high) = middle;
    }
    return low;
}

}  // namespace obrys::path
