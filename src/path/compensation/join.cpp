#include "path/compensation/join.hpp"

#include <cmath>

namespace obrys::path {

using geom::Vec2;

namespace {

/// A change of direction this close to half a turn is a reversal, rad.
constexpr double reversal = 1e-9;

Join ends_at_normals(const Item& a, const Item& b) {
    Join j;
    j.a_end = a.curve.to;
    j.a_place = extent(a.curve);
    j.b_start = b.curve.from;
    return j;
}

Join at_crossing(const Crossing& c) {
    Join j;
    j.a_end = j.b_start = c.point;
    j.a_place = c.on_a;
    j.b_place = c.on_b;
    return j;
}

/// An inner corner, or any other place where b may be reached only by cutting both elements short.
Join join_inner(const Item& a, const Item& b) {
    if (const auto c = crossing_within(a.curve, a.begin, b.curve)) {
        Join j = at_crossing(*c);
        j.trims = true;
        return j;
    }
    Join j = join_straight(a, b);
    if (geom::distance(j.a_end, j.b_start) > blend)
        j.fault = carriers_meet(a.curve, b.curve) ? Reason::element_vanishes : Reason::no_intersection;
    return j;
}

/// How far the crossing of two parallels may stand off the corner, mm: as for lines that turn by the limit.
double farthest(double d, double corner_limit) {
    return std::abs(d) / std::cos(0.5 * std::min(corner_limit, geom::pi - 1e-6)) + same_point;
}

Join join_outer(const Item& a, const Item& b, double turn) {
    if (const auto c = outer_crossing(a, b, turn)) return at_crossing(*c);
    Join j = ends_at_normals(a, b);
    insert_arc(j, a.e.to, turn, a, b);
    return j;
}

Join join_contour(const Item& a, const Item& b) {
    if (std::abs(a.d1 - b.d0) > same_point) return join_straight(a, b);
    if (geom::distance(a.e.to, b.e.from) > gap) {
        Join j = join_inner(a, b);
        j.fault.reset();
        return j;
    }
    if (geom::distance(a.curve.to, b.curve.from) <= same_point) {
        Join j = ends_at_normals(a, b);
        j.b_start = j.a_end;
        return j;
    }
    if (const auto turn = outer_turn(a, b)) return join_outer(a, b, *turn);
    return a.s.at_end == CornerEnd::open ? join_straight(a, b) : join_inner(a, b);
}

}  // namespace

std::optional<double> outer_turn(const Item& a, const Item& b) {
    const double turn = turn_between(end_direction(a.e), start_direction(b.e));
    if (std::abs(turn) > geom::pi - reversal) return std::copysign(turn, -a.d1);
    if (turn * a.d1 > 0) return std::nullopt;
    return turn;
}

std::optional<Crossing> outer_crossing(const Item& a, const Item& b, double turn) {
    const bool always = a.s.at_end == CornerEnd::crossing;
    const bool within = b.s.corner == OuterCorner::intersection && std::abs(turn) <= b.s.corner_limit;
    if (!always && !within) return std::nullopt;
    const auto c = crossing_beyond(a.curve, b.curve);
    if (c && (always || geom::distance(c->point, a.e.to) <= farthest(a.d1, b.s.corner_limit))) return c;
    return std::nullopt;
}

void insert_arc(Join& j, Vec2 corner, double sweep, const Item& a, const Item& b) {
    Element e = line(j.a_end, j.b_start);
    e.centre = corner;
    e.sweep = sweep;
    e.w_from = e.w_to = a.after.empty() ? a.e.w_to : a.after.back().w_to;
    e.tag = b.e.tag;
    j.inserted = e;
}

Join join_straight(const Item& a, const Item& b) {
    Join j = ends_at_normals(a, b);
    if (geom::distance(j.a_end, j.b_start) <= same_point) return j;
    insert_arc(j, {}, 0, a, b);
    j.link = true;
    return j;
}

Join join(const Item& a, const Item& b) {
    if (a.role == Item::Role::approach) return join_approach(a, b);
    if (b.role == Item::Role::retract) return join_retract(a, b);
    if (a.role != Item::Role::contour || b.role != Item::Role::contour) return join_straight(a, b);
    return join_contour(a, b);
}

}  // namespace obrys::path
