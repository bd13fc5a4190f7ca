#include <gtest/gtest.h>

#include <algorithm>

#include "cycles/hole/hole_testing.hpp"

namespace obrys::cycles::test {
namespace {

// Core 24 wide is not wider than the tool (10) by 4 pitches (4 * 4), so the tool starts on the axis; path radius 7.
const Values thread_mill_hole = {{Role::clearance, 2},         {Role::depth, -16},   {Role::surface, 0},
                                 {Role::second_clearance, 50}, {Role::diameter, 24}, {Role::pitch, 4},
                                 {Role::feed_position, 750},   {Role::direction, 1}, {Role::feed_mill, 400}};

TEST(thread_mill, OneTurnRightHandClimbGoesUp) {
    EXPECT_EQ(run(Kind::thread_mill, thread_mill_hole),
              "R w2 F750 L w-18 F400 A180 u17 w-16 A360 w-12 A180 u10 w-10 R w2 R w50");
}

TEST(thread_mill, WorkDirectionFollowsHandAndWayOfMilling) {
    const std::string down = "R w2 F750 L w-10 F400 A-180 u17 w-12 A-360 w-16 A-180 u10 w-18 R w2 R w50";
    EXPECT_EQ(run(Kind::thread_mill, with(thread_mill_hole, {{Role::direction, -1}})), down);
    const std::string left_up = "R w2 F750 L w-18 F400 A-180 u17 w-16 A-360 w-12 A-180 u10 w-10 R w2 R w50";
    EXPECT_EQ(run(Kind::thread_mill, with(thread_mill_hole, {{Role::pitch, -4}, {Role::direction, -1}})), left_up);
    const std::string left_down = "R w2 F750 L w-10 F400 A180 u17 w-12 A360 w-16 A180 u10 w-18 R w2 R w50";
    EXPECT_EQ(run(Kind::thread_mill, with(thread_mill_hole, {{Role::pitch, -4}})), left_down);
}

TEST(thread_mill, ContinuousOverTheLength) {  // 16 / 4 = 4 turns
    EXPECT_EQ(run(Kind::thread_mill, with(thread_mill_hole, {{Role::threads_per_step, 1}})),
              "R w2 F750 L w-18 F400 A180 u17 w-16 A1440 w0 A180 u10 w2 R w50");
}

TEST(thread_mill, SeveralThreadsPerStep) {  // steps of 3 * 4: from -16 and from -4
    EXPECT_EQ(run(Kind::thread_mill, with(thread_mill_hole, {{Role::threads_per_step, 3}})),
              "R w2 F750 L w-18 F400 A180 u17 w-16 A360 w-12 A180 u10 w-10 "
              "F750 L w-6 F400 A180 u17 w-4 A360 w0 A180 u10 w2 R w50");
}

TEST(thread_mill, WideHoleIsEnteredFromTheSide) {
    const Expansion e = expand_hole({Kind::thread_mill, with(thread_mill_hole, {{Role::diameter, 60}})}, situation());
    ASSERT_TRUE(e.ok());
    EXPECT_FALSE(e.assumption.empty());
    EXPECT_EQ(script(e, situation().at),
              "R w2 F750 L u27 L w-18 F400 A180 u35 w-16 A360 w-12 A180 u27 w-10 R w2 R u10 R w50");
}

TEST(thread_mill, ToolMustFit) {
    const Expansion e = expand_hole({Kind::thread_mill, with(thread_mill_hole, {{Role::diameter, 10}})}, situation());
    EXPECT_FALSE(e.ok());
    EXPECT_EQ(e.complaints.at(0).role, Role::diameter);
}

TEST(thread_mill, HelixDownThenCountersink) {
    const Values front = {{Role::front_depth, -3}, {Role::front_offset, 4}, {Role::feed_countersink, 150}};
    EXPECT_EQ(run(Kind::thread_mill_helix, with(with(thread_mill_hole, front), {{Role::countersink_order, 0}})),
              "R w2 F750 L w-3 F150 A-180 u14 A-360 A-180 u10 F750 L w2 F400 A-180 u17 w0 A-1440 w-16 A-180 u10 w-18 "
              "R w2 R w50");
    EXPECT_EQ(run(Kind::thread_mill_helix, with(with(thread_mill_hole, front), {{Role::countersink_order, 1}})),
              "R w2 F400 A-180 u17 w0 A-1440 w-16 A-180 u10 w-18 F750 L w-3 F150 A-180 u14 A-360 A-180 u10 R w2 R w50");
}

TEST(thread_mill, DrillsFirst) {
    EXPECT_EQ(
        run(Kind::thread_mill_drill, with(thread_mill_hole, {{Role::hole_depth, -20},
                                                             {Role::infeed, 12},
                                                             {Role::stop_distance_first, 0.5},
                                                             {Role::feed_plunge, 150}})),
        "R w2 F150 L w-12 R w2 R w-11.5 L w-20 R w2 F750 L w-18 F400 A180 u17 w-16 A360 w-12 A180 u10 w-10 R w2 R w50");
}

TEST(thread_mill, CountersinkingAtTheCoreIsNotMadeUp) {
    const Expansion e = expand_hole(
        {Kind::thread_mill_countersink, with(thread_mill_hole, {{Role::countersink_depth, -18}})}, situation());
    EXPECT_FALSE(e.simulated);
    EXPECT_TRUE(e.steps.empty());
    EXPECT_TRUE(expand_hole({Kind::thread_mill_countersink, thread_mill_hole}, situation()).ok());
}

// Stud 24, tool 10: path radius 17, start two pitches further out. Climb is clockwise: a right-hand thread goes down.
TEST(thread_mill, Outside) {
    EXPECT_EQ(run(Kind::thread_mill_outside, with(thread_mill_hole, {{Role::threads_per_step, 1}})),
              "R w2 F750 L u35 F400 A180 u27 w0 A-1440 w-16 A180 u35 w-18 R w2 R w50");
    EXPECT_EQ(run(Kind::thread_mill_outside, with(thread_mill_hole, {{Role::direction, -1}})),
              "R w2 F750 L u35 L w-18 F400 A-180 u27 w-16 A360 w-12 A-180 u35 w-10 R w2 R w50");
}

/// Direction of travel in the plane at the start or end of an arc.
geom::Vec2 heading(const cl::Arc& a, geom::Vec3 at) {
    const geom::Vec2 radial = geom::Vec2{at.x, at.y} - geom::Vec2{a.centre.x, a.centre.y};
    return (a.sweep > 0 ? 1 : -1) / geom::length(radial) * geom::left_of(radial);
}

TEST(thread_mill, ArcsMeetTangentiallyAndNeverLeaveTheThread) {
    const std::uint32_t seed = 20260711;
    Random random(seed);
    for (int round = 0; round < 2000; ++round) {
        const bool outside = random.upto(1) == 1;
        const double pitch = random.in(0.5, 4) * (random.upto(1) == 1 ? 1 : -1), depth = random.in(1, 60);
        const double diameter = random.in(11, 80);
        const Values v = with(thread_mill_hole, {{Role::diameter, diameter},
                                                 {Role::pitch, pitch},
                                                 {Role::depth, -depth},
                                                 {Role::threads_per_step, double(random.upto(4))},
                                                 {Role::direction, random.upto(1) == 1 ? 1.0 : -1.0}});
        const Situation s = situation();
        const Expansion e = expand_hole({outside ? Kind::thread_mill_outside : Kind::thread_mill, v}, s);
        ASSERT_TRUE(e.ok()) << "seed " << seed << " round " << round << ' ' << complaints(e);
        ASSERT_EQ(broken_rules(e, s.at), 0u) << "seed " << seed << " round " << round;
        const Walk w = walk(e, s.at);
        EXPECT_GE(w.lowest, -depth - std::abs(pitch) / 2 - 1e-9) << "seed " << seed << " round " << round;
        EXPECT_NEAR(w.end.z, 50, 1e-9);
        geom::Vec3 at = s.at;
        const cl::Arc* before = nullptr;
        for (const cl::Step& step : e.steps) {
            const auto* arc = std::get_if<cl::Arc>(&step);
            if (arc != nullptr && std::abs(arc->sweep) > 3.2) {  // the thread itself
                const double radius = geom::distance(geom::Vec2{at.x, at.y}, {10, 20});
                EXPECT_NEAR(radius, diameter / 2 + (outside ? 5 : -5), 1e-9);
                EXPECT_NEAR((arc->to.z - at.z) / arc->sweep * 2 * geom::pi, pitch, 1e-9);
            }
            if (arc != nullptr && before != nullptr) {
                EXPECT_GT(geom::dot(heading(*before, at), heading(*arc, at)), 1 - 1e-9)
                    << "seed " << seed << " round " << round;
            }
            if (cl::is_move(step)) {
                before = arc;
                at = cl::position_after(at, step);
            }
        }
    }
}

TEST(thread_mill, LeftHandIsTheMirrorImageOfRightHand) {
    for (const Kind kind : {Kind::thread_mill, Kind::thread_mill_outside, Kind::thread_mill_helix}) {
        const Expansion right = expand_hole({kind, thread_mill_hole}, situation());
        const Expansion left =
            expand_hole({kind, with(thread_mill_hole, {{Role::pitch, -4}, {Role::direction, -1}})}, situation());
        ASSERT_EQ(right.steps.size(), left.steps.size());
        geom::Vec3 a = situation().at, b = a;
        for (std::size_t i = 0; i < right.steps.size(); ++i) {
            a = cl::position_after(a, right.steps[i]);
            b = cl::position_after(b, left.steps[i]);
            EXPECT_NEAR(geom::distance(a, {b.x, 40 - b.y, b.z}), 0, 1e-9);
        }
    }
}

}  // namespace
}  // namespace obrys::cycles::test
