#include <algorithm>
#include <optional>

#include "geom/arrangement.hpp"
#include "geom/band.hpp"
#include "geom/boolean.hpp"
#include "geom/offset.hpp"
#include "geom/tolerance.hpp"

namespace obrys::geom {

namespace {

using Half = Arrangement::Half;

/// The chain there and back again: a closed one, without area.
std::vector<Edge> there_and_back(const std::vector<Edge>& chain) {
    std::vector<Edge> out = chain;
    for (std::size_t i = chain.size(); i-- > 0;) out.push_back(reversed(chain[i]));
    return out;
}

Contour contour_along(const std::vector<BandEdge>& curve) {
    Contour c;
    for (const BandEdge& b : curve) c.vertices.push_back({b.edge.a, b.edge.bulge});
    return c;
}

constexpr auto covered = [](Windings w) { return w.a > 0; };

/// The edges of the band's curves; those that lie beside the contour on its right come first and in its order, so that
/// they give the tag to pieces that lie on others.
std::vector<SourceEdge> sources_of(const Contour& c, const std::vector<Edge>& chain, double d) {
    std::vector<SourceEdge> out, rest;
    for (const BandEdge& b : band_right_of(c.closed ? chain : there_and_back(chain), d)) {
        const std::size_t most = c.closed ? chain.size() : b.corner ? chain.size() - 1 : chain.size();
        const bool beside = b.far && !b.inner && b.of < most;
        SourceEdge s{.edge = b.edge};
        if (beside) s.tag = static_cast<std::int32_t>(2 * b.of + (b.corner ? 1 : 0));
        (beside ? out : rest).push_back(s);
    }
    out.insert(out.end(), rest.begin(), rest.end());
    if (!c.closed) return out;
    // The left side; the two curves wind about the contour's inside in opposite ways.
    for (const BandEdge& b : band_right_of(edges(reversed(c)), d)) out.push_back({.edge = b.edge});
    return out;
}

/// Runs of the band's boundary whose pieces all have a tag, in the order of their first pieces or of their last.
class Runs {
public:
    Runs(const Arrangement& graph, bool by_end) : graph_(graph), by_end_(by_end), used_(2 * graph.pieces().size(), 0) {
        std::vector<char> continued(used_.size(), 0);
        for (Half h = 0; h < used_.size(); ++h)
            if (wanted(h))
                if (const Half g = graph_.following(h, covered); g != Arrangement::none && wanted(g)) continued[g] = 1;
        for (Half h = 0; h < used_.size(); ++h)
            if (wanted(h) && !continued[h]) follow(h);
        for (Half h = 0; h < used_.size(); ++h)  // what is left runs around
            if (wanted(h)) follow(h);
        std::stable_sort(runs_.begin(), runs_.end(), [](const Run& a, const Run& b) { return a.tag < b.tag; });
    }

    [[nodiscard]] std::vector<Contour> contours() const {
        std::vector<Contour> out;
        for (const Run& r : runs_) out.push_back(r.contour);
        return out;
    }

private:
    struct Run {
        Contour contour;
        std::int32_t tag = 0;
    };
    [[nodiscard]] bool wanted(Half h) const {
        return !used_[h] && graph_.pieces()[h / 2].tag >= 0 && graph_.bounds(h, covered);
    }
    void follow(Half first) {
        std::vector<Edge> chain;
        double around = 0;
        Half h = first;
        std::int32_t least = graph_.pieces()[first / 2].tag, most = least, last = least;
        Run run;
        while (h != Arrangement::none && wanted(h)) {
            used_[h] = 1;
            const std::int32_t tag = graph_.pieces()[h / 2].tag;
            least = std::min(least, tag);
            most = std::max(most, tag);
            last = tag;
            chain.push_back(graph_.edge(h));
            around += length(chain.back());
            h = graph_.following(h, covered);
        }
        if (around <= 10 * snap) return;
        const bool closed = h == first;
        run.tag = by_end_ ? (closed ? most : last) : (closed ? least : graph_.pieces()[first / 2].tag);
        chain = joined(chain, closed);
        run.contour = contour_of(chain);
        run.contour.closed = closed;
        if (!closed) run.contour.vertices.push_back({chain.back().b});
        runs_.push_back(std::move(run));
    }

    const Arrangement& graph_;
    bool by_end_;
    std::vector<char> used_;
    std::vector<Run> runs_;
};

std::vector<Contour> right_of(const Contour& c, double d, bool by_end) {
    const std::vector<Edge> chain = edges(c);
    if (chain.empty()) return {};
    const std::vector<SourceEdge> sources = sources_of(c, chain, d);
    // As the set operations do: a graph whose windings contradict each other is made anew with a coarser weld.
    for (double tolerance = snap;; tolerance *= 3) {
        Arrangement graph(sources, {.tolerance = tolerance});
        graph.label();
        if (graph.consistent() || tolerance > 1e-6) return Runs(graph, by_end).contours();
    }
}

}  // namespace

Region band(const Contour& c, double d) {
    const std::vector<Edge> chain = edges(c);
    if (chain.empty()) return {};
    if (!c.closed) return positive({contour_along(band_right_of(there_and_back(chain), d))});
    // Each curve winds about the contour's inside as the contour does, the two in opposite ways.
    return positive({contour_along(band_right_of(chain, d)), contour_along(band_right_of(edges(reversed(c)), d))});
}

std::vector<Contour> equidistants(const Contour& c, double by) {
    if (by == 0) return {c};
    if (by < 0) return right_of(c, -by, false);
    std::vector<Contour> out = right_of(reversed(c), by, true);
    std::reverse(out.begin(), out.end());
    for (Contour& k : out) k = reversed(k);
    return out;
}

}  // namespace obrys::geom
