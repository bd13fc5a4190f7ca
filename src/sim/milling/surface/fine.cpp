// The loop: halve, look, judge, halve what is off.

#include "sim/milling/surface/fine.hpp"

#include <algorithm>
#include <cmath>

#include "base/parallel.hpp"
#include "base/whole.hpp"
#include "sim/milling/nearest.hpp"

namespace obrys::sim::milling {

namespace {

using geom::Vec3;

/// Of the tolerance: how far points looked at may be off, for those between them. How deep any lie in the material is
/// proved afterwards (within.hpp).
constexpr double fine_sampled = 0.5, fine_within = 0.8;
constexpr double small_leaf = 8;  ///< tolerances: a leaf's diagonal below which it is not asked what it may hide
constexpr int most_levels = 6;
constexpr int more_levels = 2;   ///< for what is off by more than the tolerance, and for places looked for: needles
constexpr int sharp_levels = 2;  ///< and for sharp lines: a scratch of 20 degrees is a third as wide as it is deep
constexpr std::size_t most_known = 6'000'000;  ///< edges looked at, in all: some 500 MB with what belongs to them

/// The largest slopes of a body's distance over a cell make its least value there: the distance is convex.
double least_in(const Foot& foot, const Orientation& frame, bool circular, Vec3 half) {
    if (circular) return foot.outside - length(half);
    const Vec3 g = frame.to_stock(foot.gradient);
    return foot.outside - std::abs(g.x) * half.x - std::abs(g.y) * half.y - std::abs(g.z) * half.z;
}

/// Until a cell is no larger than the tolerance.
int levels_for(const Lattice& lattice, double tolerance) {
    const double step = std::max({lattice.step.x, lattice.step.y, lattice.step.z});
    return base::clipped<int>(std::ceil(std::log2(step / tolerance)), 0, most_levels);
}

std::array<Vec3, 8> corners_of(Vec3 low, Vec3 size) {
    std::array<Vec3, 8> c;
    for (std::size_t i = 0; i < 8; ++i)
        c[i] = low + Vec3{(i & 1) != 0 ? size.x : 0, (i & 2) != 0 ? size.y : 0, (i & 4) != 0 ? size.z : 0};
    return c;
}

}  // namespace

Fine::Fine(Exact& exact, double tolerance, const Lattice& lattice, const NodeBits& nodes, const Crossings& crossings,
           const CellVertices& cells, const std::vector<Vec3>& coarse, const Stop& stop)
    : lattice_(lattice),
      nodes_(nodes),
      crossings_(crossings),
      cells_(cells),
      coarse_(coarse),
      tolerance_(tolerance),
      stop_(stop),
      leaves_(lattice, levels_for(lattice, tolerance) + more_levels + sharp_levels),
      usual_(std::max(1, leaves_.unit() >> static_cast<unsigned>(levels_for(lattice, tolerance)))),
      smallest_(std::max(1, usual_ >> static_cast<unsigned>(more_levels))),
      exact_(exact) {}

void Fine::refine(const std::vector<Place>& cells) {
    if (leaves_.unit() == 1) return;
    std::vector<Leaf> next;
    for (const Place& c : cells)
        next.push_back({{c[0] * leaves_.unit(), c[1] * leaves_.unit(), c[2] * leaves_.unit()}, leaves_.unit()});
    halve(std::move(next));
}

bool Fine::is_full() const { return known_.size() >= most_known; }

bool Fine::leaf_of(Vec3 p, Leaf& leaf) const {
    Place at{};
    for (int a = 0; a < 3; ++a) {
        const auto n = static_cast<std::size_t>(a);
        const double step = component(lattice_.step, a) / leaves_.unit();
        const double cell = std::floor((component(p, a) - component(lattice_.origin, a)) / step);
        const auto whole = base::whole<std::int32_t>(cell, 0);
        if (!whole || !(cell < static_cast<double>(lattice_.count[n] - 1) * leaves_.unit())) return false;
        at[n] = *whole;
    }
    leaf = leaves_.leaf_at(at);
    return true;
}

void Fine::leave_open(Vec3 p) {
    Leaf leaf;
    if (!leaf_of(p, leaf)) return;
    open_.push_back(box_of(leaf));
}

void Fine::leave_filled(Vec3 p) {
    Leaf leaf;
    if (leaf_of(p, leaf)) filled_.push_back(box_of(leaf));
}

void Fine::halve(std::vector<Leaf> next) {
    while (!next.empty() && !(stop_ && stop_())) {
        ++round_;
        dirty_.clear();
        halved_ = next.size(), known_before_ = known_.size();
        KeyMap seen;
        for (const Leaf& leaf : next) {
            leaves_.split(leaf, round_);
            const Place cell = leaves_.cell_of(leaf.at);
            if (seen.add(key_of(cell), static_cast<std::uint32_t>(dirty_.size())) == dirty_.size())
                dirty_.push_back(cell);
        }
        std::sort(dirty_.begin(), dirty_.end(), [](const Place& a, const Place& b) { return key_of(a) < key_of(b); });
        find_fine_cells();
        find_signs();
        find_known();
        find_changed();
        find_surface(changed_);
        next = leaves_to_split();
    }
    placed_ = {};
    if (changed_.size() < all_.size()) find_surface(all_);
}

void Fine::find_fine_cells() {
    all_ = leaves_.split_cells();
    for (const Place& p : leaves_.cells_beside()) all_.push_back(p);
    std::sort(all_.begin(), all_.end(), [](const Place& a, const Place& b) { return key_of(a) < key_of(b); });
    for (const Place& p : all_) fine_cells_.add(key_of(p), 1);
    exact_.prepare(all_);
}

/// Four places of a triangle against the exact surface; what lies in air, every place.
bool Fine::is_off(const Near& here, const Corners& t, double allowed, double in_material) const {
    const auto off = [&](Vec3 p) { return !exact_.is_on_surface(here, p, allowed, in_material); };
    return off(t[0]) || off(0.5 * (t[0] + t[1])) || off((1.0 / 3) * (t[0] + t[1] + t[2])) || off(0.5 * (t[0] + t[2])) ||
           !exact_.is_beside_material(here, t, (allowed < tolerance_ ? beside_share : beside_left) * tolerance_,
                                      most_beside_parts);
}

/// The triangles about an edge against the exact surface.
bool Fine::is_off(const Place& cell, std::size_t edge, double allowed, double in_material) const {
    const Vec3 middle = point_of(edges_[edge]);
    double radius = 0;
    for (std::size_t q = 0; q < 4; ++q) radius = std::max(radius, geom::distance(middle, position(vertex(edge, q))));
    const std::optional<Near> here = exact_.about(cell, middle, radius + tolerance_);
    if (!here) return true;
    for (std::size_t q = 0; q < 4; ++q) {
        if (edges_[edge].around[q] == edges_[edge].around[(q + 1) % 4]) continue;
        const Corners t{position(vertex(edge, q)), position(vertex(edge, (q + 1) % 4)), middle};
        if (is_off(*here, t, allowed, in_material)) return true;
    }
    return false;
}

/// Of the triangles about an edge, by their corners: the same where these are the same.
std::uint32_t Fine::likeness(std::size_t edge) const {
    std::array<Vec3, 4> corners;
    for (std::size_t q = 0; q < 4; ++q) corners[q] = position(vertex(edge, q));
    const std::uint64_t mixed = mixed_of(corners, static_cast<std::uint64_t>(edges_[edge].edge.size));
    return static_cast<std::uint32_t>(mixed >> 32U) & 0x7FFFFFFFU;
}

/// No body of air reaches farther into a cell of material than half a tolerance.
bool Fine::is_plain(const Near& near, const Leaf& leaf) const {
    const Vec3 low = leaves_.node(leaf.at),
               high = leaves_.node({leaf.at[0] + leaf.size, leaf.at[1] + leaf.size, leaf.at[2] + leaf.size});
    const Vec3 half = 0.5 * (high - low), centre = low + half;
    return std::all_of(near.sweeps.begin(), near.sweeps.end(), [&](const Air::Sweep& s) {
        const Foot foot = foot_on(*s.shape, s.track, s.frame.to_tool(centre - s.from));
        return least_in(foot, s.frame, s.track.circular, half) >= -0.5 * tolerance_;
    });
}

/// One body of air, or two together, leave nothing of a cell that is thicker than a tolerance: distances are convex, so
/// its nodes tell. The sum of two distances bounds what lies between the bodies.
bool Fine::is_covered(const Near& near, const Leaf& leaf) const {
    const Vec3 low = leaves_.node(leaf.at),
               high = leaves_.node({leaf.at[0] + leaf.size, leaf.at[1] + leaf.size, leaf.at[2] + leaf.size});
    const std::array<Vec3, 8> corners = corners_of(low, high - low);
    const double size = length(high - low);
    std::vector<std::array<double, 8>> all;
    const auto take = [&](auto&& outside) {
        std::array<double, 8> f{};
        double most = -HUGE_VAL, least = HUGE_VAL;
        for (std::size_t i = 0; i < 8; ++i) {
            f[i] = outside(corners[i]);
            most = std::max(most, f[i]), least = std::min(least, f[i]);
            if (least > size) return false;
        }
        if (most <= 0.5 * tolerance_) return true;
        all.push_back(f);
        return false;
    };
    if (near.stock && take([&](Vec3 p) { return exact_.in_blank(p); })) return true;
    for (const Air::Sweep& s : near.sweeps)
        if (take([&](Vec3 p) {
                const Vec3 own = s.frame.to_tool(p - s.from);
                const Foot foot = foot_on(*s.shape, s.track, own);
                return foot.outside > 0 ? distance_from(*s.shape, own - foot.place) : foot.outside;  // at most
            }))
            return true;
    for (std::size_t i = 0; i < all.size(); ++i)
        for (std::size_t k = 0; k < i; ++k) {
            double sum = -HUGE_VAL;
            for (std::size_t c = 0; c < 8; ++c) sum = std::max(sum, all[i][c] + all[k][c]);
            if (sum <= tolerance_) return true;
        }
    return false;
}

/// In small leaves vertices reach out to what is left of tips (vertex_of), and what was looked for in the exact surface
/// (shown.hpp) tells of the rest: they are not asked what they may hide.
bool Fine::is_small(std::int32_t size) const {
    return length(leaves_.node({size, size, size}) - leaves_.node({0, 0, 0})) < small_leaf * tolerance_;
}

bool Fine::needs_split(const Near& near, const Leaf& leaf) const {
    if (is_far(near, leaf)) return false;
    bool narrow = false;
    int material = 0;
    for (int c = 0; c < 8; ++c)
        material += is_material({leaf.at[0] + (c & 1) * leaf.size, leaf.at[1] + (c >> 1 & 1) * leaf.size,
                                 leaf.at[2] + (c >> 2) * leaf.size})
                        ? 1
                        : 0;
    each_edge_of(leaf, [&](const ShortEdge& e) {
        const Known* k = known(e);
        narrow = narrow || (k != nullptr && k->narrow);
    });
    if (narrow) return true;
    if (is_small(leaf.size)) return false;
    if (material == 8) return !is_plain(near, leaf);
    return material == 0 && !is_covered(near, leaf);
}

/// As many edges for each as the last ones took. What would not end within the bound is not begun: the last round takes
/// most of the time (a wall thinner than the tolerance is halved all over), and what it asks for next is left all the
/// same.
bool Fine::has_room_for(std::size_t leaves) const {
    const double each =
        halved_ > 0 ? static_cast<double>(known_.size() - known_before_) / static_cast<double>(halved_) : 0;
    return static_cast<double>(known_.size()) + each * static_cast<double>(leaves) < static_cast<double>(most_known);
}

std::vector<Leaf> Fine::leaves_to_split() {
    // Cells that were halved, and those beside them, whose traces have changed.
    KeyMap active;
    for (const Place& c : dirty_)
        for (int dz = -1; dz <= 1; ++dz)
            for (int dy = -1; dy <= 1; ++dy)
                for (int dx = -1; dx <= 1; ++dx) active.add(key_of({c[0] + dx, c[1] + dy, c[2] + dz}), 1);
    std::vector<std::vector<std::uint32_t>> edges(all_.size());
    KeyMap number;
    for (std::uint32_t n = 0; n < all_.size(); ++n) number.add(key_of(all_[n]), n);
    for (std::uint32_t e = 0; e < edges_.size(); ++e)
        for (const Leaf& leaf : edges_[e].around) {
            const std::uint64_t cell = key_of(leaves_.cell_of(leaf.at));
            const std::uint32_t n = number.find(cell);
            if (n == KeyMap::none || active.find(cell) == KeyMap::none) continue;
            const ShortEdge& at = edges_[e].edge;
            if (tested_[static_cast<std::size_t>(at.axis)].find(key_of(at.at)) != likeness(e)) edges[n].push_back(e);
            break;
        }
    KeyMap dirty;
    for (const Place& c : dirty_) dirty.add(key_of(c), 1);
    std::vector<std::vector<Leaf>> found(all_.size());
    std::vector<std::vector<Leaf>> given_up(all_.size());
    std::vector<std::vector<std::uint32_t>> right(all_.size());
    base::for_all(all_.size(), [&](std::size_t n) {
        const bool own = dirty.find(key_of(all_[n])) != KeyMap::none;
        if (!own && edges[n].empty()) return;
        if (own) {
            const Near near = exact_.near(all_[n], false);
            leaves_.each_leaf(all_[n], [&](const Leaf& leaf) {
                if (leaf.size > usual_ && leaves_.is_of(leaf, round_) && needs_split(near, leaf))
                    found[n].push_back(leaf);
            });
        }
        for (const std::uint32_t e : edges[n]) {
            if (!is_off(all_[n], e, fine_sampled * tolerance_, fine_within * tolerance_)) {
                right[n].push_back(e);
                continue;
            }
            const std::size_t before = found[n].size();
            const auto halve_down_to = [&](std::int32_t size) {
                for (const Leaf& leaf : edges_[e].around)
                    if (leaf.size > size) found[n].push_back(leaf);
                return found[n].size() > before;
            };
            if (!halve_down_to(usual_) && is_off(all_[n], e, tolerance_, tolerance_) && !halve_down_to(smallest_))
                given_up[n].push_back(edges_[e].around[0]);
        }
    });
    std::vector<Leaf> split;
    for (std::size_t n = 0; n < all_.size(); ++n) {
        split.insert(split.end(), found[n].begin(), found[n].end());
        given_up_.insert(given_up_.end(), given_up[n].begin(), given_up[n].end());
        for (const std::uint32_t e : right[n]) {
            const ShortEdge& at = edges_[e].edge;
            tested_[static_cast<std::size_t>(at.axis)].set(key_of(at.at), likeness(e));
        }
    }
    const auto before = [](const Leaf& a, const Leaf& b) {
        return a.size != b.size ? a.size > b.size : key_of(a.at) < key_of(b.at);
    };
    std::sort(split.begin(), split.end(), before);
    split.erase(std::unique(split.begin(), split.end()), split.end());
    if (has_room_for(split.size())) return split;
    for (const Leaf& leaf : split) open_.push_back(box_of(leaf));
    return {};
}

}  // namespace obrys::sim::milling
