/// Onto the contour and off it: NORM and KONT of compensation.hpp.

#include <cmath>

#include "path/compensation/join.hpp"

namespace obrys::path {

using geom::Vec2;

namespace {

/// The way round a contour point between a point off the contour and the element that begins or ends there.
struct Around {
    Vec2 direction;   ///< of the straight part, in the sense of motion
    double turn = 0;  ///< from the straight part to the element, or back; its sign is that of -d
};

/// `off` as seen from the contour point, `tangent` of the contour there, both in the sense of motion seen forwards
/// (entering) or backwards (leaving: mirrored by the caller). Nothing where the way is straight.
std::optional<Around> way_round(Vec2 off, Vec2 tangent, double d) {
    const double distance = geom::length(off);
    if (d * geom::cross(tangent, off) >= 0 || distance <= std::abs(d) + same_point) return std::nullopt;
    const double straight = std::sqrt((distance - std::abs(d)) * (distance + std::abs(d)));
    Around w;
    w.direction = rotated((-1.0 / distance) * off, std::atan2(d, straight));
    w.turn = turn_between(w.direction, tangent);
    if (w.turn * d > 0) w.turn -= std::copysign(2 * geom::pi, d);
    return w;
}

/// The crossing of the straight part's prolongation with that of the contour's parallel, where G451 asks for it.
std::optional<Crossing> corner_point(const Item& a, const Item& b, const Setting& s, double turn) {
    if (s.corner != OuterCorner::intersection || std::abs(turn) > s.corner_limit) return std::nullopt;
    return crossing_beyond(a.curve, b.curve);
}

/// The line whose parallel is the straight part of the way round.
Item straight_part(Vec2 from, Vec2 to, double d) {
    Item item;
    item.e = line(from, to);
    item.curve = parallel(item.e, d, d);
    return item;
}

}  // namespace

Join join_approach(const Item& a, const Item& b) {
    Join j;
    const Vec2 corner = b.e.from;
    j.a_end = j.b_start = b.curve.from;
    if (a.s.approach == Approach::ready) {
        j.a_end = a.e.to;
        j.a_place = std::abs(a.e.sweep);
    }
    if (a.s.approach != Approach::around) return j;
    const auto way = way_round(a.start - corner, start_direction(b.e), b.d0);
    if (!way) return j;
    const Item straight = straight_part(a.start - b.d0 * geom::left_of(way->direction), corner, b.d0);
    if (const auto c = corner_point(straight, b, a.s, way->turn)) {
        j.a_end = j.b_start = c->point;
        j.b_place = c->on_b;
        return j;
    }
    j.a_end = straight.curve.to;
    insert_arc(j, corner, way->turn, a, b);
    return j;
}

Join join_retract(const Item& a, const Item& b) {
    Join j;
    const Vec2 corner = a.e.to;
    j.a_end = j.b_start = a.curve.to;
    j.a_place = extent(a.curve);
    if (b.s.approach != Approach::around) return j;
    // Seen backwards the tool stands on the other side and the motion turns the other way.
    const auto way = way_round(b.e.to - corner, -end_direction(a.e), -a.d1);
    if (!way) return j;
    const Vec2 direction = -way->direction;
    const Item straight = straight_part(corner, b.e.to - a.d1 * geom::left_of(direction), a.d1);
    if (const auto c = corner_point(a, straight, b.s, way->turn)) {
        j.a_end = j.b_start = c->point;
        j.a_place = c->on_a;
        return j;
    }
    j.b_start = straight.curve.from;
    insert_arc(j, corner, -way->turn, a, b);
    return j;
}

}  // namespace obrys::path
