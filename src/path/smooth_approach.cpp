#include "path/smooth_approach.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace obrys::path {

using geom::Vec2;

namespace {

/// The contour's end in terms of the centre.
struct Frame {
    Vec2 point;       ///< compensated P_A
    Vec2 along;       ///< unit direction of motion
    double d = 0;     ///< offset, mm, positive left
    double side = 1;  ///< +1 the tool is left of the motion, -1 right
};

bool finite(Vec2 p) { return std::isfinite(p.x) && std::isfinite(p.y); }

Frame frame_of(const ContourEnd& c) {
    Frame f;
    f.along = (1.0 / geom::length(c.direction)) * c.direction;
    f.d = c.side == Side::off ? 0 : c.side == Side::left ? c.tool_radius : -c.tool_radius;
    f.side = c.side == Side::left ? 1 : -1;
    if (f.d != 0) f.side = std::copysign(1.0, f.d);  // a negative radius changes the side
    f.point = c.at + f.d * geom::left_of(f.along);
    return f;
}

SmoothFailure check(const OuterEnd& outer, const ContourEnd& c, const SmoothShape& s) {
    const bool arc = s.kind == SmoothKind::tangent_arc || s.kind == SmoothKind::arc_and_line;
    const double sizes = arc ? s.radius + (s.kind == SmoothKind::tangent_arc ? s.angle : 0) : s.length;
    if (!finite(outer.at) || !finite(c.at) || !finite(c.direction)) return SmoothFailure::not_a_number;
    if (!std::isfinite(outer.w + c.w + c.tool_radius + sizes)) return SmoothFailure::not_a_number;
    if (geom::length(c.direction) <= 0) return SmoothFailure::bad_direction;
    if (!arc) return s.length > 0 ? SmoothFailure::none : SmoothFailure::bad_length;
    if (s.radius == 0 || (s.kind == SmoothKind::arc_and_line && s.radius < 0)) return SmoothFailure::bad_radius;
    const bool angle_fits = s.angle > 0 && s.angle <= geom::full_turn + 1e-12;
    if (s.kind == SmoothKind::tangent_arc && !angle_fits) return SmoothFailure::bad_angle;
    return SmoothFailure::none;
}

/// Radius of the centre's arc that turns to `turn` (+1 left); negative where the tool does not fit inside.
double centre_radius(const Frame& f, const SmoothShape& s, double turn) {
    const double radius = std::abs(s.radius);
    return s.arc_of == ArcOf::centre ? radius : radius - turn * f.d;
}

/// Angle from `from` to `to` in the sense of `turn`, 0 … 2π; a full turn less rounding is 0.
double angle_to(Vec2 from, Vec2 to, double turn) {
    const double a = turn * turn_between(from, to);
    return a < -1e-12 ? a + geom::full_turn : std::max(a, 0.0);
}

/// The part that touches the contour, as the path of the centre towards it, and P_H; empty where it shrinks to a point.
struct Onto {
    SmoothFailure failure = SmoothFailure::none;
    Vec2 auxiliary;
    std::vector<Element> element{};
};

Onto along_line(const Frame& f, Vec2 auxiliary) { return {SmoothFailure::none, auxiliary, {line(auxiliary, f.point)}}; }

/// Arc of the centre that ends in the contour's point; `turn` its sense, `sweep` its size.
Onto along_arc(const Frame& f, double radius, double turn, double sweep) {
    const Vec2 centre = f.point + turn * radius * geom::left_of(f.along);
    const Vec2 from = centre + rotated(f.point - centre, -turn * sweep);
    if (radius * sweep <= same_point) return {SmoothFailure::none, from, {}};
    Element e = line(from, f.point);
    e.centre = centre;
    e.sweep = turn * sweep;
    return {SmoothFailure::none, from, {e}};
}

Onto tangent_arc(const Frame& f, const SmoothShape& s) {
    const double turn = s.radius > 0 ? f.side : -f.side;
    const double radius = centre_radius(f, s, turn);
    if (radius < -same_point) return {SmoothFailure::tool_too_large, {}, {}};
    return along_arc(f, std::max(radius, 0.0), turn, std::min(s.angle, geom::full_turn));
}

Onto arc_and_line(const Frame& f, const SmoothShape& s, Vec2 outer) {
    const double off = geom::cross(f.along, outer - f.point);
    if (std::abs(off) <= same_point && geom::dot(f.along, outer - f.point) <= 0)
        return {SmoothFailure::none, f.point, {}};  // P_S lies on the tangent: straight on
    const double turn = std::abs(off) <= same_point ? f.side : std::copysign(1.0, off);
    const double radius = centre_radius(f, s, turn);
    if (radius < -same_point) return {SmoothFailure::tool_too_large, {}, {}};
    if (radius <= same_point) return {SmoothFailure::none, f.point, {}};
    const Vec2 centre = f.point + turn * radius * geom::left_of(f.along), to_centre = centre - outer;
    const double distance = geom::length(to_centre);
    if (distance < radius - same_point) return {SmoothFailure::inside_of_circle, {}, {}};
    const double tangent = std::sqrt(std::max(0.0, (distance - radius) * (distance + radius)));
    const Vec2 u = rotated((1.0 / distance) * to_centre, -turn * std::atan2(radius, tangent));
    const Vec2 touch = centre - turn * radius * geom::left_of(u);
    return along_arc(f, radius, turn, angle_to(touch - centre, f.point - centre, turn));
}

Onto onto(const Frame& f, const SmoothShape& s, Vec2 outer) {
    switch (s.kind) {
        case SmoothKind::tangent_line: return along_line(f, f.point - s.length * f.along);
        case SmoothKind::normal_line: return along_line(f, f.point + f.side * s.length * geom::left_of(f.along));
        case SmoothKind::tangent_arc: return tangent_arc(f, s);
        case SmoothKind::arc_and_line: return arc_and_line(f, s, outer);
    }
    return {};
}

void add(std::vector<Element>& path, Element e, double w_from, double w_to) {
    e.w_from = w_from;
    e.w_to = w_to;
    if (moves(e)) path.push_back(std::move(e));
}

Element reversed(Element e) {
    std::swap(e.from, e.to);
    std::swap(e.w_from, e.w_to);
    e.sweep = -e.sweep;
    return e;
}

}  // namespace

