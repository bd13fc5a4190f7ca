#include <gtest/gtest.h>

#include "cycles/hole/hole_testing.hpp"

namespace obrys::cycles::test {
namespace {

const Values tap_hole = {{Role::clearance, 5}, {Role::depth, -20}, {Role::surface, 0}, {Role::second_clearance, 50}};

TEST(tap, Floating) {
    EXPECT_EQ(run(Kind::tap_floating, with(tap_hole, {{Role::feed_plunge, 1500}, {Role::dwell_bottom, 0.5}})),
              "R w5 F1500 L w-20 S-1000 D0.5 L w5 S1000 R w50");
    Situation left = situation();
    left.spindle_direction = -1;
    EXPECT_EQ(run(Kind::tap_floating, with(tap_hole, {{Role::feed_plunge, 1500}}), left),
              "R w5 F1500 L w-20 S1000 L w5 S-1000 R w50");
    left.spindle_direction = 0;
    EXPECT_FALSE(expand_hole({Kind::tap_floating, with(tap_hole, {{Role::feed_plunge, 1500}})}, left).ok());
}

TEST(tap, OldForms) {
    const Values v = {{Role::clearance, 3}, {Role::depth, -20}};
    EXPECT_EQ(run(Kind::tap_floating_simple, with(v, {{Role::dwell, 0.4}, {Role::feed_plunge, 100}}), situation(3)),
              "F100 L w-20 S-1000 D0.4 L w3 S1000");
    EXPECT_EQ(run(Kind::tap_rigid_simple, with(v, {{Role::pitch, -1}}), situation(3)),
              "S-1000 T-1 w-20 S1000 T-1 w3 S0");
    Situation nowhere = situation(unknown);
    EXPECT_FALSE(expand_hole({Kind::tap_rigid_simple, with(v, {{Role::pitch, 1}})}, nowhere).simulated);
}

TEST(tap, Rigid) {
    EXPECT_EQ(run(Kind::tap_rigid, with(tap_hole, {{Role::pitch, 1.5}})),
              "R w5 S1000 T1.5 w-20 S-1000 T1.5 w5 S0 R w50");
    EXPECT_FALSE(expand_hole({Kind::tap_rigid, with(tap_hole, {{Role::pitch, 0}})}, situation()).ok());
}

TEST(tap, ChipBreaking) {
    const Values v = with(tap_hole, {{Role::pitch, 1}, {Role::chip_break_depth, 8}});
    EXPECT_EQ(run(Kind::tap_chip_breaking, with(v, {{Role::chip_break_distance, 1}, {Role::rpm_factor, 2}})),
              "R w5 S1000 T1 w-8 S-2000 T1 w-7 S1000 T1 w-16 S-2000 T1 w-15 S1000 T1 w-20 S-2000 T1 w5 S0 R w50");
    EXPECT_EQ(run(Kind::tap_chip_breaking, with(v, {{Role::chip_break_distance, 0}})),
              "R w5 S1000 T1 w-8 S-1000 T1 w5 S1000 T1 w-16 S-1000 T1 w5 S1000 T1 w-20 S-1000 T1 w5 S0 R w50");
    EXPECT_EQ(run(Kind::tap_chip_breaking, with(v, {{Role::chip_break_depth, 0}})),
              "R w5 S1000 T1 w-20 S-1000 T1 w5 S0 R w50");
    EXPECT_FALSE(expand_hole({Kind::tap_chip_breaking, with(v, {{Role::chip_break_depth, 1e-9}})}, situation()).ok());
}

TEST(tap, ThreadCuttingGoesOneWay) {
    EXPECT_EQ(run(Kind::thread_cut, {{Role::depth, -12}, {Role::pitch, 1}}, situation(4)), "T1 w-8 S0");
    EXPECT_EQ(run(Kind::thread_cut, {{Role::depth, 12}, {Role::pitch, 1}}, situation(-8)), "T1 w4 S0");
}

}  // namespace
}  // namespace obrys::cycles::test
