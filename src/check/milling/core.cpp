#include "check/milling/core.hpp"

#include <algorithm>
#include <cmath>

namespace obrys::check {

using geom::Vec2;
using geom::Vec3;

namespace {

constexpr double one_piece = 1.0 / 16;         ///< of the core: pieces so short are one
constexpr std::size_t most_pieces_kept = 400;  ///< looked at together
constexpr double disc_slack = 1e-9;            ///< mm

struct Enclosing {
    Vec2 centre;
    double radius = -1;
    [[nodiscard]] bool holds(Vec2 p) const { return geom::length(p - centre) <= radius + disc_slack; }
};

Enclosing of_two(Vec2 a, Vec2 b) { return {0.5 * (a + b), 0.5 * geom::length(b - a)}; }

Enclosing of_three(Vec2 a, Vec2 b, Vec2 c) {
    const Vec2 u = b - a, v = c - a;
    const double d = 2 * geom::cross(u, v);
    if (!(std::abs(d) > 1e-12)) {
        const Enclosing all[] = {of_two(a, b), of_two(a, c), of_two(b, c)};
        return *std::max_element(std::begin(all), std::end(all),
                                 [](const Enclosing& x, const Enclosing& y) { return x.radius < y.radius; });
    }
    const double uu = geom::dot(u, u), vv = geom::dot(v, v);
    const Vec2 off{(v.y * uu - u.y * vv) / d, (u.x * vv - v.x * uu) / d};
    return {a + off, geom::length(off)};
}

/// The smallest disc around points, one of which, the last, lies on its rim (Welzl).
Enclosing with_last(const std::vector<Vec2>& points) {
    const Vec2 last = points.back();
    Enclosing disc{last, 0};
    for (std::size_t i = 0; i + 1 < points.size(); ++i) {
        if (disc.holds(points[i])) continue;
        disc = of_two(points[i], last);
        for (std::size_t k = 0; k < i; ++k)
            if (!disc.holds(points[k])) disc = of_three(points[k], points[i], last);
    }
    return disc;
}

/// Grows with its points.
class Around {
public:
    void add(Vec2 p) {
        points_.push_back(p);
        if (!disc_.holds(p)) disc_ = with_last(points_);
    }
    [[nodiscard]] double radius() const { return std::max(0.0, disc_.radius); }
    [[nodiscard]] Vec2 centre() const { return disc_.centre; }

private:
    std::vector<Vec2> points_;
    Enclosing disc_;
};

}  // namespace

void CoreDescent::begin(double core, double least) {
    core_ = core;
    least_ = std::max(least, core / 20);
    pieces_.clear();
}

bool CoreDescent::take(std::span<const Vec3> points, bool met, std::uint32_t number) {
    if (points.empty()) return false;
    Piece piece;
    piece.top = points.front().z, piece.bottom = points.back().z, piece.number = number;
    for (const Vec3& p : points) piece.points.push_back({p.x, p.y});
    if (met) piece.down = std::max(0.0, points.front().z - points.back().z);
    const double piece_down = piece.down;
    const auto is_short = [&](const Piece& p) {
        return std::all_of(p.points.begin(), p.points.end(),
                           [&](Vec2 q) { return geom::length(q - p.points.front()) < one_piece * core_; });
    };
    const bool joins = !pieces_.empty() && is_short(piece) && is_short(pieces_.back()) &&
                       geom::length(piece.points.back() - pieces_.back().points.front()) < one_piece * core_ &&
                       pieces_.back().down + piece.down < one_piece * core_;
    if (joins) {
        Piece& last = pieces_.back();
        last.down += piece.down;
        last.bottom = piece.bottom;
        last.points = {last.points.front(), piece.points.back()};
    } else {
        pieces_.push_back(std::move(piece));
    }
    if (pieces_.size() > most_pieces_kept) pieces_.erase(pieces_.begin(), pieces_.end() - most_pieces_kept / 2);
    return piece_down > 0 && is_steep();
}

/// The last pieces together, as far back as a disc like the core holds them.
bool CoreDescent::is_steep() {
    Around around;
    double down = 0;
    for (std::size_t i = pieces_.size(); i > 0; --i) {
        for (const Vec2& p : pieces_[i - 1].points) around.add(p);
        if (around.radius() > core_) {
            // What lies before is out of reach of all that comes, unless the way returns; then its depth is another.
            if (i > 1) pieces_.erase(pieces_.begin(), pieces_.begin() + static_cast<std::ptrdiff_t>(i - 1));
            return false;
        }
        down += pieces_[i - 1].down;
        if (down > least_ && down > steepest * 2 * around.radius()) {
            steep_ = {down,
                      2 * around.radius(),
                      around.centre(),
                      core_ - around.radius(),
                      pieces_[i - 1].top,
                      pieces_.back().bottom,
                      pieces_[i - 1].number};
            pieces_.clear();
            return true;
        }
    }
    return false;
}

}  // namespace obrys::check
