#include <gtest/gtest.h>

#include "cycles/hole/hole_testing.hpp"

namespace obrys::cycles::test {
namespace {

const Values bore_hole = {{Role::clearance, 2},         {Role::depth, -20},       {Role::surface, 0},
                          {Role::second_clearance, 50}, {Role::feed_plunge, 250}, {Role::dwell_bottom, 0.5}};

TEST(bore, Ream) {
    EXPECT_EQ(run(Kind::ream, with(bore_hole, {{Role::feed_retract, 500}})), "R w2 F250 L w-20 D0.5 F500 L w2 R w50");
    EXPECT_EQ(run(Kind::ream, with(bore_hole, {{Role::feed_retract, 0}})), "R w2 F250 L w-20 D0.5 L w2 R w50");
    EXPECT_EQ(run(Kind::ream, with(bore_hole, {{Role::feed_retract, HUGE_VAL}})), "R w2 F250 L w-20 D0.5 R w2 R w50");
}

TEST(bore, DisengagesSideways) {
    EXPECT_EQ(run(Kind::bore, with(bore_hole, {{Role::retract_direction, 1}, {Role::feed_retract, 400}})),
              "R w2 F250 L w-20 D0.5 S0 held F400 L u9.8 L w2 R w50 R u10 S1000");
    EXPECT_EQ(run(Kind::bore, with(bore_hole, {{Role::retract_direction, 4}})),
              "R w2 F250 L w-20 D0.5 S0 held L v20.2 L w2 R w50 R v20 S1000");
    EXPECT_EQ(run(Kind::bore, with(bore_hole, {{Role::retract_direction, 0}})),
              "R w2 F250 L w-20 D0.5 S0 held L w2 R w50 S1000");
    EXPECT_FALSE(expand_hole({Kind::bore, with(bore_hole, {{Role::retract_direction, 5}})}, situation()).ok());
}

const Values back_bore = {{Role::clearance, 2},          {Role::surface, 0},          {Role::second_clearance, 50},
                          {Role::counterbore_depth, 5},  {Role::thickness, 20},       {Role::off_centre, 3.5},
                          {Role::edge_height, 15},       {Role::feed_position, 750},  {Role::dwell, 1},
                          {Role::feed_countersink, 200}, {Role::retract_direction, 1}};

// Edge 2 below the underside: tip -20 - 2 - 15; edge 5 into it: tip -20 + 5 - 15.
TEST(bore, BackBoring) {
    EXPECT_EQ(
        run(Kind::back_bore, back_bore),
        "R w2 S0 held F750 L u6.5 L w-37 L u10 S1000 F200 L w-30 D1 F750 L w-37 S0 held L u6.5 L w2 R w50 R u10 S1000");
    EXPECT_FALSE(expand_hole({Kind::back_bore, with(back_bore, {{Role::retract_direction, 0}})}, situation()).ok());
    EXPECT_FALSE(expand_hole({Kind::back_bore, with(back_bore, {{Role::counterbore_depth, -5}})}, situation()).ok());
    EXPECT_FALSE(expand_hole({Kind::back_bore, with(back_bore, {{Role::counterbore_depth, 21}})}, situation()).ok());
    const Expansion none = expand_hole({Kind::back_bore, with(back_bore, {{Role::counterbore_depth, 0}})}, situation());
    EXPECT_TRUE(none.ok() && none.steps.empty());
}

// Hole 16, tool 10: path radius 3. 22 mm at 4 a turn: 5.5 turns, then a full circle where the helix ended (u7).
TEST(bore, MillsAHelix) {
    const Values v = with(bore_hole, {{Role::infeed_per_turn, 4}, {Role::diameter, 16}});
    EXPECT_EQ(run(Kind::bore_mill, v), "R w2 F250 A180 u13 A1980 u7 w-20 A360 L u10 R w50");
    EXPECT_EQ(run(Kind::bore_mill, with(v, {{Role::direction, -1}})),
              "R w2 F250 A-180 u13 A-1980 u7 w-20 A-360 L u10 R w50");
    EXPECT_EQ(run(Kind::bore_mill, with(v, {{Role::diameter, 10}})), "R w2 F250 L w-20 R w50");
}

TEST(bore, MillsOnlyWhatLeavesNoCore) {
    const Values v = with(bore_hole, {{Role::infeed_per_turn, 4}});
    EXPECT_FALSE(expand_hole({Kind::bore_mill, with(v, {{Role::diameter, 9}})}, situation()).ok());
    EXPECT_TRUE(expand_hole({Kind::bore_mill, with(v, {{Role::diameter, 20}})}, situation()).ok());
    EXPECT_FALSE(expand_hole({Kind::bore_mill, with(v, {{Role::diameter, 21}})}, situation()).ok());
    EXPECT_TRUE(
        expand_hole({Kind::bore_mill, with(v, {{Role::diameter, 21}, {Role::predrilled_diameter, 15}})}, situation())
            .ok());
}

}  // namespace
}  // namespace obrys::cycles::test
