/// Tools that leave their own cut straight, at a slant to their axis, against places looked at one by one: what is said
/// to be clear must be so.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <random>

#include "base/seed_testing.hpp"
#include "check/left/cut_world_testing.hpp"
#include "check/left/leaving.hpp"
#include "check/left/stock_parts.hpp"

namespace obrys::check {

namespace milling = sim::milling;

using geom::Vec3;
using testing::straight;

namespace {

constexpr double leaving_allowed = 0.01;

Vec3 unit(Vec3 v) { return (1 / geom::length(v)) * v; }

struct LeavingWorld : testing::CutWorld {
    StockPlanes planes = planes_of(stock);
    /// What one tool does that begins a way where it has been.
    [[nodiscard]] bool is_clear(std::uint32_t tool, Vec3 from, Vec3 to, Vec3 axis = {0, 0, 1}) {
        simulation.flush();
        const milling::Air air = simulation.air_in({{-100, -100, -100}, {200, 200, 200}});
        const LeftCuts cuts(air, simulation, 1'000'000);
        if (!cuts.was_at(simulation.tool(tool).cutting, from, axis)) return false;
        LeftSearch search{stock, air, cuts.all(), leaving_allowed, 5, 3000};
        search.planes = &planes;
        const StockPart part = stock_part_of(simulation.tool(tool).cutting, 0.001, 0.001);
        return std::all_of(part.profiles.begin(), part.profiles.end(), [&](const auto& profile) {
            const LeftBody body{from, {to - from, {}, {}}, axis, profile, {}};
            return leaves_clear(body, search);
        });
    }
    /// How far from all air the deepest place is that the tool comes through, of so many.
    [[nodiscard]] double deepest(std::uint32_t tool, Vec3 from, Vec3 to, Vec3 axis, std::mt19937& random, int places) {
        const auto in = [&](double low, double high) { return std::uniform_real_distribution(low, high)(random); };
        simulation.flush();
        const milling::Air air = simulation.air_in({{-100, -100, -100}, {200, 200, 200}});
        const LeftCuts cuts(air, simulation, 1'000'000);
        const milling::Orientation frame = milling::orientation_of(axis);
        const StockPart part = stock_part_of(simulation.tool(tool).cutting, 0.001, 0.001);
        double most = 0;
        for (int k = 0; k < places; ++k) {
            LeftBody body{from, {to - from, {}, {}}, axis, {}, {}};
            for (const auto& profile : part.profiles) {
                body.profile = clipped(profile, 0, 20);
                const double up = in(0, 1),
                             high = body.profile.front().y + up * up * up * (20 - body.profile.front().y);
                const double turn = in(0, 2 * geom::pi), r = radius_of(body, high) * std::sqrt(in(0, 1));
                const Vec3 p =
                    from + in(0, 1) * (to - from) + frame.to_stock({r * std::cos(turn), r * std::sin(turn), high});
                double depth = air.outside(0, p);
                for (const LeftCut& c : cuts.all()) depth = std::min(depth, c.farthest({p, 0}, axis));
                most = std::max(most, depth);
            }
        }
        return most;
    }
};

}  // namespace

TEST(Leaving, ABallLeavesItsScratchAcrossTheFace) {
    LeavingWorld w;
    const std::uint32_t ball = w.tool(10, milling::CutterKind::ball);
    const Vec3 tilted = unit(Vec3{0.3, -0.4, 0.8});
    const auto tip = [&](Vec3 centre) { return centre - 5.0 * tilted; };
    const Vec3 from = tip({20, 20, 4}), to = tip({30, 22, 4});  // a millimetre deep
    w.cut(ball, straight(from, to), tilted);
    EXPECT_TRUE(w.is_clear(ball, to, to + Vec3{0, 0, 30}, tilted));
    EXPECT_TRUE(w.is_clear(ball, from, from + Vec3{0, 0, 30}, tilted));
    EXPECT_FALSE(w.is_clear(ball, to, to + Vec3{10, 2, 0}, tilted));  // it goes on in the material
    EXPECT_FALSE(w.is_clear(ball, to, to + Vec3{5, 0, 0.5}, tilted));
}

TEST(Leaving, WhatStandsOverACutIsMet) {
    LeavingWorld w;
    milling::Cutter c;
    c.kind = milling::CutterKind::t_slot;
    c.diameter = 20, c.width = 4, c.neck_diameter = 8, c.cutting_length = 60;
    const std::uint32_t slot = w.simulation.add_tool(milling::shape_of(c).shape);
    w.cut(slot, straight({-20, 20, -12}, {30, 20, -12}));
    EXPECT_FALSE(w.is_clear(slot, {30, 20, -12}, {30, 20, 10}));
    EXPECT_TRUE(w.is_clear(slot, {30, 20, -12}, {-30, 20, -12}));
}

TEST(Leaving, APropertyOfRandomWays) {
    const std::uint32_t seed = base::testing_seed();
    std::mt19937 random(seed);
    const auto in = [&](double low, double high) { return std::uniform_real_distribution(low, high)(random); };
    constexpr int cases = 40;
    int clear = 0, met = 0;
    for (int n = 0; n < cases; ++n) {
        SCOPED_TRACE("seed " + std::to_string(seed) + ", case " + std::to_string(n));
        LeavingWorld w;
        const std::array tools{w.tool(8, milling::CutterKind::ball), w.tool(12, milling::CutterKind::bull_nose),
                               w.tool(9, milling::CutterKind::drill), w.tool(10)};
        const std::uint32_t tool = tools[static_cast<std::size_t>(n % 4)];
        const Vec3 axis = n % 2 == 0 ? Vec3{0, 0, 1} : unit(Vec3{in(-0.5, 0.5), in(-0.5, 0.5), 1});
        const Vec3 a{in(10, 50), in(8, 32), in(-3, 1)}, b = a + Vec3{in(-8, 8), in(-8, 8), in(-1, 1)};
        w.cut(tool, straight(a, b), axis);
        const Vec3 to = b + 30.0 * unit(Vec3{in(-0.7, 0.7), in(-0.7, 0.7), 1});
        const double deepest = w.deepest(tool, b, to, axis, random, 20000);
        if (w.is_clear(tool, b, to, axis)) {
            ++clear;
            EXPECT_LE(deepest, leaving_allowed + 1e-6);
        } else if (deepest > leaving_allowed) {
            ++met;
        }
    }
    EXPECT_GE(clear, cases / 8);
    EXPECT_GE(met, 1);
}

}  // namespace obrys::check
