/// Columns that cuts have emptied against distances of the simulation's own: what is said to be clear is, and ordinary
/// ways are said to be.

#include "check/touching/cleared.hpp"

#include <gtest/gtest.h>

#include <random>

#include "base/seed_testing.hpp"
#include "check/left/cut_world_testing.hpp"

namespace obrys::check {

namespace milling = sim::milling;

using geom::Vec3;
using testing::straight;

namespace {

constexpr double cleared_slack = 0.001, cleared_enough = 2;

struct ClearedWorld : testing::CutWorld {
    using CutWorld::CutWorld;
    [[nodiscard]] Cleared cleared() {
        simulation.flush();
        Cleared c(stock, cleared_slack, 1);
        c.advance(simulation, passes);
        return c;
    }
    /// How deep a place lies in what is left.
    [[nodiscard]] double depth(Vec3 p) const {
        const Vec3 around{cleared_enough, cleared_enough, cleared_enough};
        const milling::Air air = simulation.air_in({p - around, p + around});
        double depth = cleared_enough;
        for (std::size_t body = 0; body < air.bodies(); ++body) depth = std::min(depth, air.outside(body, p));
        return std::max(0.0, depth);
    }
};

Upright body(Vec3 from, Vec3 to, double radius, double bottom, double top) {
    return {from, to, radius, bottom, top, nullptr};
}

/// The largest depth of places of a body.
double deepest_in(const ClearedWorld& w, const Upright& b, Vec3 axis, std::mt19937& random, int places) {
    const auto in = [&](double low, double high) { return std::uniform_real_distribution(low, high)(random); };
    const milling::Orientation frame = milling::orientation_of(axis);
    double most = 0;
    for (int k = 0; k < places; ++k) {
        const double turn = in(0, 2 * geom::pi), r = b.radius * (k % 2 == 0 ? 1 : std::sqrt(in(0, 1)));
        const Vec3 p = b.from + in(0, 1) * (b.to - b.from) +
                       frame.to_stock({r * std::cos(turn), r * std::sin(turn), in(b.bottom, b.top)});
        most = std::max(most, w.depth(p));
    }
    return most;
}

constexpr Vec3 up{0, 0, 1};

}  // namespace

TEST(Cleared, AShankAsThickAsItsCutterIsClearAlongItsWayAndNotBesideIt) {
    ClearedWorld w;
    const std::uint32_t mill = w.tool(10, milling::CutterKind::end_mill, 6);
    for (const double z : {-5.0, -10.0, -15.0}) w.cut(mill, straight({-10, 18, z}, {70, 22, z}));
    Cleared c = w.cleared();
    EXPECT_TRUE(c.is_clear(body({-10, 18, -15}, {70, 22, -15}, 5, 6, 60), up));
    EXPECT_TRUE(c.is_clear(body({30, 20, -15}, {30, 20, 5}, 5, 6, 60), up));
    EXPECT_FALSE(c.is_clear(body({-10, 18.02, -15}, {70, 22.02, -15}, 5, 6, 60), up));
    EXPECT_FALSE(c.is_clear(body({-10, 18, -15}, {70, 22, -15}, 5.01, 6, 60), up));
    // Below the deepest cut.
    EXPECT_FALSE(c.is_clear(body({-10, 18, -15}, {70, 22, -15}, 5, -0.01, 60), up));
}

TEST(Cleared, AThickBodyInThePocketThatRowsHaveMade) {
    ClearedWorld w;
    const std::uint32_t mill = w.tool(6);
    for (int row = 0; row < 8; ++row) w.cut(mill, straight({15, 8.0 + 3 * row, -12}, {45, 8.0 + 3 * row, -12}));
    w.cut(mill, straight({45, 8, -12}, {45, 29, -12}));
    Cleared c = w.cleared();
    EXPECT_TRUE(c.is_clear(body({28, 18, -12}, {33, 20, -12}, 9, 0, 60), up));
    EXPECT_FALSE(c.is_clear(body({28, 18, -12}, {39.1, 20, -12}, 9, 0, 60), up));
}

/// Retracting from a groove that a ball has made, and going back along a ramp.
TEST(Cleared, ARoundToolOnItsOwnWayIsClear) {
    ClearedWorld w;
    const std::uint32_t ball = w.tool(6, milling::CutterKind::ball, 30);
    w.cut(ball, straight({10, 20, 2}, {40, 22, -6}));
    Cleared c = w.cleared();
    Upright b = body({40, 22, -6}, {10, 20, 2}, 3, 0, 30);
    b.shape = &w.simulation.tool(ball).cutting;
    EXPECT_TRUE(c.is_clear(b, up));
    b.from.z -= 0.01;
    EXPECT_FALSE(c.is_clear(b, up));
    b.from = {40, 22, -6}, b.to = {40, 22, 20};
    EXPECT_TRUE(c.is_clear(b, up));
}

TEST(Cleared, WhatIsSaidToBeClearIsAndDepthsAreThoseOfTheSimulation) {
    const std::uint32_t seed = base::testing_seed();
    std::mt19937 random(seed);
    const auto in = [&](double low, double high) { return std::uniform_real_distribution(low, high)(random); };
    int clear = 0;
    for (int n = 0; n < 24; ++n) {
        SCOPED_TRACE("seed " + std::to_string(seed) + ", case " + std::to_string(n));
        ClearedWorld w(n % 3 == 0 ? milling::Stock(milling::CylinderStock{2, {30, 20, -20}, 20, 20})
                                  : milling::Stock(milling::Box3{{0, 0, -20}, {60, 40, 0}}));
        const Vec3 axis = n % 5 == 4 ? Vec3{0.1, 0.62, 0.81} : up;
        const std::array tools{w.tool(16), w.tool(12, milling::CutterKind::ball),
                               w.tool(14, milling::CutterKind::bull_nose), w.tool(9, milling::CutterKind::drill)};
        const auto place = [&](double low) { return Vec3{in(10, 50), in(8, 32), in(low, -2)}; };
        std::vector<Vec3> ends;
        for (int k = 0; k < 30; ++k) {
            const Vec3 a = place(-16), b = place(-16);
            const std::uint32_t tool = tools[static_cast<std::size_t>(k % 4)];
            if (k % 5 == 4 && axis == up) {
                const Vec3 centre = a + Vec3{in(3, 15), 0, 0}, from = a;
                const double turn = in(-1.5, 1.5);
                const Vec3 out = from - centre;
                const Vec3 to = centre + Vec3{out.x * std::cos(turn) - out.y * std::sin(turn),
                                              out.x * std::sin(turn) + out.y * std::cos(turn), 0};
                w.cut(tool, geom::Circular{from, to, centre, up, turn});
            } else {
                w.cut(tool, straight(a, k % 2 == 0 ? Vec3{b.x, b.y, a.z} : b), k % 7 == 3 ? up : axis);
            }
            ends.push_back(a);
        }
        Cleared c = w.cleared();
        for (int k = 0; k < 20; ++k) {
            const Vec3 a = ends[static_cast<std::size_t>(k)], b = place(-12);
            const Upright shank = body(a, k % 2 == 0 ? a + 20.0 * axis : a + 0.1 * (b - a), in(0.5, 5), in(0, 5), 30);
            if (!c.is_clear(shank, axis)) continue;
            ++clear;
            EXPECT_LE(deepest_in(w, shank, axis, random, 300), 1.5 * cleared_slack);
        }
        for (int k = 0; k < 200; ++k) {
            const Vec3 p = place(-19);
            EXPECT_NEAR(c.depth_at(p, cleared_enough), w.depth(p), 1e-6) << p.x << ' ' << p.y << ' ' << p.z;
        }
    }
    EXPECT_GT(clear, 40);
}

}  // namespace obrys::check
