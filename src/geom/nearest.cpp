#include "geom/nearest.hpp"

#include <algorithm>

namespace obrys::geom {

namespace {

/// Points at which the edge may come nearest to another edge: its ends, and for arcs those on the line through
/// `towards`.
struct Candidates {
    std::array<Vec2, 5> points;
    std::size_t count = 0;
    void add(Vec2 p) { points[count++] = p; }
};

Candidates candidates(const Edge& e, const Edge& f) {
    Candidates c;
    c.add(e.a);
    c.add(e.b);
    const bool curved = is_arc(e), round = is_arc(f);
    if (round) c.add(nearest(e, circle(f).centre));
    if (!curved) return c;
    const Circle k = circle(e);
    if (round) {  // the far one of the two points on the line of centres, where one circle lies in the other
        const Vec2 u = k.centre - circle(f).centre;
        if (const double l = length(u); l > 0) c.add(nearest(e, k.centre + (k.radius / l) * u));
    } else {
        c.add(nearest(e, nearest(f, k.centre)));
    }
    return c;
}

/// Of places equally near the first counts: rounding is not to decide.
constexpr double alike = 1e-9;

void take(Gap& best, Vec2 a, Vec2 b) {
    if (const double l = distance(a, b); l < best.length - alike) best = {a, b, l};
}

}  // namespace

Gap nearest_points(const Edge& e, const Edge& f) {
    Gap best;
    const Candidates on_e = candidates(e, f), on_f = candidates(f, e);
    for (std::size_t i = 0; i < on_e.count; ++i) take(best, on_e.points[i], nearest(f, on_e.points[i]));
    for (std::size_t i = 0; i < on_f.count; ++i) take(best, nearest(e, on_f.points[i]), on_f.points[i]);
    return best;
}

double distance(const Box& a, const Box& b) {
    const double dx = std::max({0.0, a.lo.x - b.hi.x, b.lo.x - a.hi.x});
    const double dy = std::max({0.0, a.lo.y - b.hi.y, b.lo.y - a.hi.y});
    return std::hypot(dx, dy);
}

Gap nearest_points(const std::vector<Edge>& a, const std::vector<Edge>& b) {
    std::vector<Box> boxes;
    Box all;
    boxes.reserve(b.size());
    for (const Edge& f : b) {
        boxes.push_back(box(f));
        all.add(boxes.back());
    }
    Gap best;
    for (const Edge& e : a) {
        const Box around = box(e);
        if (distance(around, all) > best.length) continue;
        for (std::size_t j = 0; j < b.size(); ++j) {
            if (distance(around, boxes[j]) >= best.length) continue;
            if (const Gap g = nearest_points(e, b[j]); g.length < best.length - alike) best = g;
        }
    }
    return best;
}

}  // namespace obrys::geom
