/// The structs of this room and their tables: what a struct says by roles it reads again, and each of its values
/// counts.

#include "cycles/hole/families.hpp"
#include "cycles/hole/hole_testing.hpp"
#include "cycles/typed_testing.hpp"

namespace obrys::cycles::test {
namespace {

template <class Cycle>
class typed_holes : public ::testing::Test {};

using All =
    ::testing::Types<OldPecking, DepthDrilling, UniversalDrilling, UniversalPecking, Centring, SingleLipDrilling,
                     Reaming, DepthBoring, Counterboring, BoreMilling, OldFloatingTapping, DepthFloatingTapping,
                     OldRigidTapping, DepthRigidTapping, ChipBreakTapping, ThreadCutting, ThreadMilling,
                     CountersunkThreadMilling, DrilledThreadMilling, HelicalThreadMilling, OutsideThreadMilling,
                     Drilling, ChipBreakDrilling, PeckDrilling, DeepDrilling, FloatingTapping, RigidTapping, FeedBoring,
                     StopBoring, OrientedBoring, BackBoring, ManualBoring>;
TYPED_TEST_SUITE(typed_holes, All);

TYPED_TEST(typed_holes, SaysByRolesWhatItReadsAgain) { expect_round_trip<TypeParam>(); }

TYPED_TEST(typed_holes, TheKindSaysTheSameRoles) {
    const auto roles = roles_of_hole(TypeParam::kind);
    EXPECT_TRUE(
        std::equal(roles.begin(), roles.end(), roles_of_cycle<TypeParam>.begin(), roles_of_cycle<TypeParam>.end()));
}

TEST(hole_structs, AStructIsExpandedAsItsRolesAre) {
    Drilling d;
    d.target_u = 3, d.target_v = -4;
    d.retract_plane = 2, d.bottom = -20, d.return_level = 50;
    d.dwell_bottom = 0.5;
    EXPECT_EQ(script_or_complaints(expand_hole(demand_of(d), situation()), situation()),
              run(Kind::canned_drill, {{Role::target_u, 3},
                                       {Role::target_v, -4},
                                       {Role::retract_plane, 2},
                                       {Role::bottom, -20},
                                       {Role::return_level, 50},
                                       {Role::dwell_bottom, 0.5}}));
    EXPECT_EQ(run(Kind::canned_drill, demand_of(d).values), "R u3 v-4 R w2 L w-20 D0.5 R w50");
}

TEST(hole_structs, WhatIsNeededAndNotFilledIsNotKnown) {
    Drilling d;
    d.target_u = d.target_v = 0;
    d.retract_plane = 2;
    const Expansion e = expand_hole(demand_of(d), situation());
    EXPECT_FALSE(e.simulated);
    EXPECT_TRUE(e.steps.empty());
}

/// A tap that says no pitch is one that follows feed and speed; nothing written is not 0.
TEST(hole_structs, NotSaidIsNotZero) {
    RigidTapping d;
    d.retract_plane = 2, d.bottom = -10;
    EXPECT_FALSE(demand_of(d).find(Role::pitch));
    d.pitch = 0;
    EXPECT_EQ(complaints(expand_hole(demand_of(d), situation())), "thread pitch must be greater than 0\n");
}

}  // namespace
}  // namespace obrys::cycles::test
