/// Engagement against cases worked out by hand, and of simulated slots, side cuts and drillings.

#include "check/engagement.hpp"

#include <gtest/gtest.h>

#include "check/stream/check.hpp"
#include "geom/vec.hpp"

namespace obrys::check {

namespace {

constexpr double degree = geom::pi / 180;

shop::Tool tool_of(shop::ToolKind kind, double radius, int teeth = 4) {
    shop::Tool t;
    t.number = 1;
    t.kind = kind;
    t.radius = radius;
    t.cutting_length = 40;
    t.teeth = teeth;
    return t;
}

/// 0.4 mm a revolution.
MilledMove move_of(double right, double left, double reach, double sinking = 0) {
    MilledMove m;
    m.volume_mm3 = 1;
    m.rightmost_mm = right;
    m.leftmost_mm = left;
    m.reach_mm = reach;
    m.sinking = sinking;
    m.feed_per_rev_mm = 0.4;
    return m;
}

EdgeEngagement of(const shop::Tool& tool, const MilledMove& m) { return engagement_of(m, CuttingEdges(tool), 0); }

}  // namespace

TEST(Engagement, AFullSlotIsHalfATurnAndAsThickAsTheFeedPerTooth) {
    const EdgeEngagement e = of(tool_of(shop::ToolKind::end_mill, 10), move_of(-10, 10, 5));
    EXPECT_DOUBLE_EQ(e.radial_depth, 20);
    EXPECT_NEAR(e.from, -90 * degree, 1e-12);
    EXPECT_NEAR(e.to, 90 * degree, 1e-12);
    EXPECT_DOUBLE_EQ(e.feed_per_tooth, 0.1);
    EXPECT_NEAR(e.chip_largest, 0.1, 1e-12);
    EXPECT_NEAR(e.chip_mean, 0.1 * 2 / geom::pi, 1e-12);
}

TEST(Engagement, HalfImmersionIsAQuarterTurn) {
    const EdgeEngagement e = of(tool_of(shop::ToolKind::end_mill, 10), move_of(-10, 0, 5));  // climb with M3
    EXPECT_NEAR(e.from, -90 * degree, 1e-12);
    EXPECT_NEAR(e.to, 0, 1e-12);
    EXPECT_NEAR(e.chip_largest, 0.1, 1e-12);
    EXPECT_NEAR(e.chip_mean, 0.1 * 2 / geom::pi, 1e-12);
}

TEST(Engagement, ATenthOfTheDiameter) {
    // acos(1 - 2 / 10) of engagement; h = f_z sin of it at the edge of the cut, a_e / (R angle) f_z in the mean.
    const double angle = std::acos(0.8);
    const EdgeEngagement e = of(tool_of(shop::ToolKind::end_mill, 10), move_of(8, 10, 5));
    EXPECT_NEAR(e.to - e.from, angle, 1e-12);
    EXPECT_NEAR(e.radial_depth, 2, 1e-12);
    EXPECT_NEAR(e.chip_largest, 0.1 * std::sin(angle), 1e-12);
    EXPECT_NEAR(e.chip_mean, 0.1 * 2 / (10 * angle), 1e-12);
}

TEST(Engagement, PlungingIsAllRound) {
    const EdgeEngagement mill = of(tool_of(shop::ToolKind::end_mill, 10), move_of(0, 10, 3, 1));
    EXPECT_NEAR(mill.to - mill.from, 2 * geom::pi, 1e-12);
    EXPECT_DOUBLE_EQ(mill.radial_depth, 10);
    EXPECT_NEAR(mill.chip_largest, 0.1, 1e-12);
    EXPECT_NEAR(mill.chip_mean, 0.1, 1e-12);
    shop::Tool drill = tool_of(shop::ToolKind::drill, 5, 2);
    drill.point_angle = 118;
    const EdgeEngagement d = of(drill, move_of(0, 5, 4, 1));
    EXPECT_NEAR(d.chip_largest, 0.2 * std::sin(59 * degree), 1e-12);
    EXPECT_NEAR(d.chip_mean, d.chip_largest, 1e-12);
}

/// A ball of radius 5 in 1 mm deep material: its edge has a radius of 3 there and leans by acos(0.8).
TEST(Engagement, ABallCountsAtTheHeightOfTheMaterial) {
    const EdgeEngagement e = of(tool_of(shop::ToolKind::ball, 5), move_of(-3, 3, 1));
    EXPECT_NEAR(e.from, -90 * degree, 1e-9);
    EXPECT_NEAR(e.to, 90 * degree, 1e-9);
    EXPECT_NEAR(e.chip_largest, 0.1 * 0.6, 1e-12);
    EXPECT_NEAR(e.chip_mean, 0.1 * 0.6 * 2 / geom::pi, 1e-9);
    shop::Tool bull = tool_of(shop::ToolKind::bull_nose, 10);
    bull.corner_radius = 5;
    EXPECT_NEAR(of(bull, move_of(-8, 8, 1)).chip_largest, 0.1 * 0.6, 1e-12);
    EXPECT_NEAR(of(bull, move_of(-8, 8, 1)).to, 90 * degree, 1e-9);
    EXPECT_NEAR(of(bull, move_of(-10, 10, 6)).chip_largest, 0.1, 1e-12);
}

/// 30 degrees down: the flat end takes f_z sin 30, the flank f_z cos 30; of a ball the place where the edge faces the
/// way is as thick as the feed, if the material reaches up to there (1 - cos 60, times 5), else where it ends.
TEST(Engagement, ObliqueWaysShareTheFeed) {
    const double down = 0.5;
    const EdgeEngagement flank = of(tool_of(shop::ToolKind::end_mill, 10), move_of(-10, 10, 5, down));
    EXPECT_NEAR(flank.chip_largest, 0.1 * std::cos(30 * degree), 1e-12);
    const EdgeEngagement side = of(tool_of(shop::ToolKind::end_mill, 10), move_of(9.9, 10, 5, down));
    EXPECT_NEAR(side.chip_largest, 0.1 * 0.5, 1e-12) << "the end is thicker than the flank";
    const shop::Tool ball = tool_of(shop::ToolKind::ball, 5);
    EXPECT_NEAR(of(ball, move_of(-3, 3, 3, down)).chip_largest, 0.1, 1e-12);
    const double lean = std::acos(0.8);
    EXPECT_NEAR(of(ball, move_of(-3, 3, 1, down)).chip_largest,
                0.1 * (std::cos(30 * degree) * std::sin(lean) + 0.5 * std::cos(lean)), 1e-12);
    EXPECT_NEAR(of(ball, move_of(-3, 3, 1, -down)).chip_largest,
                0.1 * (std::cos(30 * degree) * std::sin(lean) - 0.5 * std::cos(lean)), 1e-12);
}

TEST(Engagement, WhatIsNotKnownIsNotANumber) {
    const shop::Tool mill = tool_of(shop::ToolKind::end_mill, 10);
    const EdgeEngagement no_teeth = of(tool_of(shop::ToolKind::end_mill, 10, 0), move_of(-10, 0, 5));
    EXPECT_TRUE(std::isnan(no_teeth.feed_per_tooth) && std::isnan(no_teeth.chip_largest));
    EXPECT_NEAR(no_teeth.to, 0, 1e-12);
    MilledMove m = move_of(-10, 10, 5);
    m.feed_per_rev_mm = NAN;
    EXPECT_TRUE(std::isnan(of(mill, m).chip_mean));
    MilledMove nothing = move_of(INFINITY, -INFINITY, 0);
    EXPECT_TRUE(std::isnan(of(mill, nothing).radial_depth));
    EXPECT_DOUBLE_EQ(of(mill, nothing).feed_per_tooth, 0.1);
    EXPECT_TRUE(std::isnan(of(tool_of(shop::ToolKind::end_mill, 0), move_of(-1, 1, 1)).from));
}

namespace {

struct Cut {
    MilledMove move;
    double rays = 0;  ///< distance
};
/// The feed move through a block of 60 x 40 x 40 with its upper side at 0; 4000 1/min, 1600 mm/min: 0.1 mm per tooth.
Cut milled(const shop::Tool& tool, geom::Vec3 from, geom::Vec3 to, double tolerance) {
    Setup s;
    s.machine.kind = shop::MachineKind::mill;
    s.tools = {tool};
    s.tools_given = true;
    s.milling.emplace();
    s.milling->stock = sim::milling::Box3{{0, 0, -40}, {60, 40, 0}};
    s.milling->tolerance = tolerance;
    const cl::CallStacks stacks;
    Check check(std::move(s), stacks);
    const auto take = [&](cl::Step step) { check.take({std::move(step), {0, 0, 1}, 0}); };
    take(cl::ToolChange{1, 1, ""});
    take(cl::Spindle{4000, cl::SpindleMode::rpm, 1, 0});
    take(cl::Linear{from, {0, 0, 1}, true});
    take(cl::Feed{1600, cl::FeedMode::per_minute});
    take(cl::Linear{to, {0, 0, 1}, false});
    const Result r = check.finish();
    const geom::Vec3 step = r.milled->figures.step;
    return {r.milled->moves.back(), std::max({step.x, step.y, step.z})};
}

}  // namespace

TEST(Engagement, SimulatedSlotAndSideCuts) {
    const shop::Tool tool = tool_of(shop::ToolKind::end_mill, 5);
    const CuttingEdges edges(tool);
    const auto slot = milled(tool, {-20, 20.03, -4}, {80, 20.03, -4}, 0.005);
    EXPECT_NEAR(slot.move.axial_depth_mm, 4, 1e-9);
    EXPECT_NEAR(slot.move.reach_mm, 4, 1e-9);
    EXPECT_NEAR(slot.move.volume_mm3, 60 * 10 * 4, 0.01 * 2400);
    const EdgeEngagement full = engagement_of(slot.move, edges, slot.rays);
    EXPECT_NEAR(full.radial_depth, 10, 1e-9);
    EXPECT_NEAR(full.to - full.from, 180 * degree, 1e-6);
    EXPECT_NEAR(full.feed_per_tooth, 0.1, 1e-12);
    EXPECT_NEAR(full.chip_largest, 0.1, 1e-12);
    for (const double width : {1.0, 2.5, 5.0, 8.0}) {
        // The block lies left of a way in +x along its lower side in y, right of one in -x.
        for (const bool right : {false, true}) {
            const double y = width - 5, a = right ? 80 : -20, b = right ? -20 : 80;
            const auto cut = milled(tool, {a, y, -6}, {b, y, -6}, 0.005);
            const EdgeEngagement e = engagement_of(cut.move, edges, cut.rays);
            EXPECT_NEAR(e.radial_depth, width, cut.rays / 2 + 1e-9) << width;
            EXPECT_NEAR(cut.move.axial_depth_mm, 6, 1e-9);
            const double inner = std::asin((5 - width) / 5);
            EXPECT_NEAR(right ? -e.to : e.from, inner, 0.1) << width << " rays " << cut.rays;
            EXPECT_NEAR(right ? -e.from : e.to, 90 * degree, 1e-6) << width;
        }
    }
}

TEST(Engagement, SimulatedDrillingIsAllRound) {
    shop::Tool drill = tool_of(shop::ToolKind::drill, 4, 2);
    drill.point_angle = 118;
    const auto hole = milled(drill, {30, 20, 1}, {30, 20, -20}, 0.005);
    EXPECT_DOUBLE_EQ(hole.move.sinking, 1);
    const EdgeEngagement e = engagement_of(hole.move, CuttingEdges(drill), hole.rays);
    EXPECT_NEAR(e.radial_depth, 4, 1e-9);
    EXPECT_NEAR(e.to - e.from, 2 * geom::pi, 1e-12);
    EXPECT_NEAR(e.chip_largest, 0.2 * std::sin(59 * degree), 1e-9);
}

/// A ball of 6 mm, 0.5 mm deep: a groove 2 sqrt(2 * 3 * 0.5 - 0.25) wide.
TEST(Engagement, SimulatedBallTrench) {
    const shop::Tool ball = tool_of(shop::ToolKind::ball, 3);
    const auto cut = milled(ball, {-20, 20, -0.5}, {80, 20, -0.5}, 0.005);
    EXPECT_NEAR(cut.move.reach_mm, 0.5, 1e-9);
    const EdgeEngagement e = engagement_of(cut.move, CuttingEdges(ball), cut.rays);
    EXPECT_NEAR(e.radial_depth, 2 * std::sqrt(2.75), 1e-9);
    EXPECT_NEAR(e.to - e.from, 180 * degree, 1e-6);
    EXPECT_NEAR(e.chip_largest, 0.1 * std::sqrt(2.75) / 3, 1e-9);
}

}  // namespace obrys::check
