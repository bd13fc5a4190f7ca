#include <algorithm>
#include <cmath>

#include "geom/boolean.hpp"
#include "geom/tolerance.hpp"
#include "sim/turning/contact.hpp"
#include "sim/turning/stock.hpp"
#include "sim/turning/swept.hpp"
#include "sim/turning/turning.hpp"

namespace obrys::sim::turning {

using geom::Arrangement;
using geom::Edge;
using geom::Region;
using geom::Vec2;

namespace {

constexpr auto stays = [](geom::Windings w) { return w.a > 0 && w.b <= 0; };
constexpr auto goes = [](geom::Windings w) { return w.a > 0 && w.b > 0; };

/// The new boundary inside the neighbourhood of a cut, ready to take the place of the old.
struct Patch {
    std::vector<Edge> edges;
    std::vector<std::int32_t> next;  ///< index of the edge that follows; -1: leaves the neighbourhood
    std::vector<Slot> from, to;      ///< slot outside that comes before and after, where the chain begins and ends
    bool sound = true;
};

class LocalCut {
public:
    LocalCut(const Stock& stock, const std::vector<Slot>& near, const Arrangement& graph)
        : stock_(stock), near_(near), graph_(graph), index_(2 * graph.pieces().size(), -1) {}

    Patch patch() {
        Patch p;
        std::vector<Arrangement::Half> halves;
        for (Arrangement::Half h = 0; h < index_.size(); ++h)
            if (graph_.bounds(h, stays)) {
                index_[h] = static_cast<std::int32_t>(halves.size());
                halves.push_back(h);
                p.edges.push_back(graph_.edge(h));
            }
        p.next.assign(halves.size(), -1);
        p.from.assign(halves.size(), -1);
        p.to.assign(halves.size(), -1);
        for (std::size_t i = 0; i < halves.size(); ++i) {
            if (graph_.is_open(graph_.to(halves[i]))) continue;
            const Arrangement::Half g = graph_.following(halves[i], stays);
            if (g == Arrangement::none || index_[g] < 0)
                p.sound = false;
            else
                p.next[i] = index_[g];
        }
        link_open_ends(p, halves);
        std::vector<int> before(halves.size(), 0);
        for (std::size_t i = 0; i < halves.size(); ++i) {
            if (p.next[i] >= 0) ++before[static_cast<std::size_t>(p.next[i])];
            if (p.from[i] >= 0) ++before[i];
            if ((p.next[i] >= 0) == (p.to[i] >= 0)) p.sound = false;
        }
        for (const int n : before) p.sound = p.sound && n == 1;
        return p;
    }

private:
    [[nodiscard]] bool is_near(Slot s) const { return std::binary_search(near_.begin(), near_.end(), s); }

    /// The piece of the stock edge that begins (or ends) in an open vertex.
    std::int32_t end_piece(const std::vector<Arrangement::Half>& halves, Slot s, bool at_start) const {
        for (std::size_t i = 0; i < halves.size(); ++i) {
            const Arrangement::Half h = halves[i];
            if (graph_.pieces()[h / 2].tag != s) continue;
            const std::uint32_t v = at_start ? graph_.from(h) : graph_.to(h);
            const Vec2 end = at_start ? stock_[s].edge.a : stock_[s].edge.b;
            if (graph_.is_open(v) && geom::distance(graph_.vertex(v), end) < near_margin / 2)
                return static_cast<std::int32_t>(i);
        }
        return -1;
    }

    void link_open_ends(Patch& p, const std::vector<Arrangement::Half>& halves) const {
        for (const Slot s : near_) {
            const Slot after = stock_[s].next, before = stock_[s].previous;
            if (!is_near(before)) {
                const std::int32_t i = end_piece(halves, s, true);
                if (i < 0)
                    p.sound = false;
                else
                    p.from[static_cast<std::size_t>(i)] = before;
            }
            const std::int32_t last = end_piece(halves, s, false);
            if (!is_near(after)) {
                if (last < 0)
                    p.sound = false;
                else
                    p.to[static_cast<std::size_t>(last)] = after;
            } else if (last >= 0) {
                // Both edges are near, but another contour's open end stands in the same corner.
                const std::int32_t first = end_piece(halves, after, true);
                if (first < 0)
                    p.sound = false;
                else
                    p.next[static_cast<std::size_t>(last)] = first;
            }
        }
    }

