/// The deepest place of a body in what is left, against many places of it looked at one by one.

#include <gtest/gtest.h>

#include <random>

#include "base/seed_testing.hpp"
#include "check/left/cut_world_testing.hpp"
#include "check/left/search.hpp"

namespace obrys::check {

namespace milling = sim::milling;

using geom::Vec3;
using testing::straight;

namespace {

constexpr double search_allowed = 0.001, search_enough = 1;

struct SearchWorld : testing::CutWorld {
    using CutWorld::CutWorld;
    [[nodiscard]] LeftDepth deepest(const LeftBody& body, std::size_t cells = 20'000) {
        simulation.flush();
        const milling::Air air = simulation.air_in({{-100, -100, -100}, {200, 200, 200}});
        const LeftCuts cuts(air, simulation, 1'000'000);
        std::uint32_t hint = 0;
        return deepest_left(body, {stock, air, cuts.all(), search_allowed, search_enough, cells, &hint});
    }
    /// How deep a place lies, by distances of the simulation's own.
    [[nodiscard]] double depth(Vec3 p) const {
        const milling::Air air = simulation.air_in({p - Vec3{2, 2, 2}, p + Vec3{2, 2, 2}});
        double depth = search_enough;
        for (std::size_t body = 0; body < air.bodies(); ++body) depth = std::min(depth, air.outside(body, p));
        return depth;
    }
};

LeftBody shank(Vec3 from, Vec3 to, double radius, double low, double high, Vec3 axis = {0, 0, 1}) {
    return {from, {to - from, {}, {}}, axis, {{radius, low}, {radius, high}}, {}};
}

}  // namespace

TEST(LeftSearch, AShankAsThickAsTheCutterTouchesAndIsClear) {
    SearchWorld w;
    const std::uint32_t mill = w.tool(10);
    for (const double z : {-5.0, -10.0, -15.0}) w.cut(mill, straight({-10, 18, z}, {70, 22, z}));
    const LeftDepth d = w.deepest(shank({-10, 18, -15}, {70, 22, -15}, 5, 5, 60));
    EXPECT_TRUE(d.decided);
    EXPECT_EQ(d.depth, 0);
    const LeftDepth deeper = w.deepest(shank({-10, 18.02, -15}, {70, 22.02, -15}, 5, 5, 60));
    EXPECT_TRUE(deeper.decided);
    EXPECT_NEAR(deeper.depth, 0.02, 0.003);
}

/// Flutes that end where the stock does: all over the end of their cut it is nearly as deep in the one as off the
/// other.
TEST(LeftSearch, AShankGoesDownInACutThatEndsWithTheStock) {
    SearchWorld w;
    const std::uint32_t mill = w.tool(24, milling::CutterKind::end_mill, 10);
    w.cut(mill, straight({30, 20, -10}, {30, 20.5, -10}));
    constexpr std::size_t few = 200;
    const LeftDepth d = w.deepest(shank({33, 20, -10.5}, {33, 20.1, -10.508}, 6, 10, 40), few);
    EXPECT_TRUE(d.decided);
    EXPECT_EQ(d.depth, 0);
    const LeftDepth beside = w.deepest(shank({39, 20, -10.5}, {39, 20.1, -10.508}, 6, 10, 40));
    EXPECT_GT(beside.depth, 0.1);
}

TEST(LeftSearch, AnArcAsTheCutterWentIsClear) {
    SearchWorld w;
    const std::uint32_t mill = w.tool(10);
    const geom::Circular arc{{20, 20, -10}, {30, 30, -10}, {30, 20, -10}, {0, 0, 1}, -geom::pi / 2};
    w.cut(mill, arc);
    const Vec3 chord = Vec3{10, 10, 0}, bulge = ((10 - std::sqrt(50.0)) / std::sqrt(2.0)) * Vec3{-1, 1, 0};
    LeftBody body{{20, 20, -10},
                  {chord, bulge, {}},
                  {0, 0, 1},
                  {{5, 5}, {5, 60}},
                  ArcWay{{30, 20, -10}, 10, {20, 20, -10}, {30, 30, -10}}};
    w.simulation.flush();
    const milling::Air air = w.simulation.air_in({{-100, -100, -100}, {200, 200, 200}});
    const LeftCuts cuts(air, w.simulation, 1'000'000);
    EXPECT_TRUE(surely_clear(body, {w.stock, air, cuts.all(), search_allowed, search_enough, 100, nullptr}));
    body.profile = {{5.02, 5}, {5.02, 60}};
    EXPECT_FALSE(surely_clear(body, {w.stock, air, cuts.all(), search_allowed, search_enough, 1000, nullptr}));
}

/// A pocket in rows, a thicker body in its middle, and beside it.
TEST(LeftSearch, AThickBodyInAPocketOfManyRows) {
    SearchWorld w;
    const std::uint32_t mill = w.tool(6);
    for (int row = 0; row < 8; ++row) w.cut(mill, straight({15, 8.0 + 3 * row, -12}, {45, 8.0 + 3 * row, -12}));
    w.cut(mill, straight({45, 8, -12}, {45, 29, -12}));
    EXPECT_EQ(w.deepest(shank({28, 18, -12}, {33, 20, -12}, 9, 2, 60)).depth, 0);
    EXPECT_TRUE(w.deepest(shank({28, 18, -12}, {33, 20, -12}, 9, 2, 60)).decided);
    // The far wall lies at X 48.
    const LeftDepth d = w.deepest(shank({28, 18, -12}, {39.1, 19, -12}, 9, 2, 60));
    EXPECT_TRUE(d.decided);
    EXPECT_GT(d.depth, 0.05);
    EXPECT_LE(d.depth, 0.11);
}

TEST(LeftSearch, APropertyOfRandomCuts) {
    const std::uint32_t seed = base::testing_seed();
    std::mt19937 random(seed);
    const auto in = [&](double low, double high) { return std::uniform_real_distribution(low, high)(random); };
    int undecided = 0;
    for (int n = 0; n < 40; ++n) {
        SCOPED_TRACE("seed " + std::to_string(seed) + ", case " + std::to_string(n));
        SearchWorld w(n % 3 == 0 ? milling::Stock(milling::CylinderStock{2, {30, 20, -20}, 20, 20})
                                 : milling::Stock(milling::Box3{{0, 0, -20}, {60, 40, 0}}));
        const std::array tools{w.tool(10), w.tool(8, milling::CutterKind::ball),
                               w.tool(12, milling::CutterKind::bull_nose), w.tool(9, milling::CutterKind::drill)};
        const auto place = [&](double low) { return Vec3{in(10, 50), in(8, 32), in(low, -2)}; };
        for (int k = 0; k < 12; ++k) {
            const Vec3 a = place(-16), b = place(-16);
            const bool level = k % 2 == 0;
            w.cut(tools[static_cast<std::size_t>(k % 4)], straight(a, level ? Vec3{b.x, b.y, a.z} : b));
        }
        const Vec3 a = place(-12), b = place(-12);
        const LeftBody body = shank(a, n % 2 == 0 ? Vec3{b.x, b.y, a.z} : b, in(1, 5), in(0, 5), in(10, 40));
        const LeftDepth d = w.deepest(body);
        if (!d.decided) ++undecided;  // what it was bounded by holds all the same
        if (d.depth > 0) {
            EXPECT_NEAR(w.depth(d.at), d.depth, 1e-5);
        }
        double most = 0;
        for (int k = 0; k < 4000; ++k) {
            const double turn = in(0, 2 * geom::pi), r = body.profile[0].x * std::sqrt(in(0, 1));
            const Vec3 p = body.corner + in(0, 1) * body.edges[0] +
                           Vec3{r * std::cos(turn), r * std::sin(turn), in(body.profile[0].y, body.profile[1].y)};
            most = std::max(most, w.depth(p));
        }
        EXPECT_LE(most, (d.decided ? std::max(search_allowed, 1.25 * d.depth) : d.bound) + 1e-6);
    }
    EXPECT_LE(undecided, 2) << "seed " << seed;
}

}  // namespace obrys::check
