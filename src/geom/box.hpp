#pragma once
/// Boxes parallel to the axes, in the plane.

#include <algorithm>
#include <limits>

#include "geom/vec.hpp"

namespace obrys::geom {

/// Closed; empty while `lo` exceeds `hi`.
struct Box {
    Vec2 lo{std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
    Vec2 hi{-std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};

    [[nodiscard]] bool empty() const { return !(lo.x <= hi.x && lo.y <= hi.y); }
    void add(Vec2 p) {
        lo = {std::min(lo.x, p.x), std::min(lo.y, p.y)};
        hi = {std::max(hi.x, p.x), std::max(hi.y, p.y)};
    }
    void add(const Box& b) {
        lo = {std::min(lo.x, b.lo.x), std::min(lo.y, b.lo.y)};
        hi = {std::max(hi.x, b.hi.x), std::max(hi.y, b.hi.y)};
    }
};
[[nodiscard]] constexpr bool overlap(const Box& a, const Box& b, double margin = 0) {
    return a.lo.x <= b.hi.x + margin && b.lo.x <= a.hi.x + margin && a.lo.y <= b.hi.y + margin &&
           b.lo.y <= a.hi.y + margin;
}
[[nodiscard]] constexpr bool contains(const Box& b, Vec2 p, double margin = 0) {
    return p.x >= b.lo.x - margin && p.x <= b.hi.x + margin && p.y >= b.lo.y - margin && p.y <= b.hi.y + margin;
}

}  // namespace obrys::geom
