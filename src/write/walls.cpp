#include "write/walls.hpp"

#include <algorithm>
#include <cmath>

#include "base/whole.hpp"

namespace obrys::write {

namespace {

using geom::Vec2;

constexpr double chord_error = 5e-4;  ///< mm, of arcs

double distance_to(const Vec2& p, const Vec2& from, const Vec2& to) {
    const Vec2 way = to - from;
    const double length = geom::dot(way, way);
    const double t = length > 0 ? std::clamp(geom::dot(p - from, way) / length, 0.0, 1.0) : 0;
    return geom::distance(from + t * way, p);
}

/// Of two straight ways; 0 where they cross.
double distance_between(const Vec2& a, const Vec2& b, const Vec2& c, const Vec2& d) {
    const bool apart = (geom::cross(b - a, c - a) > 0) == (geom::cross(b - a, d - a) > 0) ||
                       (geom::cross(d - c, a - c) > 0) == (geom::cross(d - c, b - c) > 0);
    if (!apart) return 0;
    return std::min({distance_to(a, c, d), distance_to(b, c, d), distance_to(c, a, b), distance_to(d, a, b)});
}

std::uint64_t key(std::int64_t x, std::int64_t y) {
    constexpr unsigned half = 32;
    return static_cast<std::uint64_t>(x) << half ^ (static_cast<std::uint64_t>(y) & 0xFFFF'FFFFU);
}

}  // namespace

/// Nothing where a way spans more of them than are worth looking through, or lies where no cell has a number.
std::optional<Walls::Cells> Walls::cells_of(const Vec2& from, const Vec2& to, double around, double most) const {
    const auto cell = [&](double coordinate) { return std::floor(coordinate / (2 * radius_)); };
    const double x0 = cell(std::min(from.x, to.x) - around), x1 = cell(std::max(from.x, to.x) + around);
    const double y0 = cell(std::min(from.y, to.y) - around), y1 = cell(std::max(from.y, to.y) + around);
    if (!((x1 - x0 + 1) * (y1 - y0 + 1) <= most)) return std::nullopt;
    const auto whole = [](double v) { return base::whole<std::int64_t>(v, -most_cell, most_cell); };
    const auto left = whole(x0), right = whole(x1), low = whole(y0), high = whole(y1);
    if (!left || !right || !low || !high) return std::nullopt;
    return Cells{*left, *right, *low, *high};
}

void Walls::add_piece(Vec2 from, Vec2 to) {
    constexpr double most = 16;  // a piece is as long as a cell at most, but where a line is cut into all it may be
    const auto at = static_cast<std::uint32_t>(pieces_.size());
    pieces_.push_back({from, to});
    const std::optional<Cells> in = cells_of(from, to, 0, most);
    if (!in) return wide_.push_back(at);
    for (std::int64_t x = in->left; x <= in->right; ++x)
        for (std::int64_t y = in->low; y <= in->high; ++y) cells_[key(x, y)].push_back(at);
}

void Walls::add_line(Vec2 from, Vec2 to) {
    const double pieces = std::min(std::max(1.0, std::ceil(geom::distance(from, to) / (2 * radius_))), 1e5);
    for (double k = 0; k < pieces && !is_full(); ++k)
        add_piece(from + (k / pieces) * (to - from), from + ((k + 1) / pieces) * (to - from));
}

void Walls::add_arc(Vec2 centre, double radius, double start, double sweep) {
    const double chord = radius > chord_error ? 2 * std::acos(1 - chord_error / radius) : geom::pi;
    const double pieces = std::min(std::max(1.0, std::ceil(std::abs(sweep) / chord)), 1e5);
    const auto at = [&](double k) {
        const double angle = start + sweep * k / pieces;
        return centre + radius * Vec2{std::cos(angle), std::sin(angle)};
    };
    for (double k = 0; k < pieces && !is_full(); ++k) add_line(at(k), at(k + 1));
}

double Walls::clearance(Vec2 from, Vec2 to) const {
    double nearest = radius_;
    const auto look = [&](const Piece& p) { nearest = std::min(nearest, distance_between(from, to, p.from, p.to)); };
    // A long way of a small tool spans more cells than there are pieces.
    const std::optional<Cells> in = cells_of(from, to, radius_, static_cast<double>(pieces_.size()));
    if (!in) {
        std::for_each(pieces_.begin(), pieces_.end(), look);
        return nearest;
    }
    for (const std::uint32_t piece : wide_) look(pieces_[piece]);
    for (std::int64_t x = in->left; x <= in->right; ++x) {
        for (std::int64_t y = in->low; y <= in->high; ++y) {
            const auto found = cells_.find(key(x, y));
            if (found == cells_.end()) continue;
            for (const std::uint32_t piece : found->second) look(pieces_[piece]);
        }
    }
    return nearest;
}

double Walls::cut(Vec2 a, Vec2 corner, Vec2 b) const {
    const double ends = std::min(clearance(a, a), clearance(b, b));
    return std::max(0.0, ends - std::min(clearance(a, corner), clearance(corner, b)));
}

}  // namespace obrys::write
