#include "sim/turning/stock.hpp"

#include <algorithm>
#include <cmath>

#include "base/whole.hpp"
#include "geom/boolean.hpp"
#include "geom/tolerance.hpp"

namespace obrys::sim::turning {

namespace {

constexpr int cell_count = 65536;

}  // namespace

void Stock::rebuild(const geom::Region& region) {
    bounds_.clear();
    free_.clear();
    cells_.clear();
    box_ = geom::box(region);
    if (box_.empty()) box_ = {{0, 0}, {1, 1}};
    const double w = std::max(box_.hi.x - box_.lo.x, 1e-6), h = std::max(box_.hi.y - box_.lo.y, 1e-6);
    size_ = std::max(std::sqrt(w * h / cell_count), std::max(w, h) / cell_count);
    nx_ = base::clipped<int>(w / size_, 0, cell_count) + 1;
    ny_ = base::clipped<int>(h / size_, 0, cell_count) + 1;
    cells_.resize(static_cast<std::size_t>(nx_) * static_cast<std::size_t>(ny_));
    for (const geom::Contour& c : region.contours) {
        Slot first = -1, last = -1;
        for (const geom::Edge& e : geom::edges(c)) {
            const Slot s = insert(e);
            if (last >= 0) join(last, s);
            if (first < 0) first = s;
            last = s;
        }
        if (last >= 0) join(last, first);
    }
}

geom::Region Stock::region() const {
    geom::Region out;
    std::vector<char> done(bounds_.size(), 0);
    for (std::size_t i = 0; i < bounds_.size(); ++i) {
        if (!bounds_[i].used || done[i]) continue;
        std::vector<geom::Edge> chain;
        for (std::size_t s = i; !done[s]; s = static_cast<std::size_t>(bounds_[s].next)) {
            done[s] = 1;
            chain.push_back(bounds_[s].edge);
        }
        out.contours.push_back(geom::contour_of(geom::joined(chain, true)));
    }
    return out;
}

Stock::Range Stock::range(const geom::Box& b) const {
    const auto index = [this](double v, double lo, int n) { return base::clipped<int>((v - lo) / size_, 0, n - 1); };
    return {index(b.lo.x, box_.lo.x, nx_), index(b.hi.x, box_.lo.x, nx_), index(b.lo.y, box_.lo.y, ny_),
            index(b.hi.y, box_.lo.y, ny_)};
}

template <class F>
void Stock::each_cell(const geom::Box& b, F&& f) {
    const Range r = range(b);
    for (int y = r.y0; y <= r.y1; ++y)
        for (int x = r.x0; x <= r.x1; ++x) f(cell(x, y));
}

std::vector<Slot> Stock::near(const geom::Box& b, double margin) {
    std::vector<Slot> out;
    if (!geom::overlap(b, box_, margin)) return out;
    ++query_;
    const geom::Vec2 m{margin, margin};
    each_cell({b.lo - m, b.hi + m}, [&](const std::vector<Slot>& slots) {
        for (const Slot s : slots) {
            Bound& e = at(s);
            if (e.seen == query_ || !geom::overlap(e.box, b, margin)) continue;
            e.seen = query_;
            out.push_back(s);
        }
    });
    std::sort(out.begin(), out.end());
    return out;
}

int Stock::winding(geom::Vec2 p) {
    if (!geom::contains(box_, p)) return 0;
    ++query_;
    int w = 0;
    // Everything a ray to the right can meet.
    each_cell({p, {box_.hi.x, p.y}}, [&](const std::vector<Slot>& slots) {
        for (const Slot s : slots) {
            Bound& e = at(s);
            if (e.seen == query_) continue;
            e.seen = query_;
            w += geom::winding_term(e.edge, p);
        }
    });
    return w;
}

Slot Stock::insert(const geom::Edge& e) {
    Slot s = static_cast<Slot>(bounds_.size());
    if (free_.empty()) {
        bounds_.emplace_back();
    } else {
        s = free_.back();
        free_.pop_back();
    }
    Bound& b = at(s);
    b = {e, geom::box(e), -1, -1, true, b.seen};
    each_cell(b.box, [s](std::vector<Slot>& slots) { slots.push_back(s); });
    return s;
}

void Stock::erase(Slot s) {
    each_cell(at(s).box, [s](std::vector<Slot>& slots) {
        if (const auto it = std::find(slots.begin(), slots.end(), s); it != slots.end()) {
            *it = slots.back();
            slots.pop_back();
        }
    });
    at(s).used = false;
    free_.push_back(s);
}

void Stock::join(Slot before, Slot after) {
    at(before).next = after;
    at(after).previous = before;
}

void Stock::drop_slivers(const std::vector<Slot>& touched) {
    constexpr std::size_t most = 16;  // longer chains are left alone: the cost must stay local
    for (const Slot first : touched) {
        if (!at(first).used) continue;
        std::vector<Slot> loop;
        Slot next = first;
        do {
            loop.push_back(next);
            next = at(next).next;
        } while (next != first && loop.size() < most);
        if (next != first) continue;
        double area = 0, around = 0;
        for (const Slot s : loop) {
            area += geom::area_term(geom::moved(at(s).edge, -at(first).edge.a));
            around += geom::length(at(s).edge);
        }
        if (std::abs(area) > 0.5 * geom::snap * around) continue;
        for (const Slot dropped : loop) erase(dropped);
    }
}

std::vector<geom::SourceEdge> sources_of(const Stock& stock, const std::vector<Slot>& near, const geom::Region& tool) {
    std::vector<geom::SourceEdge> out;
    const auto is_near = [&](Slot s) { return std::binary_search(near.begin(), near.end(), s); };
    for (const Slot s : near)
        out.push_back({.edge = stock[s].edge,
                       .of = {1, 0},
                       .tag = s,
                       .open_a = !is_near(stock[s].previous),
                       .open_b = !is_near(stock[s].next)});
    for (const geom::Edge& e : geom::edges(tool)) out.push_back({.edge = e, .of = {0, 1}});
    return out;
}

geom::Region overlap(Stock& stock, const geom::Region& tool) {
    const geom::Box where = geom::box(tool);
    if (!geom::overlap(where, stock.box())) return {};
    const std::vector<Slot> near = stock.near(where, near_margin);
    if (near.empty() && stock.winding(tool.contours.front().vertices.front().p) <= 0) return {};
    geom::Arrangement graph(sources_of(stock, near, tool), {.sets_are_clean = true});
    const std::vector<geom::Edge> own = geom::edges(tool);
    graph.label_clean([&](geom::Vec2 p) { return stock.winding(p); },
                      [&](geom::Vec2 p) { return geom::winding(own, p); });
    // Something degenerate: the whole contour, with the general set operations.
    if (!graph.consistent() || !graph.windings_within(0, 1)) return geom::intersect(tool, stock.region());
    return graph.region([](geom::Windings w) { return w.a > 0 && w.b > 0; });
}

}  // namespace obrys::sim::turning
