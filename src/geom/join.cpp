#include <cmath>

#include "geom/arrangement.hpp"
#include "geom/tolerance.hpp"

namespace obrys::geom {

bool join_edges(const Edge& first, const Edge& second, Edge& result) {
    const bool curved = is_arc(first);
    if (curved != is_arc(second) || first.a == second.b) return false;
    result = {first.a, second.b, 0};
    if (!curved) {
        const Vec2 d = result.b - result.a;
        const double l = length(d);
        return std::abs(cross(d, first.b - first.a)) <= join * l && dot(d, first.b - first.a) > 0 &&
               dot(d, second.b - second.a) > 0;
    }
    const double sweep = sweep_angle(first) + sweep_angle(second);
    if ((first.bulge > 0) != (second.bulge > 0) || std::abs(sweep) > 1.5 * pi) return false;
    result.bulge = std::tan(0.25 * sweep);
    // One circle: the corner and the middles of both parts lie on the joined arc.
    const Circle c = circle(result);
    for (const Vec2 p : {first.b, point_at(first, 0.5), point_at(second, 0.5)})
        if (std::abs(distance(c.centre, p) - c.radius) > join) return false;
    return true;
}

std::vector<Edge> joined(const std::vector<Edge>& chain, bool closed) {
    std::vector<Edge> out;
    out.reserve(chain.size());
    Edge one;
    for (const Edge& e : chain) {
        if (!out.empty() && join_edges(out.back(), e, one))
            out.back() = one;
        else
            out.push_back(e);
    }
    while (closed && out.size() > 2 && join_edges(out.back(), out.front(), one)) {
        out.front() = one;
        out.pop_back();
    }
    return out;
}

}  // namespace obrys::geom
