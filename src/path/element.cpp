#include "path/element.hpp"

#include <cmath>

namespace obrys::path {

using geom::Vec2;

Vec2 rotated(Vec2 v, double angle) {
    const double c = std::cos(angle), s = std::sin(angle);
    return {c * v.x - s * v.y, s * v.x + c * v.y};
}

bool hardly_moves_in_plane(const Element& e) {
    if (is_arc(e)) return planar_length(e) > same_point && geom::distance(e.from, e.centre) > same_point;
    return geom::distance(e.from, e.to) > same_point;
}

namespace {

Vec2 tangent_at(Vec2 p, Vec2 centre, double sweep) {
    const Vec2 radial = p - centre;
    return (std::copysign(1.0, sweep) / geom::length(radial)) * geom::left_of(radial);
}

Vec2 line_direction(const Element& e) { return (1.0 / geom::distance(e.from, e.to)) * (e.to - e.from); }

}  // namespace

Vec2 start_direction(const Element& e) { return is_arc(e) ? tangent_at(e.from, e.centre, e.sweep) : line_direction(e); }

Vec2 end_direction(const Element& e) { return is_arc(e) ? tangent_at(e.to, e.centre, e.sweep) : line_direction(e); }

double planar_length(const Element& e) {
    if (!is_arc(e)) return geom::distance(e.from, e.to);
    return std::abs(e.sweep) * 0.5 * (geom::distance(e.from, e.centre) + geom::distance(e.to, e.centre));
}

Vec2 point_at(const Element& e, double fraction) {
    if (!is_arc(e)) return e.from + fraction * (e.to - e.from);
    const Vec2 radial = e.from - e.centre;
    const double start = geom::length(radial), end = geom::distance(e.to, e.centre);
    const double scale = start > 0 ? 1 + fraction * (end - start) / start : 0;
    return e.centre + scale * rotated(radial, fraction * e.sweep);
}

double turn_between(Vec2 a, Vec2 b) { return std::atan2(geom::cross(a, b), geom::dot(a, b)); }

Element line(Vec2 from, Vec2 to, double w) {
    Element e;
    e.from = from;
    e.to = to;
    e.w_from = e.w_to = w;
    return e;
}

Element arc(Vec2 from, Vec2 centre, double sweep, double w) {
    Element e = line(from, centre + rotated(from - centre, sweep), w);
    e.centre = centre;
    e.sweep = sweep;
    return e;
}

}  // namespace obrys::path
