#include "geom/boolean.hpp"

#include <optional>

#include "geom/arrangement.hpp"
#include "geom/tolerance.hpp"

namespace obrys::geom {

namespace {

void add(std::vector<SourceEdge>& out, const std::vector<Contour>& contours, Windings of) {
    for (const Contour& c : contours)
        for (const Edge& e : edges(c)) out.push_back({.edge = e, .of = of});
}

/// `clean`: both sets bound clean regions.
Region combine(const std::vector<SourceEdge>& sources, bool clean, Arrangement::Inside inside) {
    // A graph whose windings contradict each other is made anew with a coarser weld.
    std::optional<Region> second_best;
    for (double tolerance = snap;; tolerance *= 3) {
        Arrangement graph(sources, {.tolerance = tolerance});
        graph.label();
        const bool good = graph.consistent() && (!clean || graph.windings_within(0, 1)), last = tolerance > 1e-6;
        if (good || (last && !second_best)) return graph.region(inside);
        if (last) return *second_best;
        if (graph.consistent() && !second_best) second_best = graph.region(inside);
    }
}

Region combine(const Region& a, const Region& b, Arrangement::Inside inside) {
    std::vector<SourceEdge> sources;
    add(sources, a.contours, {1, 0});
    add(sources, b.contours, {0, 1});
    return combine(sources, true, inside);
}

}  // namespace

Region unite(const Region& a, const Region& b) {
    return combine(a, b, [](Windings w) { return w.a > 0 || w.b > 0; });
}
Region subtract(const Region& a, const Region& b) {
    return combine(a, b, [](Windings w) { return w.a > 0 && w.b <= 0; });
}
Region intersect(const Region& a, const Region& b) {
    if (!overlap(box(a), box(b))) return {};
    return combine(a, b, [](Windings w) { return w.a > 0 && w.b > 0; });
}

Region positive(const std::vector<Contour>& contours) {
    std::vector<SourceEdge> sources;
    add(sources, contours, {1, 0});
    return combine(sources, false, [](Windings w) { return w.a > 0; });
}

Region tidied(const std::vector<Contour>& contours) {
    std::vector<SourceEdge> sources;
    add(sources, contours, {1, 0});
    return combine(sources, false, [](Windings w) { return w.a % 2 != 0; });
}

std::vector<Region> pieces(const Region& r) {
    std::vector<Region> out;
    std::vector<double> areas;
    for (const Contour& c : r.contours)
        if (const double a = area(c); a > 0) {
            out.push_back({{c}});
            areas.push_back(a);
        }
    for (const Contour& c : r.contours) {
        if (area(c) > 0) continue;
        // The smallest outer contour about the middle of one of the hole's edges; the middle, since corners may touch.
        const Vec2 p = point_at(edges(c).front(), 0.5);
        std::size_t best = out.size();
        for (std::size_t i = 0; i < out.size(); ++i)
            if (contains({{out[i].contours.front()}}, p) && (best == out.size() || areas[i] < areas[best])) best = i;
        if (best < out.size()) out[best].contours.push_back(c);
    }
    return out;
}

}  // namespace obrys::geom
