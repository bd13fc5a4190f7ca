#include <algorithm>
#include <array>

#include "base/whole.hpp"
#include "geom/clearing.hpp"
#include "geom/edge.hpp"

namespace obrys::geom {

namespace {

/// A link seen from one of its rings; `at` is how far along the ring: edge number + parameter.
struct Exit {
    std::size_t link = 0, to = 0;
    double at = 0;
};

class Walker {
public:
    Walker(const Clearing& c, bool reverse) : c_(c), exits_(c.rings.size()), seen_(c.rings.size(), 0) {
        for (const Ring& r : c.rings) chains_.push_back(edges(reverse ? reversed(r.path) : r.path));
        for (std::size_t i = 0; i < c.links.size(); ++i) {
            const RingLink& l = c.links[i];
            exits_[l.a].push_back({i, l.b, place(l.a, l.at_a)});
            exits_[l.b].push_back({i, l.a, place(l.b, l.at_b)});
        }
    }

    std::vector<Contour> tours() {
        std::vector<std::size_t> order(c_.rings.size());
        for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
        std::stable_sort(order.begin(), order.end(),
                         [&](std::size_t a, std::size_t b) { return c_.rings[a].level > c_.rings[b].level; });
        std::vector<Contour> out;
        for (const std::size_t ring : order)
            if (!seen_[ring] && !c_.rings[ring].added) out.push_back(tour(ring));
        return out;
    }

private:
    /// Where on the ring the point lies.
    [[nodiscard]] double place(std::size_t ring, Vec2 p) const {
        double best = 0, least = std::numeric_limits<double>::infinity();
        for (std::size_t i = 0; i < chains_[ring].size(); ++i) {
            const Edge& e = chains_[ring][i];
            if (const double d = distance(e, p); d < least) {
                least = d;
                best = static_cast<double>(i) + std::clamp(parameter(e, p), 0.0, 1.0);
            }
        }
        return best;
    }

    void go(const Edge& e) {
        if (e.a == e.b) return;
        if (path_.vertices.empty()) path_.vertices.push_back({e.a});
        path_.vertices.back().bulge = e.bulge;
        path_.vertices.push_back({e.b});
    }
    void cross_over(std::size_t from, std::size_t link) {
        const RingLink& l = c_.links[link];
        const bool forward = l.a == from;
        const Vec2 a = forward ? l.at_a : l.at_b, b = forward ? l.at_b : l.at_a;
        if (path_.vertices.empty()) path_.vertices.push_back({a});
        go({path_.vertices.back().p, b, 0});
    }
    /// Along the ring from one place forward to another, `to` >= `from`, at most once around.
    void along(std::size_t ring, double from, double to) {
        const std::vector<Edge>& chain = chains_[ring];
        const auto n = static_cast<double>(chain.size());
        while (from < to) {
            const double edge = std::floor(from), end = std::min(edge + 1, to);
            const Edge& e = chain[base::clipped<std::size_t>(std::fmod(edge, n), 0, chain.size() - 1)];
            if (end - from > 1e-12) go(part(e, from - edge, end - edge));
            from = end;
        }
    }

    /// A ring being run along: entered at `entry`, then its exits in order.
    struct Round {
        std::size_t ring = 0, by = 0;  ///< by: the link it was entered over
        double entry = 0, at = 0;
        std::vector<Exit> exits;
        std::size_t next = 0;
    };
    static constexpr std::size_t none = static_cast<std::size_t>(-1);

    /// `main`: the exit by which the tour goes on; it is left for the end.
    Round round(std::size_t ring, std::size_t by, double entry, std::size_t main) {
        Round r{ring, by, entry, entry, {}, 0};
        const auto n = static_cast<double>(chains_[ring].size());
        for (Exit e : exits_[ring]) {
            if (seen_[e.to] || e.link == main) continue;
            if (e.at < entry) e.at += n;
            r.exits.push_back(e);
        }
        std::sort(r.exits.begin(), r.exits.end(), [](const Exit& a, const Exit& b) { return a.at < b.at; });
        seen_[ring] = 1;
        return r;
    }

    /// Once around the ring, with every branch that leaves it on the way.
    void around(std::size_t first, double entry, std::size_t main) {
        std::vector<Round> stack;
        stack.push_back(round(first, none, entry, main));
        while (!stack.empty()) {
            Round& r = stack.back();
            if (r.next < r.exits.size()) {
                const Exit e = r.exits[r.next++];
                along(r.ring, r.at, e.at);
                r.at = e.at;
                cross_over(r.ring, e.link);
                stack.push_back(round(e.to, e.link, other_end(e), none));
                continue;
            }
            along(r.ring, r.at, r.entry + static_cast<double>(chains_[r.ring].size()));
            if (r.by != none) cross_over(r.ring, r.by);
            stack.pop_back();
        }
    }
    [[nodiscard]] double other_end(const Exit& e) const {
        for (const Exit& back : exits_[e.to])
            if (back.link == e.link) return back.at;
        return 0;
    }

    /// Exits that lead from the ring to the outermost one of its part: the main way.
    [[nodiscard]] std::vector<Exit> main_way(std::size_t start) const {
        std::vector<std::size_t> found{start};
        std::vector<Exit> came(c_.rings.size());
        std::vector<std::size_t> before(c_.rings.size(), none);
        before[start] = start;
        std::size_t outermost = start;
        const auto outer = [&](std::size_t i) { return c_.rings[i].level == 0 && area(c_.rings[i].path) > 0; };
        for (std::size_t i = 0; i < found.size(); ++i) {
            if (outer(found[i]) && !c_.rings[found[i]].added) outermost = found[i];
            for (const Exit& e : exits_[found[i]])
                if (before[e.to] == none) {
                    before[e.to] = found[i];
                    came[e.to] = e;
                    found.push_back(e.to);
                }
        }
        std::vector<Exit> way;
        for (std::size_t i = outermost; i != start; i = before[i]) way.push_back(came[i]);
        std::reverse(way.begin(), way.end());
        return way;
    }

    Contour tour(std::size_t start) {
        path_ = {{}, false};
        const std::vector<Exit> way = main_way(start);
        std::size_t ring = start;
        double entry = way.empty() ? 0 : way.front().at;
        for (std::size_t i = 0; i <= way.size(); ++i) {
            // Rings of the main way further on are not branches of this one.
            for (std::size_t k = i; k < way.size(); ++k) seen_[way[k].to] = 1;
            if (path_.vertices.empty() && !chains_[ring].empty()) path_.vertices.push_back({start_of(ring, entry)});
            around(ring, entry, i < way.size() ? way[i].link : none);
            if (i == way.size()) break;
            const auto n = static_cast<double>(chains_[ring].size());
            along(ring, entry, way[i].at < entry ? way[i].at + n : way[i].at);
            cross_over(ring, way[i].link);
            entry = other_end(way[i]);
            ring = way[i].to;
        }
        return std::move(path_);
    }
    [[nodiscard]] Vec2 start_of(std::size_t ring, double entry) const {
        const double edge = std::min(std::floor(entry), static_cast<double>(chains_[ring].size() - 1));
        return point_at(chains_[ring][base::clipped<std::size_t>(edge, 0, chains_[ring].size() - 1)], entry - edge);
    }

    const Clearing& c_;
    std::vector<std::vector<Edge>> chains_;
    std::vector<std::vector<Exit>> exits_;
    std::vector<char> seen_;
    Contour path_;
};

}  // namespace

std::vector<Contour> clearing_tours(const Clearing& c, bool reverse) { return Walker(c, reverse).tours(); }

}  // namespace obrys::geom
