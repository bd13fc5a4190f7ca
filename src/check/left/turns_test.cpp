/// Bodies made of full turns: nothing of them is material, and what stands in the middle of a turn is clear.

#include "check/left/turns.hpp"

#include <gtest/gtest.h>

#include <random>

#include "base/seed_testing.hpp"
#include "check/left/cut_world_testing.hpp"
#include "check/left/search.hpp"

namespace obrys::check {

namespace milling = sim::milling;

using geom::Vec3;

namespace {

/// A helix about an axis through `centre`, downwards from z 0.
geom::Circular turns_down(Vec3 centre, double radius, double turns, double pitch) {
    const Vec3 from = centre + Vec3{radius, 0, 0};
    const double angle = 2 * geom::pi * turns;
    return {from,
            centre + Vec3{radius * std::cos(angle), radius * std::sin(angle), -pitch * turns},
            centre,
            {0, 0, 1},
            angle};
}

struct TurnWorld : testing::CutWorld {
    [[nodiscard]] std::deque<milling::Air::Sweep> sweeps() {
        simulation.flush();
        const milling::Air air = simulation.air_in({{-100, -100, -100}, {200, 200, 200}});
        std::deque<milling::Air::Sweep> all;
        for (std::size_t body = 1; body < air.bodies(); ++body) all.push_back(air.sweep(body));
        return all;
    }
};

}  // namespace

TEST(LeftTurns, AHelixOverItsMiddleIsOneCylinder) {
    TurnWorld w;
    w.cut(w.tool(12, milling::CutterKind::end_mill, 10), turns_down({30, 20, 0}, 4, 5, 3));
    const LeftTurns turns = turns_of(w.sweeps());
    ASSERT_EQ(turns.sweeps.size(), 1U);
    const milling::Air::Sweep& s = turns.sweeps[0];
    EXPECT_NEAR(s.shape->radius, 10, 0.001);
    EXPECT_NEAR(s.from.z, -12, 0.05);                     // where the last turn begins; a chord more
    EXPECT_NEAR(s.from.z + s.shape->top, -3 + 10, 0.05);  // where the first one ends
}

TEST(LeftTurns, AHelixThatLeavesACoreIsARing) {
    TurnWorld w;
    w.cut(w.tool(6, milling::CutterKind::end_mill, 10), turns_down({30, 20, 0}, 8, 2, 3));
    const LeftTurns turns = turns_of(w.sweeps());
    ASSERT_EQ(turns.sweeps.size(), 4U);
    for (const milling::Air::Sweep& s : turns.sweeps) EXPECT_TRUE(s.track.circular);
}

/// Around a circle with so many corners, at one depth after the other.
void polygons(TurnWorld& w, std::uint32_t mill, Vec3 centre, double radius, int corners, double start, int levels) {
    for (int level = 1; level <= levels; ++level)
        for (int i = 0; i < corners; ++i) {
            const auto at = [&](int k) {
                const double angle = start + 2 * geom::pi * k / corners;
                return centre + Vec3{radius * std::cos(angle), radius * std::sin(angle), -2.5 * level};
            };
            w.cut(mill, geom::Straight{at(i), at(i + 1)});
        }
}

TEST(LeftTurns, ARectangleIsNoTurn) {
    TurnWorld w;
    polygons(w, w.tool(6, milling::CutterKind::end_mill, 20), {30, 20, 0}, 12, 4, 0.4, 3);
    EXPECT_TRUE(turns_of(w.sweeps()).sweeps.empty());
}

TEST(LeftTurns, NothingOfThemIsMaterial) {
    const std::uint32_t seed = base::testing_seed();
    std::mt19937 random(seed);
    const auto any = [&](double low, double high) { return std::uniform_real_distribution(low, high)(random); };
    int inside = 0;
    for (int n = 0; n < 20; ++n) {
        TurnWorld w;
        const std::uint32_t mill = w.tool(any(4, 14), milling::CutterKind::end_mill, any(4, 20));
        if (n % 2 == 0)
            w.cut(mill, turns_down({30, 20, 0}, any(1, 10), any(1, 4), any(0, 6)));
        else
            polygons(w, mill, {30, 20, 0}, any(1, 10), static_cast<int>(any(3, 12)), any(0, 6), 3);
        const auto sweeps = w.sweeps();
        const LeftTurns turns = turns_of(sweeps);
        const milling::Air air = w.simulation.air_in({{-100, -100, -100}, {200, 200, 200}});
        for (int k = 0; k < 2000; ++k) {
            const Vec3 p{any(10, 50), any(0, 40), any(-20, 20)};
            const bool in = std::any_of(turns.sweeps.begin(), turns.sweeps.end(), [&](const milling::Air::Sweep& s) {
                return milling::outside_sweep(*s.shape, s.track, s.frame.to_tool(p - s.from)) < -1e-6;
            });
            if (!in) continue;
            ++inside;
            double out = INFINITY;
            for (std::size_t body = 1; body < air.bodies(); ++body) out = std::min(out, air.outside(body, p));
            ASSERT_LT(out, 1e-6) << p.x << ' ' << p.y << ' ' << p.z << " of " << n << ", seed " << seed;
        }
    }
    EXPECT_GT(inside, 2000);
}

TEST(LeftTurns, AShankAsThickAsItsCutterIsClearInTheMiddleOfAHelix) {
    TurnWorld w;
    w.cut(w.tool(12, milling::CutterKind::end_mill, 10), turns_down({30, 20, 0}, 4, 5, 3));
    w.simulation.flush();
    const milling::Air air = w.simulation.air_in({{-100, -100, -100}, {200, 200, 200}});
    const LeftCuts cuts(air, w.simulation, 1'000'000);
    const auto found = [&](Vec3 to) {
        const Vec3 from{34, 20, -15};
        return deepest_left({from, {to - from, {}, {}}, {0, 0, 1}, {{6, 10}, {6, 30}}, {}},
                            {w.stock, air, cuts.all(), 0.001, 1, 3000});
    };
    const LeftDepth inwards = found({30, 20, -15});
    EXPECT_TRUE(inwards.decided);
    EXPECT_EQ(inwards.depth, 0);
    const LeftDepth outwards = found({34.3, 20, -15});
    EXPECT_TRUE(outwards.decided);
    EXPECT_NEAR(outwards.depth, 0.3, 0.03);
}

}  // namespace obrys::check
