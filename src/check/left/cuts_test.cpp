/// Ways that a tool has cut before.

#include "check/left/cuts.hpp"

#include <gtest/gtest.h>

#include "check/left/cut_world_testing.hpp"

namespace obrys::check {

namespace milling = sim::milling;

using geom::Vec3;
using testing::straight;

namespace {

/// A bull nose that has cut from (0 20 -2) to (30 20 -4) in three moves, and 5 down there.
struct SlopeWorld : testing::CutWorld {
    std::uint32_t mill = tool(8, milling::CutterKind::bull_nose, 30),
                  other = tool(8, milling::CutterKind::end_mill, 30);
    SlopeWorld() {
        for (const double x : {0.0, 10.0, 20.0})
            cut(mill, straight({x, 20, -2 - x / 15}, {x + 10, 20, -2 - (x + 10) / 15}));
        cut(mill, straight({30, 20, -4}, {30, 20, -9}));
        simulation.flush();
    }
    [[nodiscard]] bool holds(Vec3 from, Vec3 to, std::uint32_t of) {
        const milling::Air air = simulation.air_in({{-100, -100, -100}, {200, 200, 200}});
        const LeftCuts cuts(air, simulation, 1'000'000);
        return cuts.hold_way(simulation.tool(of).cutting, {from, to}, {0, 0, 1}, 0);
    }
};

}  // namespace

TEST(LeftCuts, HoldAWayOfTheSameToolOnTheirOwn) {
    SlopeWorld w;
    EXPECT_TRUE(w.holds({30, 20, -4}, {0, 20, -2}, w.mill)) << "back the way it came, over three moves";
    EXPECT_TRUE(w.holds({12, 20, -1}, {3, 20, -2}, w.mill)) << "above it";
    EXPECT_TRUE(w.holds({30, 20, -9}, {30, 20, 5}, w.mill)) << "up where it went down";
    EXPECT_FALSE(w.holds({30, 20, -4}, {0, 20, -2.001}, w.mill)) << "a hair below it";
    EXPECT_FALSE(w.holds({30, 20.001, -4}, {0, 20.001, -2}, w.mill)) << "a hair beside it";
    EXPECT_FALSE(w.holds({30.5, 20, -4}, {0, 20, -2}, w.mill)) << "longer than it";
    EXPECT_FALSE(w.holds({30, 20, -4}, {0, 20, -2}, w.other)) << "another tool";
}

}  // namespace obrys::check
