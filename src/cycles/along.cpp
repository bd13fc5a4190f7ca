#include "cycles/along.hpp"

#include <algorithm>
#include <cmath>

#include "geom/nearest.hpp"

namespace obrys::cycles {

namespace {

constexpr double one_distance = 1e-4;  ///< mm that a stretch along an element may come nearer or go farther
constexpr double alike = 1e-9;         ///< mm; rounding is not to decide between elements that meet
constexpr std::size_t few = 4;         ///< elements of a leaf
constexpr double shortest = 1e-9;      ///< mm; below that it is a point

}  // namespace

Along::Along(std::vector<geom::Edge> elements) : elements_(std::move(elements)), order_(elements_.size()) {
    for (std::size_t i = 0; i < order_.size(); ++i) order_[i] = i;
    if (!elements_.empty()) build(0, 0, elements_.size());
}

void Along::build(std::size_t node, std::size_t first, std::size_t last) {
    if (nodes_.size() <= node) nodes_.resize(node + 1);
    Node made{{}, first, last};
    for (std::size_t i = first; i < last; ++i) made.box.add(geom::box(elements_[order_[i]]));
    nodes_[node] = made;
    if (last - first <= few) return;
    const geom::Vec2 size = made.box.hi - made.box.lo;
    const std::size_t middle = first + (last - first) / 2;
    const auto begin = order_.begin();
    const auto at = [&](std::size_t i) { return begin + static_cast<std::ptrdiff_t>(i); };
    std::nth_element(at(first), at(middle), at(last), [&](std::size_t a, std::size_t b) {
        const geom::Vec2 p = geom::point_at(elements_[a], 0.5), q = geom::point_at(elements_[b], 0.5);
        return size.x > size.y ? p.x < q.x : p.y < q.y;
    });
    build(2 * node + 1, first, middle);
    build(2 * node + 2, middle, last);
}

void Along::search(std::size_t node, geom::Vec2 p, Nearest& best) const {
    const Node& n = nodes_[node];
    const geom::Box here{p, p};
    if (geom::distance(n.box, here) > best.distance + alike) return;
    if (n.last - n.first > few) {
        const std::size_t a = 2 * node + 1, b = 2 * node + 2;
        const bool swap = geom::distance(nodes_[b].box, here) < geom::distance(nodes_[a].box, here);
        search(swap ? b : a, p, best);
        search(swap ? a : b, p, best);
        return;
    }
    for (std::size_t i = n.first; i < n.last; ++i) {
        const std::size_t e = order_[i];
        const double d = geom::distance(elements_[e], p);
        const bool tie = std::abs(d - best.distance) <= alike;
        if (d < best.distance - alike || (tie && e < best.element)) best = {d, e};
    }
}

std::optional<std::size_t> Along::find(const geom::Edge& stretch) const {
    if (nodes_.empty() || !(geom::length(stretch) > shortest)) return std::nullopt;
    Nearest best;
    search(0, geom::point_at(stretch, 0.5), best);
    if (!std::isfinite(best.distance)) return std::nullopt;
    const geom::Edge& e = elements_[best.element];
    for (const geom::Vec2 p : {stretch.a, stretch.b})
        if (!(std::abs(geom::distance(e, p) - best.distance) <= one_distance)) return std::nullopt;
    return best.element;
}

}  // namespace obrys::cycles
