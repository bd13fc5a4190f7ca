/// Where a tool that is not clear of the part is deepest in it.

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numeric>

#include "sim/certify/certify.hpp"
#include "sim/certify/closest.hpp"

namespace obrys::sim::certify {

using geom::Vec3;

namespace {

constexpr double accuracy = 0.02;  ///< of what is allowed: the last steps of a search
constexpr int climb_steps = 60;
constexpr int most_rounds = 12;      ///< of rising
constexpr double next_share = 0.05;  ///< of a depth and of what is allowed: what is looked for next is deeper by that
constexpr double vain_times = 2;     ///< times as deep, where nothing was found
constexpr std::size_t most_patches = 48;  ///< of triangles that touch each other, from which a search begins

Vec3 unit(Vec3 v) {
    const double size = length(v);
    return size > 0 ? (1 / size) * v : Vec3{};
}

/// So many of a list, evenly spread.
template <class T>
std::vector<T> some_of(const std::vector<T>& all, std::size_t most) {
    if (all.size() <= most) return all;
    std::vector<T> some;
    for (std::size_t i = 0; i < most; ++i) some.push_back(all[i * (all.size() - 1) / (most - 1)]);
    return some;
}

}  // namespace

Judge::Spot Judge::spot_at(Vec3 p) const {
    Spot s;
    s.at = p;
    s.place = part_.nearest(p);
    if (!std::isfinite(s.place.distance)) return s;
    s.depth = part_.is_inside(p, s.place) ? s.place.distance : -s.place.distance;
    if (known_.judged && s.depth > 0) s.depth = std::abs(known_.judged(p, -s.depth));
    if (before_.depth && s.depth > 0) s.depth = std::min(s.depth, before_.depth(p));
    return s;
}

/// The direction in which it becomes deeper at a place.
Vec3 Judge::inwards_at(const Spot& spot) const {
    const Vec3 off = spot.at - spot.place.at;
    if (!(spot.place.distance > 1e-9)) return -1.0 * part_.normal(spot.place.triangle);
    return unit(spot.depth > 0 ? off : -1.0 * off);
}

/// Upwards in depth within the swept body, in steps that become shorter; the depth is concave where the part is convex.
/// Where two faces are as near, the way between their directions leads on.
Judge::Spot Judge::climb(const Swept& whole, Spot best, int steps) const {
    const double least = accuracy * allowed_;
    double step = std::max(whole.body.rounding + std::max(whole.body.r0, whole.body.r1), 4 * least);
    for (int i = 0; i < steps && step > least; ++i) {
        const Vec3 inner = inwards_at(best);
        const auto at = [&](Vec3 way) { return spot_at(nearest_within(whole, best.at + step * way)); };
        const auto better = [&](const Spot& s) { return s.depth > best.depth + 1e-3 * least; };
        Spot next = at(inner);
        if (!better(next)) next = at(unit(inner + inwards_at(next)));
        if (!better(next)) {
            const Vec3 aside = unit(cross(inner, std::abs(inner.x) < 0.6 ? Vec3{1, 0, 0} : Vec3{0, 1, 0}));
            const Vec3 askew = cross(inner, aside);
            for (const Vec3& way : {aside, -1.0 * aside, askew, -1.0 * askew})
                if (!better(next)) next = at(unit(way + inner));
            for (const Vec3& way : {aside, -1.0 * aside, askew, -1.0 * askew})
                if (!better(next)) next = at(way);
        }
        if (better(next))
            best = next;
        else
            step *= 0.4;
    }
    return best;
}

/// The last of it: steps in directions all round, others each time, since the way up a ridge may be narrow.
Judge::Spot Judge::polished(const Swept& whole, Spot best) const {
    const double least = accuracy * allowed_;
    constexpr int directions = 60;
    constexpr double turn = 2.399963229728653;  // the golden angle
    int n = 0;
    for (double step = std::max(best.depth, 4 * least); step > least;) {
        Spot next;
        for (int i = 0; i < directions && !(next.depth > best.depth + 1e-2 * least); ++i, ++n) {
            const double z = 1 - (2.0 * i + 1) / directions, r = std::sqrt(1 - z * z);
            const Vec3 way{r * std::cos(n * turn), r * std::sin(n * turn), z};
            next = spot_at(nearest_within(whole, best.at + step * way));
        }
        if (next.depth > best.depth + 1e-2 * least)
            best = next;
        else
            step *= 0.6;
    }
    return best;
}

const Judge::Effort Judge::whole_effort{12, 4, 14, 3, 24, 6};
const Judge::Effort Judge::rough_effort{3, 2, 8, 1, 3, 2};

/// Triangles that have corners in common, together; the largest patch first.
std::vector<std::vector<std::uint32_t>> Judge::patches_of(const std::vector<std::uint32_t>& met) const {
    std::map<std::uint32_t, std::size_t> at_corner;  // the first triangle there
    std::vector<std::size_t> parent(met.size());
    std::iota(parent.begin(), parent.end(), std::size_t{0});
    const auto root = [&](std::size_t i) {
        while (parent[i] != i) i = parent[i] = parent[parent[i]];
        return i;
    };
    for (std::size_t i = 0; i < met.size(); ++i)
        for (const std::uint32_t v : part_.mesh().triangles[met[i]]) {
            const auto [first, added] = at_corner.try_emplace(v, i);
            if (!added) parent[root(i)] = root(first->second);
        }
    std::map<std::size_t, std::vector<std::uint32_t>> by_root;
    for (std::size_t i = 0; i < met.size(); ++i) by_root[root(i)].push_back(met[i]);
    std::vector<std::vector<std::uint32_t>> patches;
    for (auto& [at, patch] : by_root) patches.push_back(std::move(patch));
    std::stable_sort(patches.begin(), patches.end(), [](const auto& a, const auto& b) { return a.size() > b.size(); });
    return patches;
}

/// Places of the swept body at triangles that it meets, some at each patch of them, so that a few beside very many are
/// not overlooked; the deepest of each patch first, the deepest first among these. Never none.
std::vector<Judge::Spot> Judge::starts_in(const Swept& whole, const Met& met, double depth,
                                          const Effort& effort) const {
    const auto deeper = [](const Spot& a, const Spot& b) { return a.depth > b.depth; };
    const auto patches = some_of(patches_of(met.triangles), most_patches);
    std::vector<Spot> firsts, others;
    for (const std::vector<std::uint32_t>& patch : patches) {
        std::vector<Spot> own;
        for (const std::uint32_t t : some_of(patch, std::max<std::size_t>(2, effort.starts / patches.size()))) {
            const Vec3 on = closest(met.inner, corners(part_.mesh(), t), to_the_end).on_other;
            const Vec3 down = -1.0 * part_.normal(t);
            own.push_back(spot_at(nearest_within(whole, on)));
            own.push_back(spot_at(nearest_within(whole, on + depth * down)));
            own.push_back(spot_at(support(whole, down) + whole.body.rounding * down));
        }
        // What the tool has of a corner lies between them.
        Vec3 middle;
        for (const Spot& s : own) middle = middle + (1.0 / static_cast<double>(own.size())) * s.at;
        own.push_back(spot_at(nearest_within(whole, middle)));
        std::stable_sort(own.begin(), own.end(), deeper);
        firsts.push_back(own.front());
        others.insert(others.end(), own.begin() + 1, own.end());
    }
    if (firsts.empty()) firsts.push_back(spot_at(whole.from + (0.5 * (whole.body.z0 + whole.body.z1)) * whole.axis));
    std::stable_sort(firsts.begin(), firsts.end(), deeper);
    std::stable_sort(others.begin(), others.end(), deeper);
    firsts.resize(std::min(firsts.size(), std::max<std::size_t>(2, effort.climbs)));
    firsts.insert(firsts.end(), others.begin(), others.end());
    return firsts;
}

/// From corners and edges of the part no single step may lead inwards: the deepest places in all directions beside
/// them.
Judge::Spot Judge::around(const Swept& whole, const std::vector<Spot>& starts, Spot best) const {
    std::vector<Spot> all;
    for (const Spot& s : some_of(starts, whole_effort.starts))
        for (const double far : {0.7 * allowed_, 3 * allowed_})
            for (int i = 0; i < 27; ++i) {
                const Vec3 way = unit({i % 3 - 1.0, i / 3 % 3 - 1.0, i / 9 - 1.0});
                all.push_back(spot_at(nearest_within(whole, s.place.at + far * way)));
            }
    std::stable_sort(all.begin(), all.end(), [](const Spot& a, const Spot& b) { return a.depth > b.depth; });
    all.resize(std::min(all.size(), whole_effort.climbs));
    for (const Spot& s : all) {
        const Spot deeper = climb(whole, s, climb_steps);
        if (deeper.depth > best.depth) best = deeper;
    }
    return best;
}

double Judge::more_than(double depth) const {
    return std::max(allowed_, depth + next_share * (std::max(depth, 0.0) + allowed_));
}

/// The deepest place of a swept body, `best` where none is deeper. What a search finds is made the depth by which the
/// body is made smaller, and what it meets then leads the next one: a shallow floor, however large, is left behind by
/// what is deeper beside it. Until nothing is met, or twice as deep is looked for in vain: an edge, something thin.
Judge::Spot Judge::risen(const Piece& whole, Spot best, const Effort& effort) const {
    double depth = more_than(best.depth);
    for (int round = 0, vain = 0; round < most_rounds && vain < effort.vain; ++round) {
        if (clear_piece(whole, {depth, Of::part_in_stock})) break;
        const Met met = fewest_met(whole, depth);
        if (met.clear) break;
        const std::vector<Spot> starts = starts_in(whole, met, depth, effort);
        Spot found;
        for (std::size_t i = 0; i < std::min(effort.climbs, starts.size()); ++i) {
            const Spot s = climb(whole, starts[i], effort.steps);
            if (s.depth > found.depth) found = s;
        }
        if (effort.steps > rough_effort.steps) found = climb(whole, found, climb_steps);
        if (!(std::max(found.depth, best.depth) > allowed_) && round == 0 && effort.steps > rough_effort.steps)
            found = around(whole, starts, found);
        if (found.depth > best.depth) best = found, best.piece = &whole;
        if (best.depth >= depth)
            depth = more_than(best.depth);
        else
            ++vain, depth *= vain_times;
    }
    return best;
}

/// Of all pieces: some of them, then each in which something deeper may be, those first that are clear of least.
Judge::Spot Judge::deepest_of(const std::vector<Piece>& pieces, Spot best, const Effort& effort) const {
    std::vector<const Piece*> all;
    for (const Piece& p : pieces) all.push_back(&p);
    const std::vector<const Piece*> some = some_of(all, effort.pieces);
    for (const Piece* p : some) best = risen(*p, best, effort);
    if (some.size() == all.size()) return best;
    double depth = more_than(best.depth);
    for (std::size_t vain = 0; vain < effort.more; ++vain) {
        std::vector<const Piece*> left = all;
        for (double d = depth; d < depth * 9; d *= vain_times) {
            std::vector<const Piece*> deeper;
            for (const Piece* p : left)
                if (!clear_piece(*p, {d, Of::part_in_stock})) deeper.push_back(p);
            if (deeper.empty()) break;
            left = std::move(deeper);
        }
        if (left.size() == all.size() && clear_piece(*left.front(), {depth, Of::part_in_stock})) break;
        const Piece* p = left[vain * left.size() / effort.more];
        const Spot s = risen(*p, best, effort);
        if (s.depth >= depth) vain = 0;
        best = s;
        depth = more_than(best.depth);
    }
    return best;
}

}  // namespace obrys::sim::certify
