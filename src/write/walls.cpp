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

std::int64_t Walls::cell(double coordinate) const {
    return base::whole<std::int64_t>(std::floor(coordinate / (2 * radius_)), 0).value_or(0);
}

void Walls::add_piece(Vec2 from, Vec2 to) {
    if (is_full()) return;
    const auto at = static_cast<std::uint32_t>(pieces_.size());
    pieces_.push_back({from, to});
    for (std::int64_t x = cell(std::min(from.x, to.x)); x <= cell(std::max(from.x, to.x)); ++x)
        for (std::int64_t y = cell(std::min(from.y, to.y)); y <= cell(std::max(from.y, to.y)); ++y)
            cells_[key(x, y)].push_back(at);
}

void Walls::add_line(Vec2 from, Vec2 to) {
    const double pieces = std::min(std::max(1.0, std::ceil(geom::distance(from, to) / (2 * radius_))), 1e5);
    for (double k = 0; k < pieces; ++k)
        add_piece(from + (k / pieces) * (to - from), from + ((k + 1) / pieces) * (to - from));
}

void Walls::add_arc(Vec2 centre, double radius, double start, double sweep) {
    const double chord = radius > chord_error ? 2 * std::acos(1 - chord_error / radius) : geom::pi;
    const double pieces = std::min(std::max(1.0, std::ceil(std::abs(sweep) / chord)), 1e5);
    const auto at = [&](double k) {
        const double angle = start + sweep * k / pieces;
        return centre + radius * Vec2{std::cos(angle), std::sin(angle)};
    };
    for (double k = 0; k < pieces; ++k) add_line(at(k), at(k + 1));
}

double Walls::clearance(Vec2 from, Vec2 to) const {
    double nearest = radius_;
    const auto low = [&](double a, double b) { return cell(std::min(a, b) - radius_); };
    const auto high = [&](double a, double b) { return cell(std::max(a, b) + radius_); };
    for (std::int64_t x = low(from.x, to.x); x <= high(from.x, to.x); ++x) {
        for (std::int64_t y = low(from.y, to.y); y <= high(from.y, to.y); ++y) {
            const auto found = cells_.find(key(x, y));
            if (found == cells_.end()) continue;
            for (const std::uint32_t piece : found->second)
                nearest = std::min(nearest, distance_between(from, to, pieces_[piece].from, pieces_[piece].to));
        }
    }
    return nearest;
}

double Walls::cut(Vec2 a, Vec2 corner, Vec2 b) const {
    const double ends = std::min(clearance(a, a), clearance(b, b));
    return std::max(0.0, ends - std::min(clearance(a, corner), clearance(corner, b)));
}

}  // namespace obrys::write
