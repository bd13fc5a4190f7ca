#include "path/compensation/contour_loop.hpp"

#include <algorithm>
#include <cmath>

namespace obrys::path {

using geom::Vec2;
using Role = Item::Role;

namespace {

/// Angle about the element's centre from p to q in the sense of its sweep, 0 … 2π.
double angle_between(const Element& e, Vec2 p, Vec2 q) {
    const double a = std::copysign(1.0, e.sweep) * turn_between(p - e.centre, q - e.centre);
    return a < 0 ? a + 2 * geom::pi : a;
}

/// Area between `about` and the element from p to q, mm2, positive counter-clockwise.
double area_to(const Element& e, Vec2 p, Vec2 q, double angle, Vec2 about) {
    const double triangle = 0.5 * geom::cross(p - about, q - about);
    if (!is_arc(e)) return triangle;
    const double r = geom::distance(e.from, e.centre);
    return triangle + std::copysign(0.5 * r * r * (angle - std::sin(angle)), e.sweep);
}

Vec2 touched(const Item& item, Vec2 centre) {
    return item.role == Role::transition ? item.e.centre : nearest_point(item.e, centre);
}

}  // namespace

Vec2 nearest_point(const Element& e, Vec2 p) {
    if (!is_arc(e)) {
        const Vec2 d = e.to - e.from;
        return e.from + std::clamp(geom::dot(p - e.from, d) / geom::dot(d, d), 0.0, 1.0) * d;
    }
    const Vec2 radial = p - e.centre;
    const double away = geom::length(radial);
    if (away > 0 && angle_between(e, e.from, p) <= std::abs(e.sweep))
        return e.centre + (geom::distance(e.from, e.centre) / away) * radial;
    return geom::distance(p, e.from) < geom::distance(p, e.to) ? e.from : e.to;
}

bool is_pocket(const Chain& chain, Vec2 centre) {
    double area = 0;
    for (const Item* item : chain) {
        if (item->role == Role::transition) continue;
        const Element& e = item->e;
        const bool first = item == chain.front(), last = item == chain.back();
        const Vec2 p = first ? touched(*item, centre) : e.from, q = last ? touched(*item, centre) : e.to;
        const double angle = first || last ? angle_between(e, p, q) : std::abs(e.sweep);
        area += area_to(e, p, q, angle, centre);
    }
    return area * chain.front()->d1 > 0;
}

bool meets_itself(const Chain& chain) {
    std::vector<Curve> curves;
    for (const Item* item : chain)
        if (item->role != Role::transition) curves.push_back(parallel(item->e, 0, 0));
    for (std::size_t i = 0; i < curves.size(); ++i)
        for (std::size_t k = i + 2; k < curves.size(); ++k)
            if (crossing_within(curves[i], 0, curves[k])) return true;
    return false;
}

}  // namespace obrys::path
