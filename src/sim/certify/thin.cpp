/// Whether a tool that goes through the part is nowhere deep in it: boxes that stand along what is thin.

#include <algorithm>
#include <array>
#include <cmath>

#include "sim/certify/certify.hpp"

namespace obrys::sim::certify {

using geom::Vec3;

namespace {

constexpr std::size_t most_cells = 100'000;  ///< of a move
constexpr double smallest_cell = 0.125;      ///< of the depth

/// A box along three unit vectors.
struct Cell {
    Vec3 centre, half;
};

using Axes = std::array<Vec3, 3>;

Axes axes_along(Vec3 normal) {
    const Vec3 aside = std::abs(normal.x) < 0.6 ? Vec3{1, 0, 0} : Vec3{0, 1, 0};
    const Vec3 first = cross(normal, aside), u = (1 / length(first)) * first;
    return {normal, u, cross(normal, u)};
}

std::array<Vec3, 8> corners_of(const Cell& c, const Axes& axes) {
    std::array<Vec3, 8> all;
    for (std::size_t i = 0; i < all.size(); ++i)
        all[i] = c.centre + (i % 2 == 0 ? -c.half.x : c.half.x) * axes[0] +
                 (i / 2 % 2 == 0 ? -c.half.y : c.half.y) * axes[1] + (i < 4 ? -c.half.z : c.half.z) * axes[2];
    return all;
}

/// Around a swept body.
Cell around_body(const Swept& whole, const Axes& axes) {
    Cell cell;
    const auto set = [&](std::size_t k, double& half) {
        const double high = extent(whole, axes[k]), low = -extent(whole, -1.0 * axes[k]);
        half = (high - low) / 2;
        cell.centre = cell.centre + ((high + low) / 2) * axes[k];
    };
    set(0, cell.half.x), set(1, cell.half.y), set(2, cell.half.z);
    return cell;
}

/// Across what is thin until it is as thin, then where it is longest.
std::array<Cell, 2> halves_of(const Cell& c, const Axes& axes, double depth) {
    const bool across = c.half.x > depth / 2 || (c.half.x >= c.half.y && c.half.x >= c.half.z);
    const std::size_t k = across ? 0 : c.half.y >= c.half.z ? 1 : 2;
    Cell low = c;
    double& half = k == 0 ? low.half.x : k == 1 ? low.half.y : low.half.z;
    half /= 2;
    Cell high = low;
    low.centre = c.centre - half * axes[k];
    high.centre = c.centre + half * axes[k];
    return {low, high};
}

}  // namespace

/// A place is no deeper than it is far from any triangle; that distance is convex, so a box's corners bound it.
bool Judge::is_shallow(const Piece& whole, Vec3 normal, std::size_t& cells) const {
    const double depth = allowed_ / 2;
    const Axes axes = axes_along(normal);
    std::vector<Cell> open{around_body(whole, axes)};
    while (!open.empty()) {
        const Cell cell = open.back();
        open.pop_back();
        if (cells-- == 0) return cells = 0, false;
        const double reach = length(cell.half);
        if (geom::distance(cell.centre, nearest_within(whole, cell.centre)) > reach) continue;
        const mesh::Nearest place = part_.nearest(cell.centre);
        const bool inside = part_.is_inside(cell.centre, place);
        if ((inside ? place.distance : -place.distance) + reach <= depth) continue;
        const auto triangle = corners(part_.mesh(), place.triangle);
        const auto all = corners_of(cell, axes);
        if (std::all_of(all.begin(), all.end(),
                        [&](Vec3 p) { return mesh::nearest_on_triangle(p, triangle).distance <= depth; }))
            continue;
        if (inside && place.distance > depth && geom::distance(cell.centre, nearest_within(whole, cell.centre)) <= 0)
            return false;
        if (reach < smallest_cell * depth) return false;
        for (const Cell& half : halves_of(cell, axes, depth)) open.push_back(half);
    }
    return true;
}

bool Judge::is_thin(const Move& move, Vec3 normal) const {
    std::vector<Piece> failing;
    if (clear_between(move, 0, 1, {allowed_, Of::part_in_stock}, &failing)) return true;
    std::size_t cells = most_cells;
    return length(normal) > 0.5 && !failing.empty() &&
           std::all_of(failing.begin(), failing.end(), [&](const Piece& p) { return is_shallow(p, normal, cells); });
}

}  // namespace obrys::sim::certify
