#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include "cycles/hole/hole_testing.hpp"

namespace obrys::cycles::test {
namespace {

const Values drill_hole = {{Role::clearance, 2},         {Role::depth, -20},       {Role::surface, 0},
                           {Role::second_clearance, 50}, {Role::feed_plunge, 250}, {Role::dwell_bottom, 0.5}};

TEST(drill, PecksToDepth) {
    EXPECT_EQ(run(Kind::drill, with(drill_hole, {{Role::infeed, 8}, {Role::dwell_top, 0.2}})),
              "R w2 F250 L w-8 R w2 D0.2 R w-6 L w-16 R w2 D0.2 R w-14 L w-20 D0.5 R w50");
}

TEST(drill, InOneGo) {
    EXPECT_EQ(run(Kind::drill, with(drill_hole, {{Role::infeed, 20}})), "R w2 F250 L w-20 D0.5 R w50");
    EXPECT_EQ(run(Kind::drill, with(drill_hole, {{Role::infeed, 99}})), "R w2 F250 L w-20 D0.5 R w50");
}

TEST(drill, SecondClearanceBelowTheFirstDoesNotLower) {
    EXPECT_EQ(run(Kind::drill, with(drill_hole, {{Role::infeed, 20}, {Role::second_clearance, 0}})),
              "R w2 F250 L w-20 D0.5 R w2");
}

TEST(drill, SurfaceShiftsAllHeights) {
    EXPECT_EQ(run(Kind::drill, with(drill_hole, {{Role::infeed, 20}, {Role::surface, -10}})),
              "R w-8 F250 L w-30 D0.5 R w40");
}

TEST(drill, DepthOfTheFullDiameter) {  // radius 5, 90 degrees: the point is 5 mm long
    EXPECT_EQ(run(Kind::drill, with(drill_hole, {{Role::infeed, 99}, {Role::depth_reference, 1}})),
              "R w2 F250 L w-25 D0.5 R w50");
}

TEST(drill, PositionInTheAxisNeedNotBeKnown) {
    Situation s = situation();
    s.at.z = unknown;
    EXPECT_EQ(run(Kind::drill, with(drill_hole, {{Role::infeed, 20}}), s), "R w2 F250 L w-20 D0.5 R w50");
}

TEST(drill, OldPeckingStartsWhereTheToolStands) {
    const Values v = {{Role::clearance, 2}, {Role::depth, -20}, {Role::infeed, 10}, {Role::dwell, 1}};
    EXPECT_EQ(run(Kind::peck, with(v, {{Role::feed_plunge, 100}}), situation(2)),
              "F100 L w-10 R w2 R w-9.4 L w-20 D1 R w2");
    // Signs as older programs write them; feed programmed last.
    EXPECT_EQ(run(Kind::peck, {{Role::clearance, -2}, {Role::depth, -20}, {Role::infeed, -10}}, situation(7)),
              "F80 L w-5 R w7 R w-4.4 L w-15 R w7");
}

TEST(drill, OldPeckingAdvancedStop) {
    const auto stop = [](double depth) {
        const Expansion e = expand_hole(
            {Kind::peck, {{Role::clearance, 10}, {Role::depth, depth}, {Role::infeed, -depth / 2}}}, situation(10));
        return std::get<cl::Linear>(e.steps.at(3)).to.z - std::get<cl::Linear>(e.steps.at(1)).to.z;
    };
    EXPECT_NEAR(stop(-20), 0.6, 1e-12);
    EXPECT_NEAR(stop(-30), 0.6, 1e-12);
    EXPECT_NEAR(stop(-100), 2, 1e-12);
    EXPECT_NEAR(stop(-600), 7, 1e-12);
}

TEST(drill, UniversalWithBreaksAndDecrement) {  // infeeds 8, 6, 4, 3 (least)
    EXPECT_EQ(run(Kind::universal_drill, with(drill_hole, {{Role::infeed, 8},
                                                           {Role::decrement, 2},
                                                           {Role::min_infeed, 3},
                                                           {Role::breaks_before_retract, 2},
                                                           {Role::chip_break_distance, 0.2},
                                                           {Role::dwell_top, 0.1},
                                                           {Role::feed_retract, 1000}})),
              "R w2 F250 L w-8 F3000 L w-7.8 F250 L w-14 F3000 L w-13.8 F250 L w-18 F1000 L w2 D0.1 R w-16 F250 L w-20 "
              "D0.5 F1000 L w2 R w50");
}

TEST(drill, UniversalWithoutBreaksRetractsAtPlungeFeed) {
    EXPECT_EQ(run(Kind::universal_drill, with(drill_hole, {{Role::infeed, 12}, {Role::feed_retract, 0}})),
              "R w2 F250 L w-12 L w2 R w-10 L w-20 D0.5 L w2 R w50");
}

TEST(drill, DecrementWithoutLeastInfeedNeverArrives) {
    const Expansion e =
        expand_hole({Kind::universal_drill, with(drill_hole, {{Role::infeed, 4}, {Role::decrement, 2}})}, situation());
    EXPECT_FALSE(e.ok());
    EXPECT_TRUE(e.steps.empty());
    EXPECT_EQ(e.complaints.at(0).role, Role::infeed);
}

TEST(drill, UniversalPeckWithBreaks) {
    EXPECT_EQ(
        run(Kind::universal_peck, with(drill_hole, {{Role::infeed, 10},
                                                    {Role::stop_distance_first, 0.5},
                                                    {Role::stop_distance_last, 1},
                                                    {Role::chip_break_depth, 5},
                                                    {Role::chip_break_distance, 0.25}})),
        "R w2 F250 L w-5 F3000 L w-4.75 F250 L w-10 R w2 R w-9.5 L w-15 F3000 L w-14.75 F250 L w-20 D0.5 R w2 R w50");
}

TEST(drill, AdvancedStopDistancesGrowEvenly) {  // returns to -5, -10, -15: 0.5, 1, 1.5 above
    EXPECT_EQ(
        run(Kind::universal_peck,
            with(drill_hole, {{Role::infeed, 5}, {Role::stop_distance_first, 0.5}, {Role::stop_distance_last, 1.5}})),
        "R w2 F250 L w-5 R w2 R w-4.5 L w-10 R w2 R w-9 L w-15 R w2 R w-13.5 L w-20 D0.5 R w2 R w50");
}

TEST(drill, DeepenedStart) {
    EXPECT_EQ(run(Kind::universal_peck,
                  with(drill_hole, {{Role::infeed, 99}, {Role::deepened_start, 6}, {Role::feed_position, 500}})),
              "R w2 F500 L w-4 F250 L w-20 D0.5 R w2 R w50");
    EXPECT_FALSE(
        expand_hole({Kind::universal_peck,
                     with(drill_hole, {{Role::infeed, 99}, {Role::deepened_start, 21}, {Role::feed_position, 500}})},
                    situation())
            .ok());
}

TEST(drill, CentresToDiameter) {  // 8 mm wide at 90 degrees: 4 mm deep
    const Values v = {{Role::clearance, 2}, {Role::surface, 1}, {Role::second_clearance, 10}, {Role::feed_plunge, 200}};
    EXPECT_EQ(run(Kind::centre, with(v, {{Role::centre_by_diameter, 1}, {Role::diameter, -8}})),
              "R w3 F200 L w-3 R w11");
    EXPECT_EQ(run(Kind::centre, with(v, {{Role::centre_by_diameter, 0}, {Role::depth, -2}, {Role::dwell_bottom, 0.1}})),
              "R w3 F200 L w-1 D0.1 R w11");
    Situation s = situation();
    s.tool_point_angle = unknown;
    EXPECT_FALSE(
        expand_hole({Kind::centre, with(v, {{Role::centre_by_diameter, 1}, {Role::diameter, -8}})}, s).simulated);
}

TEST(drill, SingleLip) {
    EXPECT_EQ(run(Kind::single_lip, with(drill_hole, {{Role::deepened_start, 5},
                                                      {Role::feed_position, 500},
                                                      {Role::feed_retract, 1000},
                                                      {Role::spindle_direction, 3},
                                                      {Role::spindle_speed_position, 25},
                                                      {Role::spindle_speed, 2000},
                                                      {Role::coolant_on, 8},
                                                      {Role::coolant_off, 9}})),
              "R w2 S25 F500 L w-3 S2000 M8 F250 L w-20 D0.5 M9 S25 F1000 L w2 R w50");
}

RC_GTEST_PROP(drill, FeedPathFollowsFromTheNumberOfPecks, ()) {
    const double depth = *rc::gen::inRange(1, 4000) / 100.0, infeed = *rc::gen::inRange(5, 3000) / 100.0;
    const double clearance = *rc::gen::inRange(0, 500) / 100.0, surface = *rc::gen::inRange(-5000, 5000) / 100.0;
    const Situation s = situation(200);
    const Expansion e = expand_hole(
        {Kind::drill,
         with(drill_hole,
              {{Role::depth, -depth}, {Role::infeed, infeed}, {Role::clearance, clearance}, {Role::surface, surface}})},
        s);
    RC_ASSERT(e.ok());
    const Walk w = walk(e, s.at);
    const double pecks = std::ceil(depth / infeed - 1e-9);
    RC_ASSERT(w.feed_moves == std::size_t(pecks));
    RC_ASSERT(std::abs(w.feed_length - (depth + pecks * clearance)) < 1e-6);
    RC_ASSERT(std::abs(w.lowest - (surface - depth)) < 1e-9);
    RC_ASSERT(w.highest_feed <= surface + clearance + 1e-9);
    RC_ASSERT(std::abs(w.end.z - (surface + 50)) < 1e-9);
}

RC_GTEST_PROP(drill, ChipBreaksAddTwiceTheirDistance, ()) {
    const double depth = *rc::gen::inRange(100, 6000) / 100.0, infeed = *rc::gen::inRange(50, 3000) / 100.0;
    const double every = *rc::gen::inRange(20, 900) / 100.0, distance = *rc::gen::inRange(0, 20) / 100.0;
    const Situation s = situation(200);
    const Values v =
        with(drill_hole, {{Role::depth, -depth}, {Role::infeed, infeed}, {Role::stop_distance_first, 0.5}});
    const Walk plain = walk(expand_hole({Kind::universal_peck, v}, s), s.at);
    const Expansion e = expand_hole(
        {Kind::universal_peck, with(v, {{Role::chip_break_depth, every}, {Role::chip_break_distance, distance}})}, s);
    RC_ASSERT(e.ok());
    const Walk broken = walk(e, s.at);
    double breaks = 0;
    for (double done = 0; done < depth - 1e-9; done += infeed)
        breaks += std::ceil(std::min(infeed, depth - done) / every - 1e-9) - 1;
    RC_ASSERT(std::abs(broken.feed_length - plain.feed_length - 2 * breaks * distance) < 1e-6);
    RC_ASSERT(std::abs(broken.lowest + depth) < 1e-9);
}

}  // namespace
}  // namespace obrys::cycles::test
