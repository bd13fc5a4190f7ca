// What lies at nodes and edges of halved cells.

#include <algorithm>
#include <cmath>

#include "base/parallel.hpp"
#include "sim/milling/exact/coarse.hpp"
#include "sim/milling/surface/fine.hpp"

namespace obrys::sim::milling {

namespace {

using geom::Vec3;

Place corner_of(const Leaf& leaf, int c) {
    return {leaf.at[0] + (c & 1) * leaf.size, leaf.at[1] + (c >> 1 & 1) * leaf.size, leaf.at[2] + (c >> 2) * leaf.size};
}

Place end_of(const ShortEdge& e) {
    Place p = e.at;
    p[static_cast<std::size_t>(e.axis)] += e.size;
    return p;
}

}  // namespace

bool Fine::is_material(const Place& p) const {
    const std::int32_t unit = leaves_.unit();
    if (p[0] % unit == 0 && p[1] % unit == 0 && p[2] % unit == 0)
        return nodes_.material(p[0] / unit, p[1] / unit, p[2] / unit);
    return signs_.find(key_of(p)) == 1;
}

bool Fine::is_special(const Leaf& leaf) const { return fine_cells_.find(key_of(leaves_.cell_of(leaf.at))) == 1; }

void Fine::each_edge_of(const Leaf& leaf, base::FunctionRef<void(const ShortEdge&)> take) const {
    for (int axis = 0; axis < 3; ++axis)
        for (int side = 0; side < 4; ++side) {
            ShortEdge e{leaf.at, leaf.size, axis};
            e.at[static_cast<std::size_t>(first_across(axis))] += (side & 1) * leaf.size;
            e.at[static_cast<std::size_t>(second_across(axis))] += (side >> 1) * leaf.size;
            take(e);
        }
}

/// Material ends within the lattice; a stock's mesh that crosses itself claims there is some beyond.
bool Fine::is_outermost(const Place& p) const {
    for (std::size_t a = 0; a < 3; ++a)
        if (p[a] <= 0 || p[a] >= (lattice_.count[a] - 1) * leaves_.unit()) return true;
    return false;
}

/// The nodes of leaves that are new. What one cell finds of a node on its rim, its neighbours find, too: a sign follows
/// from the node's coordinates alone.
void Fine::find_signs() {
    std::vector<std::vector<Place>> wanted(dirty_.size());
    KeyMap asked;
    const std::int32_t unit = leaves_.unit();
    for (std::size_t n = 0; n < dirty_.size(); ++n)
        leaves_.each_leaf(dirty_[n], [&](const Leaf& leaf) {
            for (int c = 0; c < 8; ++c) {
                const Place p = corner_of(leaf, c);
                if (p[0] % unit == 0 && p[1] % unit == 0 && p[2] % unit == 0) continue;
                if (signs_.find(key_of(p)) != KeyMap::none) continue;
                const std::size_t before = asked.size();
                asked.add(key_of(p), 1);
                if (asked.size() > before) wanted[n].push_back(p);
            }
        });
    std::vector<std::vector<std::uint8_t>> found(dirty_.size());
    base::for_all(dirty_.size(), [&](std::size_t n) {
        if (wanted[n].empty()) return;
        const Near near = exact_.near(dirty_[n], false);
        for (const Place& p : wanted[n])
            found[n].push_back(!is_outermost(p) && exact_.is_material(near, leaves_.node(p)) ? 1 : 0);
    });
    for (std::size_t n = 0; n < dirty_.size(); ++n)
        for (std::size_t i = 0; i < wanted[n].size(); ++i) signs_.add(key_of(wanted[n][i]), found[n][i]);
}

bool Fine::is_narrow(const std::vector<LineEnd>& ends, const ShortEdge& e) const {
    const double low = component(leaves_.node(e.at), e.axis), high = component(leaves_.node(end_of(e)), e.axis);
    for (std::size_t i = 1; i < ends.size(); ++i) {
        const LineEnd &a = ends[i - 1], &b = ends[i];
        if (a.at < low || b.at > high) continue;
        Vec3 p = leaves_.node(e.at), q = p;
        set_component(p, e.axis, a.at);
        set_component(q, e.axis, b.at);
        const Vec3 one = exact_.normal(a.cut, p), other = exact_.normal(b.cut, q);
        if (!is_worth(one, other, e.axis, b.at - a.at, tolerance_)) continue;
        if (is_small(e.size) && to_tip(one, other, e.axis, b.at - a.at) < 2 * (high - low)) continue;
        return true;
    }
    return false;
}

Fine::Known Fine::look(const Near& near, const ShortEdge& e) const {
    const Vec3 from = leaves_.node(e.at);
    const double low = component(from, e.axis), high = component(leaves_.node(end_of(e)), e.axis);
    std::vector<LineEnd> ends;
    exact_.ends(near, e.axis, from, high, ends);
    Known known;
    known.size = e.size;
    known.narrow = is_narrow(ends, e);
    const bool rising = !is_material(e.at);
    if (rising != is_material(end_of(e))) return known;
    const double middle = 0.5 * (low + high);
    const LineEnd* best = nullptr;
    for (const LineEnd& end : ends)
        if (end.rising == rising && (best == nullptr || std::abs(end.at - middle) < std::abs(best->at - middle)))
            best = &end;
    known.crossing.at = best != nullptr ? best->at : middle;
    if (best == nullptr) return known;
    known.crossing.cut = best->cut;
    Vec3 p = from;
    set_component(p, e.axis, best->at);
    const Vec3 n = exact_.normal(best->cut, p);
    if (is_finite(n))
        known.crossing.normal = {static_cast<float>(n.x), static_cast<float>(n.y), static_cast<float>(n.z)};
    return known;
}

const Fine::Known* Fine::known(const ShortEdge& e) const {
    const std::uint32_t n = known_of_[static_cast<std::size_t>(e.axis)].find(key_of(e.at));
    return n == KeyMap::none || known_[n].size != e.size ? nullptr : &known_[n];
}

/// The surface is nowhere in the leaf.
bool Fine::is_far(const Near& near, const Leaf& leaf) const {
    const Vec3 low = leaves_.node(leaf.at), half = 0.5 * (leaves_.node(corner_of(leaf, 7)) - low);
    const bool material = is_material(leaf.at);
    for (int c = 1; c < 8; ++c)
        if (is_material(corner_of(leaf, c)) != material) return false;
    return exact_.is_clear(near, low + half, length(half));
}

/// Edges of leaves near the surface.
void Fine::find_known() {
    std::vector<std::vector<std::pair<ShortEdge, Known>>> found(dirty_.size());
    base::for_all(dirty_.size(), [&](std::size_t n) {
        const Near near = exact_.near(dirty_[n], true);
        std::array<KeyMap, 3> asked;
        leaves_.each_leaf(dirty_[n], [&](const Leaf& leaf) {
            if (!leaves_.is_of(leaf, round_) || is_far(near, leaf)) return;
            each_edge_of(leaf, [&](const ShortEdge& e) {
                if (known(e) != nullptr || !leaves_.is_short(e.at, e.size, e.axis)) return;
                KeyMap& own = asked[static_cast<std::size_t>(e.axis)];
                const std::size_t before = own.size();
                own.add(key_of(e.at), 1);
                if (own.size() > before) found[n].emplace_back(e, look(near, e));
            });
        });
    });
    for (const auto& cell : found)
        for (const auto& [e, what] : cell) {
            if (known(e) != nullptr) continue;
            known_of_[static_cast<std::size_t>(e.axis)].set(key_of(e.at), static_cast<std::uint32_t>(known_.size()));
            known_.push_back(what);
        }
}

/// All edges that the surface crosses: of halved cells and of those beside them.
void Fine::find_edges(const std::vector<Place>& cells) {
    edges_.clear();
    edge_of_ = {};
    const std::int32_t unit = leaves_.unit();
    for (const Place& cell : cells)
        leaves_.each_leaf(cell, [&](const Leaf& leaf) {
            std::array<bool, 8> material{};
            for (std::size_t c = 0; c < 8; ++c) material[c] = is_material(corner_of(leaf, static_cast<int>(c)));
            if (std::all_of(material.begin(), material.end(), [&](bool m) { return m == material[0]; })) return;
            each_edge_of(leaf, [&](const ShortEdge& e) {
                std::size_t low = 0;
                for (std::size_t a = 0; a < 3; ++a) low |= std::size_t{e.at[a] > leaf.at[a]} << a;
                const bool leaves = material[low];
                if (leaves == material[low | std::size_t{1} << static_cast<unsigned>(e.axis)]) return;
                KeyMap& own = edge_of_[static_cast<std::size_t>(e.axis)];
                if (own.find(key_of(e.at)) != KeyMap::none || !leaves_.is_short(e.at, e.size, e.axis)) return;
                Edge edge;
                edge.edge = e;
                edge.around = leaves_.around(e.at, e.axis);
                edge.leaves = leaves;
                if (e.size == unit)
                    edge.crossing = crossings_.along(
                        e.axis)[crossings_.number(e.axis, e.at[0] / unit, e.at[1] / unit, e.at[2] / unit)];
                else if (const Known* k = known(e); k != nullptr)
                    edge.crossing = k->crossing;
                own.add(key_of(e.at), static_cast<std::uint32_t>(edges_.size()));
                edges_.push_back(edge);
            });
        });
}

Vec3 Fine::point_of(const Edge& e) const {
    Vec3 p = leaves_.node(e.edge.at);
    set_component(p, e.edge.axis, e.crossing.at);
    return p;
}

}  // namespace obrys::sim::milling
