/// How deep a tool is at the deepest place that was found: its way through what is thin, edges.

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

#include "sim/certify/certify.hpp"
#include "sim/certify/closest.hpp"
#include "sim/certify/joined.hpp"

namespace obrys::sim::certify {

using geom::Vec3;

namespace {

constexpr double depth_accuracy = 0.02;  ///< of what is allowed
constexpr double edge_accuracy = 0.002;  ///< of what is allowed: how deep an edge lies in the tool
constexpr int most_reaches = 60;
/// Times as deep as the tool in the part an edge may lie in the tool: that of an edge of 60 degrees. What goes through
/// something thin has all of its surface in the tool; twice its deepest place is its thickness, and no more than that.
constexpr double sharpest = 2;
constexpr double as_deep = 0.9;        ///< of the deepest: in the middle of the same thin thing
constexpr double thickest = 2.2;       ///< times as deep as its deepest place is something thin
constexpr double ahead = 0.5;          ///< cosine
constexpr double almost_whole = 1.98;  ///< times as deep as its deepest place is what is thin
constexpr double edge_from = 1.1;      ///< times as deep as the tool in the part lies the part's surface in the tool

Vec3 unit_of(Vec3 v) {
    const double size = length(v);
    return size > 0 ? (1 / size) * v : Vec3{};
}

bool is_in(const mesh::Box& box, Vec3 p) {
    return p.x >= box.lo.x && p.y >= box.lo.y && p.z >= box.lo.z && p.x <= box.hi.x && p.y <= box.hi.y &&
           p.z <= box.hi.z;
}

/// How wide the swept body is at a place within it along a direction of unit length: as far as the part goes, which a
/// long tool stands out of.
double width_of(const Swept& swept, const mesh::Box& part, Vec3 p, Vec3 across) {
    const bool in_part = is_in(part, p);
    const auto reach = [&](Vec3 way) {
        double in = 0, out = 1;
        const auto within = [&](double t) {
            const Vec3 q = p + t * way;
            return (!in_part || is_in(part, q)) && geom::distance(q, nearest_within(swept, q)) <= 1e-9;
        };
        while (out < 1e4 && within(out)) in = out, out *= 2;
        for (int i = 0; i < 40; ++i) (within((in + out) / 2) ? in : out) = (in + out) / 2;
        return in;
    };
    return reach(across) + reach(-1.0 * across);
}

}  // namespace

/// How deep the part's surface lies in a body that `core` makes smaller, where that is between `depth` and `most`.
double Judge::edge_depth(const Swept& whole, const Core& core, double depth, double most) const {
    const auto meets_inner = [&](const Body& body) {
        Swept inner = whole;
        inner.body = body;
        const std::vector<std::uint32_t> met = met_by(inner);
        // Doubt counts as met there; here a place that lies in it is wanted.
        return std::any_of(met.begin(), met.end(), [&](std::uint32_t t) {
            const Vec3 p = closest(inner, corners(part_.mesh(), t), to_the_end).on_other;
            return geom::distance(p, nearest_within(inner, p)) < 1e-6;
        });
    };
    const auto reached = [&](double d) {
        const Shape inner = core(d);
        return std::any_of(inner.begin(), inner.end(), meets_inner);
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

/// How far tool and material reach together along a line from a place, `most` at most: through what is thin.
double Judge::reach_along(const Swept& whole, Vec3 from, Vec3 direction, double most) const {
    const auto within = [&](Vec3 p) { return geom::distance(p, nearest_within(whole, p)) <= 1e-7; };
    double way = 0;
    for (int i = 0; i < most_reaches && way <= most; ++i) {
        const Vec3 p = from + way * direction;
        const double deep = spot_at(p).depth;
        if (!(deep > depth_accuracy * allowed_) || !within(p)) break;
        way += deep;
    }
    double low = 0;  // the last step may lead out of the tool
    while (way - low > depth_accuracy * allowed_ && !within(from + way * direction)) {
        const double middle = (low + way) / 2;
        (within(from + middle * direction) ? low : way) = middle;
    }
    return way;
}

/// The way through the material at the deepest place, which lies in the middle of what is thin. Also at places beside
/// it that are nearly as deep, if the way leads out of the part at both ends: where a wall stands on a floor that is
/// cut into as well, the deepest place has their corner nearest to it, and the way there leaves the tool. Not much more
/// than twice as deep: else it is not thin there.
double Judge::through(const Spot& spot) const {
    const double least = 4 * depth_accuracy * allowed_, most = thickest * spot.depth + least;
    const auto both_ways = [&](const Spot& s, bool out) {
        const Vec3 way = unit_of(s.place.at - s.at);
        double both = 0;
        for (const Vec3& w : {way, -1.0 * way}) {
            const double reach = reach_along(*spot.piece, s.at, w, most);
            const Spot end = spot_at(s.at + reach * w);
            if (out && end.depth > least) return 0.0;
            // Where the tool ends first, what is thin has its other side ahead: at the rim of a pocket it lies aside.
            if (end.depth > least && dot(unit_of(end.place.at - end.at), w) < ahead) return 0.0;
            both += reach;
        }
        return both <= most ? both : 0;
    };
    double through = both_ways(spot, false);
    const Vec3 along = unit_of(spot.piece->way), across = unit_of(cross(spot.piece->axis, along));
    const auto look = [&](Vec3 aside, std::span<const double> far) {
        for (const double f : far) {
            if (through > almost_whole * spot.depth) return;
            const Spot s = spot_at(nearest_within(*spot.piece, spot.at + f * spot.depth * aside));
            if (s.depth >= as_deep * spot.depth) through = std::max(through, both_ways(s, true));
        }
    };
    constexpr std::array near{-1.5, -0.75, 0.75, 1.5};
    constexpr std::array far{-6.0, -5.0, -4.0, -3.0, -2.25, -1.5, -0.75, 0.75, 1.5, 2.25, 3.0, 4.0, 5.0, 6.0};
    for (const Vec3& aside : {spot.piece->axis, along, across}) look(aside, near);
    // All over the middle of what is thin a tool is as deep: the place that was found may lie at its tip or flank,
    // where it is not as wide as what it goes through.
    const Vec3 normal = unit_of(spot.place.at - spot.at), up = unit_of(cross(normal, cross(spot.piece->axis, normal)));
    for (const Vec3& aside : {up, cross(normal, up)}) look(aside, far);
    return through > spot.depth + least ? through : spot.depth;
}

Depth Judge::at_spot(const Spot& spot) {
    return {spot.depth, spot.at, spot.place.at, unit_of(spot.place.at - spot.at)};
}

/// One chord of a curve may end in the middle of what the next one goes through.
double Judge::through_any(const std::vector<Piece>& pieces, const Spot& best) const {
    double deepest = through(best);
    std::size_t looked = 0;
    for (const Piece& p : pieces) {
        if (deepest >= sharpest * best.depth || looked == whole_effort.pieces) break;
        if (&p == best.piece || geom::distance(nearest_within(p, best.at), best.at) > 1e-7) continue;
        Spot same = best;
        same.piece = &p;
        deepest = std::max(deepest, through(same));
        ++looked;
    }
    return deepest;
}

Judge::Spot Judge::climbed_from(const std::vector<Piece>& pieces, Vec3 from) const {
    Spot best;
    for (const Piece& p : pieces) {
        Spot s = spot_at(nearest_within(p, from));
        s.piece = &p;
        if (s.depth > best.depth) best = s;
    }
    if (best.piece == nullptr) return best;
    const Piece* piece = best.piece;
    best = climb(*piece, best, most_reaches);
    best.piece = piece;
    return best;
}

std::optional<Depth> Judge::deepest(const Move& move, std::optional<Vec3> from) const {
    std::vector<Piece> failing;
    if (clear_between(move, 0, 1, {allowed_, Of::part}, &failing) || failing.empty()) return {};
    Spot best = from ? climbed_from(failing, *from) : Spot{};
    best = deepest_of(failing, best, whole_effort);
    if (best.piece == nullptr) return {};
    const Piece* piece = best.piece;
    best = polished(*piece, best);
    best.piece = piece;
    if (!(best.depth > 0)) return {};
    Depth out = at_spot(best);
    out.depth = through_any(failing, best);
    measure_edge(*move.shape, failing, best, out);
    Vec3 across = unit_of(cross(out.normal, piece->way));
    if (across == Vec3{})
        across = unit_of(cross(out.normal, std::abs(out.normal.x) < 0.9 ? Vec3{1, 0, 0} : Vec3{0, 1, 0}));
    out.width = width_of(*piece, box_, nearest_within(*piece, best.place.at), across);
    return out;
}

/// Where an edge lies deeper in the tool than the tool in the part.
void Judge::measure_edge(const Shape& shape, const std::vector<Piece>& pieces, const Spot& best, Depth& out) const {
    const bool in_stock = best.depth > 0.999 * best.place.distance;
    if (!in_stock) return;
    const double through = out.depth;
    const std::vector<Joined> joined = joined_in(shape);
    const std::size_t some = std::min<std::size_t>(pieces.size(), whole_effort.pieces);
    for (std::size_t i = 0; i <= some; ++i) {
        const Piece& p = i == some ? *best.piece : pieces[i * pieces.size() / some];
        const auto core = [&](double d) {
            const std::optional<Body> body = core_of(p.body, d);
            return body ? Shape{*body} : Shape{};
        };
        out.depth = std::max(out.depth, edge_depth(p, core, out.depth, sharpest * best.depth));
        // What lies at a ring between two bodies lies deep in neither.
        for (const Joined& j : joined)
            if (j.holds(p.body)) {
                const auto inner = [&](double d) { return core_of(j, d); };
                out.depth = std::max(out.depth, edge_depth(p, inner, out.depth, sharpest * best.depth));
            }
    }
    out.edge = out.depth > through * edge_from;
}

std::optional<Depth> Judge::rough(const Move& move) const {
    std::vector<Piece> failing;
    if (clear_between(move, 0, 1, {allowed_, Of::part}, &failing)) return {};
    const Spot best = deepest_of(failing, {}, rough_effort);
    if (best.piece == nullptr || !(best.depth > 0)) return {};
    return at_spot(best);
}

}  // namespace obrys::sim::certify
