/// Where a tool that is not clear of the part is deepest in it.

#include <algorithm>
#include <array>
#include <cmath>

#include "sim/certify/certify.hpp"
#include "sim/certify/closest.hpp"

namespace obrys::sim::certify {

using geom::Vec3;

namespace {

constexpr double accuracy = 0.02;        ///< of what is allowed: the last steps of a search
constexpr std::size_t most_starts = 12;  ///< triangles from which a search begins
constexpr std::size_t climbs = 3;        ///< searches that are brought to their end
constexpr std::size_t most_pieces = 24;
constexpr int climb_steps = 60;
constexpr double edge_accuracy = 0.002;  ///< of what is allowed: how deep an edge lies in the tool
/// Times as deep as the tool in the part an edge may lie in the tool: that of an edge of 60 degrees. What goes through
/// something thin has all of its surface in the tool; twice its deepest place is its thickness, and no more than that.
constexpr double sharpest = 2;
constexpr double edge_from = 1.1;  ///< times as deep as the tool in the part lies the part's surface in the tool

Vec3 unit(Vec3 v) {
    const double size = length(v);
    return size > 0 ? (1 / size) * v : Vec3{};
}

/// Where on its way a body comes nearest to a place that it sweeps.
double along_of(const Swept& swept, Vec3 p) {
    const auto far = [&](double t) {
        const Swept there{swept.body, swept.from + t * swept.way, {}, swept.axis};
        return geom::distance(p, nearest_within(there, p));
    };
    double a = 0, b = 1;
    for (int i = 0; i < 40; ++i) {
        const double s = a + (b - a) / 3, t = b - (b - a) / 3;
        (far(s) <= far(t) ? b : a) = far(s) <= far(t) ? t : s;
    }
    return (a + b) / 2;
}

/// Of the box around a triangle what lies in another one.
mesh::Box common_of(const std::array<Vec3, 3>& c, const mesh::Box& own) {
    mesh::Box b;
    for (const Vec3& p : c) b.add(p);
    b.lo = {std::max(b.lo.x, own.lo.x), std::max(b.lo.y, own.lo.y), std::max(b.lo.z, own.lo.z)};
    b.hi = {std::min(b.hi.x, own.hi.x), std::min(b.hi.y, own.hi.y), std::min(b.hi.z, own.hi.z)};
    return b.empty() ? mesh::Box{} : b;
}

/// How wide the swept body is at a place within it along a direction of unit length.
double width_of(const Swept& swept, Vec3 p, Vec3 across) {
    const auto reach = [&](Vec3 way) {
        double in = 0, out = 1;
        const auto within = [&](double t) {
            const Vec3 q = p + t * way;
            return geom::distance(q, nearest_within(swept, q)) <= 1e-9;
        };
        while (out < 1e4 && within(out)) in = out, out *= 2;
        for (int i = 0; i < 40; ++i) (within((in + out) / 2) ? in : out) = (in + out) / 2;
        return in;
    };
    return reach(across) + reach(-1.0 * across);
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
    if (within_ && s.depth > 0) s.depth = std::min(s.depth, within_(p));
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

/// Places of the swept body at triangles that it meets, the deepest first; never none.
std::vector<Judge::Spot> Judge::starts_in(const Swept& whole, std::size_t most, mesh::Box& extent) const {
    Swept inner = whole;
    inner.body = shrunk(whole.body, allowed_, Inwards::middle);
    const std::vector<std::uint32_t> met = met_by(inner);
    const mesh::Box own = box_of(whole);
    std::vector<Spot> starts;
    for (const std::uint32_t t : some_of(met, most)) {
        const auto c = corners(part_.mesh(), t);
        extent.add(common_of(c, own));
        starts.push_back(spot_at(nearest_within(whole, closest(inner, c, to_the_end).on_other)));
        const Vec3 down = -1.0 * part_.normal(t);
        starts.push_back(spot_at(support(whole, down) + whole.body.rounding * down));
    }
    // What the tool has of a corner lies between them.
    Vec3 middle;
    for (const Spot& s : starts) middle = middle + (1.0 / static_cast<double>(starts.size())) * s.at;
    if (starts.size() > 1) starts.push_back(spot_at(nearest_within(whole, middle)));
    if (starts.empty()) starts.push_back(spot_at(whole.from + (0.5 * (whole.body.z0 + whole.body.z1)) * whole.axis));
    std::stable_sort(starts.begin(), starts.end(), [](const Spot& a, const Spot& b) { return a.depth > b.depth; });
    return starts;
}

Judge::Spot Judge::deepest_of(const Swept& whole, mesh::Box& extent) const {
    const std::vector<Spot> starts = starts_in(whole, most_starts, extent);
    Spot best;
    for (std::size_t i = 0; i < std::min(climbs, starts.size()); ++i) {
        const Spot s = climb(whole, starts[i], climb_steps);
        if (s.depth > best.depth) best = s;
    }
    if (best.depth > allowed_) return best;
    for (const Spot& s : around(whole, starts)) {
        const Spot deeper = climb(whole, s, climb_steps);
        if (deeper.depth > best.depth) best = deeper;
    }
    return best;
}

/// From corners and edges of the part no single step may lead inwards: the deepest places in all directions beside
/// them.
std::vector<Judge::Spot> Judge::around(const Swept& whole, const std::vector<Spot>& starts) const {
    std::vector<Spot> all;
    for (const Spot& s : some_of(starts, most_starts))
        for (const double far : {0.7 * allowed_, 3 * allowed_})
            for (int i = 0; i < 27; ++i) {
                const Vec3 way = unit({i % 3 - 1.0, i / 3 % 3 - 1.0, i / 9 - 1.0});
                all.push_back(spot_at(nearest_within(whole, s.place.at + far * way)));
            }
    std::stable_sort(all.begin(), all.end(), [](const Spot& a, const Spot& b) { return a.depth > b.depth; });
    all.resize(std::min(all.size(), climbs));
    return all;
}

/// How deep the part's surface lies in the swept body, where that is between `depth` and `most`.
double Judge::edge_depth(const Swept& whole, double depth, double most) const {
    const auto reached = [&](double d) {
        const std::optional<Body> core = core_of(whole.body, d);
        if (!core) return false;
        Swept inner = whole;
        inner.body = *core;
        const std::vector<std::uint32_t> met = met_by(inner);
        // Doubt counts as met there; here a place that lies in it is wanted.
        return std::any_of(met.begin(), met.end(), [&](std::uint32_t t) {
            const Vec3 p = closest(inner, corners(part_.mesh(), t), to_the_end).on_other;
            return geom::distance(p, nearest_within(inner, p)) < 1e-6;
        });
    };
    double low = depth + edge_accuracy * allowed_, high = most;
    if (high <= low || !reached(low)) return depth;
    if (reached(high)) return high;
    while (high - low > edge_accuracy * allowed_) {
        const double middle = (low + high) / 2;
        (reached(middle) ? low : high) = middle;
    }
    return high;  // what may be too deep is not left out
}

/// How far tool and material reach together along a line from a place: through what is thin.
double Judge::reach_along(const Swept& whole, Vec3 from, Vec3 direction) const {
    const auto within = [&](Vec3 p) { return geom::distance(p, nearest_within(whole, p)) <= 1e-7; };
    double way = 0;
    for (int i = 0; i < climb_steps; ++i) {
        const Vec3 p = from + way * direction;
        const double deep = spot_at(p).depth;
        if (!(deep > accuracy * allowed_) || !within(p)) break;
        way += deep;
    }
    double low = 0;  // the last step may lead out of the tool
    while (way - low > accuracy * allowed_ && !within(from + way * direction)) {
        const double middle = (low + way) / 2;
        (within(from + middle * direction) ? low : way) = middle;
    }
    return way;
}

Depth Judge::deepest(const Move& move) const {
    Depth out;
    std::vector<Piece> failing;
    if (clear_between(move, 0, 1, allowed_, &failing) || failing.empty()) return out;
    const std::vector<Piece> pieces = some_of(failing, most_pieces);
    Spot best;
    for (std::size_t i = 0; i < pieces.size(); ++i) {
        Spot s = deepest_of(pieces[i].whole, out.extent);
        s.piece = i;
        if (s.depth > best.depth) best = s;
    }
    const Piece* piece = &pieces[best.piece];
    if (failing.size() > pieces.size())
        for (const Piece& p : failing) {
            const Spot start = spot_at(nearest_within(p.whole, best.at));
            if (!(start.depth > 0.5 * best.depth)) continue;
            const Spot s = climb(p.whole, start, climb_steps);
            if (s.depth > best.depth) best = s, piece = &p;
        }
    best = polished(piece->whole, best);
    if (!(best.depth > 0)) return out;
    out.at = best.at;
    out.surface = best.place.at;
    out.triangle = best.place.triangle;
    out.normal = unit(best.place.at - best.at);
    const double through =
        reach_along(piece->whole, best.at, out.normal) + reach_along(piece->whole, best.at, -1.0 * out.normal);
    out.depth = through > best.depth + 4 * accuracy * allowed_ ? through : best.depth;
    const bool in_stock = best.depth > 0.999 * best.place.distance;
    for (const Piece& p : pieces) {
        const double d = in_stock ? edge_depth(p.whole, out.depth, sharpest * best.depth) : out.depth;
        if (d > out.depth * edge_from) out.edge = true;
        out.depth = std::max(out.depth, d);
    }
    out.along = piece->u0 + along_of(piece->whole, best.at) * (piece->u1 - piece->u0);
    Vec3 across = unit(cross(out.normal, piece->whole.way));
    if (across == Vec3{})
        across = unit(cross(out.normal, std::abs(out.normal.x) < 0.9 ? Vec3{1, 0, 0} : Vec3{0, 1, 0}));
    out.width = width_of(piece->whole, nearest_within(piece->whole, best.place.at), across);
    out.upper = std::max(out.depth, upper_bound(move, out.depth));
    return out;
}

double Judge::rough(const Move& move) const {
    constexpr std::size_t few = 3;
    constexpr int few_steps = 8;
    std::vector<Piece> failing;
    if (clear_between(move, 0, 1, allowed_, &failing)) return 0;
    mesh::Box extent;
    double deepest = 0;
    for (const Piece& p : some_of(failing, few))
        deepest = std::max(deepest, climb(p.whole, starts_in(p.whole, few, extent).front(), few_steps).depth);
    return deepest;
}

}  // namespace obrys::sim::certify
