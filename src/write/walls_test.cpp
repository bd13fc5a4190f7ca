#include "write/walls.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace obrys::write {
namespace {

using geom::Vec2;

/// Nearest distance of points along both ways, by stepping: no function of the product measures it.
double stepped(const Vec2& a, const Vec2& b, const std::vector<std::pair<Vec2, Vec2>>& walls) {
    constexpr int steps = 400;
    double nearest = 1e300;
    for (int i = 0; i <= steps; ++i) {
        const Vec2 p = a + (static_cast<double>(i) / steps) * (b - a);
        for (const auto& [from, to] : walls) {
            const Vec2 way = to - from;
            const double t = std::fmin(std::fmax(geom::dot(p - from, way) / geom::dot(way, way), 0), 1);
            nearest = std::fmin(nearest, std::hypot(from.x + t * way.x - p.x, from.y + t * way.y - p.y));
        }
    }
    return nearest;
}

/// Ways of the tool's own size and ways a thousand times as long, which are looked for another way.
TEST(Walls, ACutIsSteppedAlong) {
    constexpr unsigned seed = 20261128;
    SCOPED_TRACE(seed);
    std::mt19937 random(seed);
    for (int n = 0; n < 60; ++n) {
        const double size = n % 3 == 0 ? 2000 : 40;
        std::uniform_real_distribution<double> at(-size, size);
        const auto point = [&] { return Vec2{at(random), at(random)}; };
        Walls walls(2);
        std::vector<std::pair<Vec2, Vec2>> all;
        for (int k = 0; k < 8; ++k) {
            all.emplace_back(point(), point());
            walls.add_line(all.back().first, all.back().second);
        }
        const Vec2 a = point(), b = point(), corner{b.x, a.y};
        const auto near = [&](const Vec2& p, const Vec2& q) { return std::fmin(2, stepped(p, q, all)); };
        const double ends = std::fmin(near(a, a), near(b, b));
        const double cut = std::fmax(0, ends - std::fmin(near(a, corner), near(corner, b)));
        EXPECT_NEAR(walls.cut(a, corner, b), cut, size / 100) << n;
    }
}

/// A tool of a micrometre among walls and ways a kilometre long: 10^18 cells are not walked.
TEST(Walls, ALongWayOfASmallToolIsNoHang) {
    Walls walls(1e-3);
    walls.add_line({0, 0}, {1e6, 1e6});
    walls.add_arc({0, 0}, 1e6, 0, 6);
    EXPECT_GT(walls.cut({-10, 10}, {1e6, 10}, {1e6, 9e5}), 9e-4);
    EXPECT_EQ(walls.cut({-1e15, 1e300}, {10, 1e300}, {10, 1e15}), 0);
}

}  // namespace
}  // namespace obrys::write
