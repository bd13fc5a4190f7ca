#include <algorithm>

#include "geom/boolean.hpp"
#include "sim/turning/deepest.hpp"
#include "sim/turning/stock.hpp"
#include "sim/turning/turning.hpp"

namespace obrys::sim::turning {

using geom::Region;
using geom::Vec2;

namespace {

constexpr double skin = 0.1;  ///< of the tolerance: what is thinner is no material

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
};

Kept::Kept(Region region) : state_(std::make_unique<State>(std::move(region))) {}
Kept::~Kept() = default;
Kept::Kept(Kept&&) noexcept = default;
Kept& Kept::operator=(Kept&&) noexcept = default;

const Region& Kept::region() const { return state_->region; }

std::optional<Depth> Kept::depth_inside(const Region& removed, double tolerance) const {
    if (removed.empty()) return std::nullopt;
    const Region both = overlap(state_->bounds, removed);
    if (both.empty()) return std::nullopt;
    return depth_of(both, state_->around, tolerance);
}

std::vector<Depth> pieces_outside(const Region& left, const Region& wanted, double tolerance) {
    std::vector<Depth> out;
    const Around around(wanted);
    // Between two cuts whose coordinates are rounded a skin may stand, as deep as the cuts and next to nothing thick.
    const auto is_skin = [&](const Region& piece) { return !Around(piece).reaches(piece, skin * tolerance / 2); };
    for (const Region& piece : geom::pieces(geom::subtract(left, wanted))) {
        auto d = around.measure(piece, tolerance);
        if (d && !is_skin(piece)) out.push_back(std::move(*d));
    }
    return out;
}

}  // namespace obrys::sim::turning
