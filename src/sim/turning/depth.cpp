#include <algorithm>

#include "geom/boolean.hpp"
#include "sim/turning/deepest.hpp"
#include "sim/turning/stock.hpp"
#include "sim/turning/turning.hpp"

namespace obrys::sim::turning {

using geom::Region;
using geom::Vec2;

namespace {

std::optional<Depth> depth_of(const Region& both, const Around& around, double tolerance) {
    std::optional<Depth> sum;
    for (const Region& piece : geom::pieces(both)) {
        const std::optional<Depth> d = around.measure(piece, tolerance);
        if (!d) continue;
        if (!sum) {
            sum = d;
            continue;
        }
        sum->area += d->area;
        sum->volume += d->volume;
        sum->along_x = std::max(sum->along_x, d->along_x);
        if (d->normal > sum->normal) sum->normal = d->normal, sum->deepest = d->deepest;
        sum->region.contours.insert(sum->region.contours.end(), piece.contours.begin(), piece.contours.end());
    }
    return sum;
}

}  // namespace

std::optional<Depth> depth_inside(const Region& removed, const Region& kept, double tolerance) {
    if (removed.empty() || !geom::overlap(geom::box(removed), geom::box(kept))) return std::nullopt;
    const Region both = geom::intersect(removed, kept);
    if (both.empty()) return std::nullopt;
    return depth_of(both, Around(kept), tolerance);
}

struct Kept::State {
    explicit State(Region r) : region(std::move(r)), bounds(region), around(region) {}
    Region region;
    Stock bounds;
    Around around;

    /// With the edges near `removed` alone.
    Region intersect(const Region& removed) {
        const geom::Box where = geom::box(removed);
        if (!geom::overlap(where, bounds.box())) return {};
        const std::vector<Slot> near = bounds.near(where, near_margin);
        if (near.empty() && bounds.winding(removed.contours.front().vertices.front().p) <= 0) return {};
        geom::Arrangement graph(sources_of(bounds, near, removed), {.sets_are_clean = true});
        const std::vector<geom::Edge> own = geom::edges(removed);
        graph.label_clean([&](Vec2 p) { return bounds.winding(p); }, [&](Vec2 p) { return geom::winding(own, p); });
        // Something degenerate: the whole contour, with the general set operations.
        if (!graph.consistent() || !graph.windings_within(0, 1)) return geom::intersect(removed, region);
        return graph.region([](geom::Windings w) { return w.a > 0 && w.b > 0; });
    }
};

Kept::Kept(Region region) : state_(std::make_unique<State>(std::move(region))) {}
Kept::~Kept() = default;
Kept::Kept(Kept&&) noexcept = default;
Kept& Kept::operator=(Kept&&) noexcept = default;

const Region& Kept::region() const { return state_->region; }

std::optional<Depth> Kept::depth_inside(const Region& removed, double tolerance) const {
    if (removed.empty()) return std::nullopt;
    const Region both = state_->intersect(removed);
    if (both.empty()) return std::nullopt;
    return depth_of(both, state_->around, tolerance);
}

std::vector<Depth> pieces_outside(const Region& left, const Region& wanted, double tolerance) {
    std::vector<Depth> out;
    const Around around(wanted);
    for (const Region& piece : geom::pieces(geom::subtract(left, wanted)))
        if (auto d = around.measure(piece, tolerance)) out.push_back(std::move(*d));
    return out;
}

}  // namespace obrys::sim::turning