    const Stock& stock_;
    const std::vector<Slot>& near_;
    const Arrangement& graph_;
    std::vector<std::int32_t> index_;
};

/// Edges of the patch that follow each other on one line or circle become one.
void join_corners(Patch& p) {
    std::vector<char> gone(p.edges.size(), 0);
    for (std::size_t i = 0; i < p.edges.size(); ++i) {
        if (gone[i]) continue;
        Edge one;
        while (p.next[i] >= 0) {
            const auto n = static_cast<std::size_t>(p.next[i]);
            if (n == i || gone[n] || p.from[n] >= 0 || p.next[n] == static_cast<std::int32_t>(i) ||
                !geom::join_edges(p.edges[i], p.edges[n], one))
                break;
            p.edges[i] = one;
            p.next[i] = p.next[n];
            p.to[i] = p.to[n];
            gone[n] = 1;
        }
    }
    std::vector<std::int32_t> place(p.edges.size(), -1);
    Patch out;
    for (std::size_t i = 0; i < p.edges.size(); ++i) {
        if (gone[i]) continue;
        place[i] = static_cast<std::int32_t>(out.edges.size());
        out.edges.push_back(p.edges[i]);
        out.next.push_back(p.next[i]);
        out.from.push_back(p.from[i]);
        out.to.push_back(p.to[i]);
    }
    for (std::int32_t& n : out.next)
        if (n >= 0) n = place[static_cast<std::size_t>(n)];
    p = std::move(out);
}

void apply(Stock& stock, const std::vector<Slot>& near, Patch p) {
    join_corners(p);
    for (const Slot s : near) stock.erase(s);
    std::vector<Slot> slots;
    for (const Edge& e : p.edges) slots.push_back(stock.insert(e));
    for (std::size_t i = 0; i < slots.size(); ++i) {
        if (p.next[i] >= 0) stock.join(slots[i], slots[static_cast<std::size_t>(p.next[i])]);
        if (p.from[i] >= 0) stock.join(p.from[i], slots[i]);
        if (p.to[i] >= 0) stock.join(slots[i], p.to[i]);
    }
    stock.drop_slivers(slots);
}

}  // namespace

struct Workpiece::State {
    explicit State(const Region& r) : stock(r) {}
    Stock stock;

    Region remove(const Region& tool) {
        const geom::Box where = geom::box(tool);
        if (!geom::overlap(where, stock.box())) return {};
        const std::vector<Slot> near = stock.near(where, near_margin);
        if (near.empty() && stock.winding(tool.contours.front().vertices.front().p) <= 0) return {};
        Arrangement graph(sources_of(stock, near, tool), {.sets_are_clean = true});
        const std::vector<Edge> tool_edges = geom::edges(tool);
        graph.label_clean([&](Vec2 p) { return stock.winding(p); },
                          [&](Vec2 p) { return geom::winding(tool_edges, p); });
        if (graph.consistent()) {
            Region removed = graph.region(goes);
            if (removed.empty()) return removed;
            Patch p = LocalCut(stock, near, graph).patch();
            if (p.sound) {
                apply(stock, near, std::move(p));
                return removed;
            }
        }
        // Something degenerate: the whole stock at once, with the general set operations.
        const Region whole = stock.region();
        Region removed = geom::intersect(whole, tool);
        if (!removed.empty()) stock.rebuild(geom::subtract(whole, tool));
        return removed;
    }
};

Workpiece::Workpiece(const Region& stock) : state_(std::make_unique<State>(geom::tidied(stock.contours))) {}
Workpiece::~Workpiece() = default;
Workpiece::Workpiece(const Workpiece& other) : state_(std::make_unique<State>(*other.state_)) {}
Workpiece& Workpiece::operator=(const Workpiece& other) { return *this = Workpiece(other); }
Workpiece::Workpiece(Workpiece&&) noexcept = default;
Workpiece& Workpiece::operator=(Workpiece&&) noexcept = default;

Cut Workpiece::cut(const geom::Contour& outline, const Move& move, const geom::Contour& across) {
    Cut c;
    if (const Region tool = swept(outline, move); !tool.empty()) c.removed = state_->remove(tool);
    if (!c.removed.empty()) c.contact_length = contact_length(outline, move, c.removed);
    for (const TurnedOver& t : turned_over(outline, across, move)) {
        const Region tool = swept(t.outline, t.move);
        const Region more = tool.empty() ? Region{} : state_->remove(tool);
        if (more.empty()) continue;
        c.contact_length += contact_length(t.outline, t.move, more);
        c.across = geom::unite(c.across, more);
    }
    if (!c.across.empty()) c.removed = geom::unite(c.removed, c.across);
    if (c.removed.empty()) return c;
    c.area = geom::area(c.removed);
    c.volume = geom::volume(c.removed);
    const geom::Box b = geom::box(c.removed);
    c.depth_x = b.hi.y - b.lo.y;
    return c;
}

Region Workpiece::met(const geom::Contour& body, const Move& move, const geom::Contour& across) const {
    Region all;
    const auto meet = [&](const Region& tool) {
        if (tool.empty()) return;
        const Region both = overlap(state_->stock, tool);
        if (!both.empty()) all = all.empty() ? both : geom::unite(all, both);
    };
    meet(swept(body, move));
    for (const TurnedOver& t : turned_over(body, across, move)) meet(swept(t.outline, t.move));
    return all;
}

Region Workpiece::region() const { return state_->stock.region(); }

double Workpiece::area() const {
    double sum = 0;
    state_->stock.each([&](const Edge& e) { sum += geom::area_term(e); });
    return sum;
}

double Workpiece::volume() const {
    double sum = 0;
    state_->stock.each([&](const Edge& e) { sum += geom::moment_term(e); });
    return 2 * geom::pi * sum;
}

}  // namespace obrys::sim::turning
