/// Source: Siemens, NC programming 12/2019 (6FC5398-2EP40-0BA0), p. 269: DISC=0 the transition circle, DISC=100 the
/// crossing of the equidistant paths. That it is the conic with its middle in proportion is our reading [-].

#include "path/pulled_corner.hpp"

#include <cmath>

#include "path/arc_input.hpp"

namespace obrys::path {

using geom::Vec2;

namespace {

constexpr double allowed = 1e-4;                        ///< mm beside the conic
constexpr int most_halvings = 10;                       ///< of its parameter
constexpr double half_turn = geom::pi - geom::pi / 90;  ///< from here on the crossing lies too far out, rad

/// Quadratic curve with a weight on its middle point.
struct WeightedConic {
    Vec2 start, middle, end;
    double weight = 1;

    [[nodiscard]] Vec2 at(double t) const {
        const double a = (1 - t) * (1 - t), b = 2 * weight * t * (1 - t), c = t * t;
        return 1 / (a + b + c) * (a * start + b * middle + c * end);
    }
};

/// The arc from a by way of m to b; a line where they lie on one.
Element through(Vec2 a, Vec2 m, Vec2 b) {
    Element e = line(a, b);
    const Vec2 u = m - a, v = b - a;
    const double area = 2 * geom::cross(u, v);
    if (std::abs(area) < 1e-12) return e;
    const double uu = geom::dot(u, u), vv = geom::dot(v, v);
    e.centre = a + 1 / area * Vec2{v.y * uu - u.y * vv, u.x * vv - v.x * uu};
    e.sweep = turn_between(a - e.centre, b - e.centre);
    return e;
}

double beside(const Element& e, Vec2 p) {
    if (is_arc(e)) return std::abs(geom::distance(p, e.centre) - geom::distance(e.from, e.centre));
    const Vec2 d = e.to - e.from;
    const double length = geom::length(d);
    return length > 0 ? std::abs(geom::cross(d, p - e.from)) / length : geom::distance(p, e.from);
}

void add(const WeightedConic& c, double from, double to, int halvings, std::vector<Element>& out) {
    const double mid = 0.5 * (from + to);
    const Element e = through(c.at(from), c.at(mid), c.at(to));
    const double off = std::max(beside(e, c.at(0.5 * (from + mid))), beside(e, c.at(0.5 * (mid + to))));
    if (off <= allowed || halvings == 0) return out.push_back(e);
    add(c, from, mid, halvings - 1, out);
    add(c, mid, to, halvings - 1, out);
}

}  // namespace

std::vector<Element> pulled_corner(const Element& arc, double part) {
    const double half = 0.5 * std::abs(arc.sweep), radius = geom::distance(arc.from, arc.centre);
    if (!is_arc(arc) || !(part > 0) || 2 * half >= half_turn || radius <= same_point) return {arc};
    const double chord = radius * std::cos(half), crossing = radius / std::cos(half);
    const Vec2 out = 1 / radius * (point_at(arc, 0.5) - arc.centre);
    const double top = radius + std::min(part, 1.0) * (crossing - radius);
    const Vec2 corner = arc.centre + crossing * out;
    std::vector<Element> way;
    if (crossing - top <= allowed) {
        way = {line(arc.from, corner), line(corner, arc.to)};
    } else {
        const WeightedConic c{arc.from, corner, arc.to, (top - chord) / (crossing - top)};
        add(c, 0, 0.5, most_halvings, way);
        add(c, 0.5, 1, most_halvings, way);
    }
    for (Element& e : way) {
        e.w_from = e.w_to = arc.w_to;
        e.tag = arc.tag;
    }
    way.front().before = arc.before;
    way.back().to = arc.to;
    return way;
}

}  // namespace obrys::path
