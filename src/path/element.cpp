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

Vec2 across(Vec2 radial, double sweep) {
    return (std::copysign(1.0, sweep) / geom::length(radial)) * geom::left_of(radial);
}

Vec2 along(Vec2 way) { return (1.0 / geom::length(way)) * way; }

}  // namespace

Vec2 start_direction(const Element& e) { return is_arc(e) ? across(e.from - e.centre, e.sweep) : along(e.to - e.from); }

Vec2 end_direction(const Element& e) { return EndDirection(e).get(); }

Vec2 EndDirection::get() const {
    if (!of_element_) return way_;
    return sweep_ != 0 ? across(way_, sweep_) : along(way_);
}

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

Element line(Vec2 from, Vec2 to, double w) { return {from, to, w, w, {}, 0, 0, {}}; }

Element arc(Vec2 from, Vec2 centre, double sweep, double w) {
    Element e = line(from, centre + rotated(from - centre, sweep), w);
    e.centre = centre;
    e.sweep = sweep;
    return e;
}

}  // namespace obrys::path