SmoothPath smooth_approach(const OuterEnd& start, const ContourEnd& contour, const SmoothShape& shape) {
    SmoothPath r;
    r.failure = check(start, contour, shape);
    if (!r.ok()) return r;
    const Frame f = frame_of(contour);
    const Onto part = onto(f, shape, start.at);
    r.failure = part.failure;
    if (!r.ok()) return r;
    r.auxiliary = part.auxiliary;
    r.contour = f.point;
    const double early = shape.w_move == WMove::outside ? contour.w : start.w;
    const double late = shape.w_move == WMove::at_auxiliary ? start.w : contour.w;
    add(r.path, line(start.at, start.at), start.w, early);
    add(r.path, line(start.at, part.auxiliary), early, late);
    add(r.path, line(part.auxiliary, part.auxiliary), late, contour.w);
    for (const Element& e : part.element) add(r.path, e, contour.w, contour.w);
    return r;
}

/// Seen backwards a departure is an approach from P_N with the tool on the other side.
SmoothPath smooth_departure(const ContourEnd& contour, const OuterEnd& end, const SmoothShape& shape) {
    ContourEnd back = contour;
    back.direction = -contour.direction;
    back.side = contour.side == Side::left ? Side::right : Side::left;
    if (contour.side == Side::off) back.tool_radius = 0;
    OuterEnd outer = end;
    const bool has_target = shape.kind == SmoothKind::arc_and_line;
    if (!has_target) outer.at = contour.at;
    SmoothPath r = smooth_approach(outer, back, shape);
    if (!r.ok()) return r;
    if (!has_target) {
        outer.at = r.auxiliary;
        r = smooth_approach(outer, back, shape);
    }
    std::reverse(r.path.begin(), r.path.end());
    for (Element& e : r.path) e = reversed(std::move(e));
    return r;
}

}  // namespace obrys::path
