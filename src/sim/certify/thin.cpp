/// Whether a tool that goes through the part is nowhere deep in it: boxes that stand along what is thin.

#include <algorithm>
#include <array>
#include <cmath>

#include "sim/certify/certify.hpp"
#include "sim/certify/joined.hpp"

namespace obrys::sim::certify {

using geom::Vec3;

namespace {

constexpr std::size_t most_cells = 100'000;   ///< of a move
constexpr double smallest_cell = 0.125;       ///< of the depth
constexpr double smallest_across = 1.0 / 16;  ///< of the depth
constexpr double hardly_more = 1.04;  ///< of what is allowed: chords of a curve may stand off by half of the rest

/// A box along three unit vectors, half its size along each.
struct Cell {
    Vec3 centre;
    std::array<double, 3> half{};
};

using Axes = std::array<Vec3, 3>;

/// One of them as near to the tool's axis as may be: what the tool stands above, as a floor under a wall, is then below
/// all boxes.
Axes axes_along(Vec3 normal, Vec3 axis) {
    Vec3 first = cross(normal, axis);
    if (length(first) < 0.1) first = cross(normal, std::abs(normal.x) < 0.6 ? Vec3{1, 0, 0} : Vec3{0, 1, 0});
    const Vec3 u = (1 / length(first)) * first;
    return {normal, u, cross(normal, u)};
}

/// Of a body at rest.
double size_of(const Body& b) { return std::max({b.r0, b.r1, (b.z1 - b.z0) / 2}) + b.rounding; }

double reach_of(const Cell& c) { return std::hypot(c.half[0], c.half[1], c.half[2]); }

std::array<Vec3, 8> corners_of(const Cell& c, const Axes& axes) {
    std::array<Vec3, 8> all;
    for (std::size_t i = 0; i < all.size(); ++i) {
        all[i] = c.centre;
        for (std::size_t k = 0; k < 3; ++k) all[i] = all[i] + (i >> k & 1 ? c.half[k] : -c.half[k]) * axes[k];
    }
    return all;
}

/// Around a swept body.
Cell around_body(const Swept& whole, const Axes& axes) {
    Cell cell;
    for (std::size_t k = 0; k < 3; ++k) {
        const double high = extent(whole, axes[k]), low = -extent(whole, -1.0 * axes[k]);
        cell.half[k] = (high - low) / 2;
        cell.centre = cell.centre + ((high + low) / 2) * axes[k];
    }
    return cell;
}

/// Where it is longer than the body: of a long way of a small one most boxes lie beside that. Then across what is thin
/// until it is much thinner, then where it is longest.
std::array<Cell, 2> halves_of(const Cell& c, const Axes& axes, double depth, double body) {
    const auto longest = static_cast<std::size_t>(std::max_element(c.half.begin(), c.half.end()) - c.half.begin());
    const std::size_t k = c.half[longest] <= body && c.half[0] > smallest_across * depth ? 0 : longest;
    Cell low = c;
    low.half[k] /= 2;
    Cell high = low;
    low.centre = c.centre - low.half[k] * axes[k];
    high.centre = c.centre + low.half[k] * axes[k];
    return {low, high};
}

/// How far a box along the coordinates reaches from its centre along a unit vector.
double reach_along(const mesh::Box& box, Vec3 u) {
    const Vec3 half = 0.5 * box.size();
    return std::abs(u.x) * half.x + std::abs(u.y) * half.y + std::abs(u.z) * half.z;
}

bool lies_apart(const Cell& c, const Axes& axes, const mesh::Box& box) {
    for (std::size_t k = 0; k < 3; ++k)
        if (std::abs(dot(axes[k], box.centre() - c.centre)) > c.half[k] + reach_along(box, axes[k])) return true;
    return false;
}

/// For certain: along the box's axes or the triangle's normal.
bool lies_apart(const Cell& c, const Axes& axes, const Judge::Triangle& t, Vec3 normal) {
    double reach = 0;
    for (std::size_t k = 0; k < 3; ++k) {
        const auto at = [&](Vec3 p) { return dot(axes[k], p - c.centre); };
        const auto [low, high] = std::minmax({at(t[0]), at(t[1]), at(t[2])});
        if (low > c.half[k] || high < -c.half[k]) return true;
        reach += std::abs(dot(axes[k], normal)) * c.half[k];
    }
    return std::abs(dot(normal, t[0] - c.centre)) > reach;
}

/// False: it certainly does not, and lies on one side of it.
bool may_meet_surface(const mesh::Distance& part, const Cell& c, const Axes& axes) {
    bool met = false;
    part.visit([&](const mesh::Box& box) { return !lies_apart(c, axes, box); },
               [&](std::uint32_t t) {
                   met = !lies_apart(c, axes, corners(part.mesh(), t), part.normal(t));
                   return !met;
               });
    return met;
}

/// All of it, for certain.
bool is_outside(const mesh::Distance& part, const Cell& c, const Axes& axes) {
    return !part.is_inside(c.centre, part.nearest(c.centre)) && !may_meet_surface(part, c, axes);
}

/// Whether a plane beside it lies outside of the part that is no farther from any place in it than `depth`: then none
/// is deeper, since the way there leads through the surface.
bool is_near_outside(const mesh::Distance& part, const Cell& c, const Axes& axes, double depth) {
    if (c.half[0] > depth / 2) return false;
    Cell side = c;
    side.half[0] = 0;
    const Vec3 way = (depth - c.half[0]) * axes[0];
    for (const Vec3& centre : {c.centre - way, c.centre + way}) {
        side.centre = centre;
        if (is_outside(part, side, axes)) return true;
    }
    return false;
}

}  // namespace

/// A place is no deeper than it is far from any triangle; that distance is convex, so a box's corners bound it.
bool Judge::is_shallow(const Piece& whole, Vec3 normal, double depth, std::size_t& cells) const {
    const double body = size_of(whole.body);
    const Axes axes = axes_along(normal, whole.axis);
    std::vector<Cell> open{around_body(whole, axes)};
    while (!open.empty()) {
        const Cell cell = open.back();
        open.pop_back();
        if (cells-- == 0) return cells = 0, false;
        const double reach = reach_of(cell);
        if (geom::distance(cell.centre, nearest_within(whole, cell.centre)) > reach) continue;
        const mesh::Nearest place = part_.nearest(cell.centre);
        const bool inside = part_.is_inside(cell.centre, place);
        if ((inside ? place.distance : -place.distance) + reach <= depth) continue;
        if (!inside && !may_meet_surface(part_, cell, axes)) continue;
        if (is_near_outside(part_, cell, axes, depth)) continue;
        const auto triangle = corners(part_.mesh(), place.triangle);
        const auto all = corners_of(cell, axes);
        if (std::all_of(all.begin(), all.end(),
                        [&](Vec3 p) { return mesh::nearest_on_triangle(p, triangle).distance <= depth; }))
            continue;
        if (inside && place.distance > depth && geom::distance(cell.centre, nearest_within(whole, cell.centre)) <= 0)
            return false;
        if (reach < smallest_cell * depth) return false;
        for (const Cell& half : halves_of(cell, axes, depth, body)) open.push_back(half);
    }
    return true;
}

bool Judge::is_thin(const Move& move, Vec3 normal) const {
    std::vector<Piece> failing;
    if (clear_between(move, 0, 1, {allowed_, Of::part_in_stock}, &failing)) return true;
    std::size_t cells = most_cells;
    return length(normal) > 0.5 && !failing.empty() && std::all_of(failing.begin(), failing.end(), [&](const Piece& p) {
               return is_shallow(p, normal, allowed_ / 2, cells);
           });
}

bool Judge::holds_surface(const Piece& whole, const std::vector<Joined>& joined, double depth) const {
    const auto meets_inner = [&](const Body& body) {
        Swept inner = whole;
        inner.body = body;
        return meets(inner);
    };
    if (const std::optional<Body> core = core_of(whole.body, depth); core && meets_inner(*core)) return true;
    return std::any_of(joined.begin(), joined.end(), [&](const Joined& j) {
        if (!j.holds(whole.body)) return false;
        const Shape core = core_of(j, depth);
        return std::any_of(core.begin(), core.end(), meets_inner);
    });
}

bool Judge::is_no_deeper(const Move& move, Vec3 normal) const {
    std::vector<Piece> failing;
    if (clear_between(move, 0, 1, {allowed_, Of::part_in_stock}, &failing)) return true;
    if (!(length(normal) > 0.5) || failing.empty()) return false;
    const std::vector<Joined> joined = joined_in(*move.shape);
    std::size_t cells = most_cells;
    return std::all_of(failing.begin(), failing.end(), [&](const Piece& p) {
        return !holds_surface(p, joined, hardly_more * allowed_) && is_shallow(p, normal, allowed_, cells);
    });
}

}  // namespace obrys::sim::certify
