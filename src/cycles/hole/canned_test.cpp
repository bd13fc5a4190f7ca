#include "cycles/hole/canned_samples_testing.hpp"
#include "cycles/hole/hole_testing.hpp"

namespace obrys::cycles::test {
namespace {

const Values canned_hole = {{Role::target_u, 11}, {Role::target_v, 22}, {Role::retract_plane, 2}, {Role::bottom, -10}};
const Values rising = with(canned_hole, {{Role::rise_first, 1}});

Situation standing(double w) { return situation(w); }

TEST(canned, DrillGoesOverTheHoleThenDown) {
    EXPECT_EQ(run(Kind::canned_drill, canned_hole, standing(20)), "R u11 v22 R w2 L w-10 R w2");
    EXPECT_EQ(
        run(Kind::canned_drill, with(canned_hole, {{Role::return_level, 20}, {Role::dwell_bottom, 0.5}}), standing(20)),
        "R u11 v22 R w2 L w-10 D0.5 R w20");
}

TEST(canned, BelowTheRetractPlane) {
    EXPECT_EQ(run(Kind::canned_drill, with(rising, {{Role::return_level, 2}}), standing(-3)),
              "R w2 R u11 v22 L w-10 R w2");
    EXPECT_EQ(run(Kind::canned_drill, with(canned_hole, {{Role::return_level, -3}}), standing(-3)),
              "R u11 v22 R w2 L w-10 R w-3");
    EXPECT_EQ(run(Kind::canned_bore_feed, with(canned_hole, {{Role::return_level, 1}}), standing(1)),
              "R u11 v22 R w2 L w-10 L w2 R w1");
    EXPECT_EQ(run(Kind::canned_drill, canned_hole, standing(-3)), "R u11 v22 R w2 L w-10 R w2");
}

TEST(canned, FromAnUnknownPlaceInThePlane) {
    Situation s = standing(20);
    s.at.x = unknown;
    const Expansion e = expand_hole({Kind::canned_drill, canned_hole}, s);
    ASSERT_TRUE(e.ok()) << complaints(e);
    EXPECT_EQ(std::get<cl::Linear>(e.steps.front()).to, (geom::Vec3{11, 22, 20}));
    s.at.z = unknown;
    EXPECT_TRUE(expand_hole({Kind::canned_drill, canned_hole}, s).ok());
    EXPECT_FALSE(expand_hole({Kind::canned_drill, rising}, s).ok());
    EXPECT_FALSE(expand_hole({Kind::canned_drill, with(canned_hole, {{Role::target_u, unknown}})}, s).ok());
}

TEST(canned, Pecks) {
    const Values peck =
        with(canned_hole, {{Role::infeed, 5}, {Role::stop_distance_first, 0.5}, {Role::return_level, 20}});
    EXPECT_EQ(run(Kind::canned_peck, peck, standing(20)),
              "R u11 v22 R w2 L w-3 R w2 R w-2.5 L w-8 R w2 R w-7.5 L w-10 R w20");
    const Values breaking = with(canned_hole, {{Role::infeed, 5}, {Role::chip_break_distance, 0.5}});
    EXPECT_EQ(run(Kind::canned_chip_break, breaking, standing(20)),
              "R u11 v22 R w2 L w-3 R w-2.5 L w-8 R w-7.5 L w-10 R w2");
    EXPECT_EQ(
        run(Kind::canned_chip_break,
            with(breaking, {{Role::infeed, 2}, {Role::retract_every, 4}, {Role::stop_distance_first, 1}}), standing(2)),
        "R u11 v22 L w0 R w0.5 L w-2 R w2 R w-1 L w-4 R w-3.5 L w-6 R w2 R w-5 L w-8 R w-7.5 L w-10 R w2");
    EXPECT_EQ(run(Kind::canned_peck, with(peck, {{Role::decrement, 2}, {Role::min_infeed, 2}}), standing(2)),
              "R u11 v22 L w-3 R w2 R w-2.5 L w-6 R w2 R w-5.5 L w-8 R w2 R w-7.5 L w-10 R w20");
}

/// R of Acramatic is the surface, from which infeeds count; J1 to J3 begin with two larger ones; J2 stays in the hole.
TEST(canned, PecksFromTheSurface) {
    const Values hole = with(canned_hole, {{Role::surface, 0}, {Role::infeed, 2}});
    EXPECT_EQ(run(Kind::canned_peck, with(hole, {{Role::infeed, 4}, {Role::stop_distance_first, 0.5}}), standing(2)),
              "R u11 v22 L w-4 R w2 R w-3.5 L w-8 R w2 R w-7.5 L w-10 R w2");
    const Values larger = with(hole, {{Role::first_infeed, 6}, {Role::second_infeed, 3}});
    EXPECT_EQ(run(Kind::canned_chip_break, with(larger, {{Role::chip_break_distance, 0.5}}), standing(2)),
              "R u11 v22 L w-6 R w-5.5 L w-9 R w-8.5 L w-10 R w2");
    EXPECT_EQ(run(Kind::canned_chip_break,
                  with(larger, {{Role::chip_break_distance, 0.5}, {Role::first_infeed, 12}, {Role::second_infeed, 10}}),
                  standing(2)),
              "R u11 v22 L w-2 R w-1.5 L w-4 R w-3.5 L w-6 R w-5.5 L w-8 R w-7.5 L w-10 R w2");
    const Demand inside{Kind::canned_peck,
                        with(larger, {{Role::stop_distance_first, 0.5}, {Role::peck_to_surface, 1}})};
    EXPECT_EQ(run(inside.kind, inside.values, standing(2)),
              "R u11 v22 L w-6 R w0 R w-5.5 L w-9 R w0 R w-8.5 L w-10 R w2");
    EXPECT_FALSE(expand_hole(inside, standing(2)).assumption.empty());
    EXPECT_FALSE(
        expand_hole({Kind::canned_peck, with(hole, {{Role::surface, 3}, {Role::stop_distance_first, 1}})}, standing(2))
            .ok());
}

/// 1 - 10 * 0.1 in binary numbers is a little above 0: the control makes one more infeed.
TEST(canned, BinaryInfeedsKeepTheirRoundingError) {
    const Values v = {{Role::target_u, 0}, {Role::target_v, 0}, {Role::retract_plane, 1},
                      {Role::bottom, 0},   {Role::infeed, 0.1}, {Role::stop_distance_first, 0.01}};
    const Expansion exact = expand_hole({Kind::canned_peck, v}, standing(1));
    const Expansion binary = expand_hole({Kind::canned_peck, with(v, {{Role::length_unit, 1}})}, standing(1));
    ASSERT_TRUE(exact.ok() && binary.ok());
    EXPECT_EQ(exact.steps.size(), 1 + 9 * 3 + 2u);
    EXPECT_EQ(binary.steps.size(), 1 + 10 * 3 + 2u);
}

TEST(canned, FloatingTap) {
    const Values right = with(canned_hole, {{Role::spindle_direction, 1}, {Role::return_level, 20}});
    EXPECT_EQ(run(Kind::canned_tap_floating, with(right, {{Role::feed_out, 1}, {Role::dwell, 0}}), standing(20)),
              "R u11 v22 R w2 L w-10 S0 S-1000 D0 L w20 S0 S1000");
    EXPECT_EQ(
        run(Kind::canned_tap_floating, with(right, {{Role::dwell_bottom, 1}, {Role::dwell_top, 2}}), standing(20)),
        "R u11 v22 R w2 L w-10 D1 S0 S-1000 L w2 D2 S0 S1000 R w20");
    const Values left = with(right, {{Role::spindle_direction, -1}});
    EXPECT_FALSE(expand_hole({Kind::canned_tap_floating, left}, standing(20)).ok());
    EXPECT_EQ(run(Kind::canned_tap_floating, with(left, {{Role::starts_spindle, 1}}), standing(20)),
              "R u11 v22 R w2 S-1000 L w-10 S0 S1000 L w2 S0 S-1000 R w20");
    Situation still = standing(20);
    still.spindle_direction = 0;
    EXPECT_FALSE(expand_hole({Kind::canned_tap_floating, right}, still).ok());
}

TEST(canned, RigidTap) {
    const Values tap = with(canned_hole, {{Role::spindle_direction, 1}, {Role::return_level, 20}});
    Situation s = standing(20);
    s.feed = 1250;
    EXPECT_EQ(run(Kind::canned_tap_rigid, tap, s), "R u11 v22 R w2 S1000 T1.25 w-10 S-1000 T1.25 w2 S0 R w20");
    EXPECT_EQ(run(Kind::canned_tap_rigid, with(tap, {{Role::spindle_direction, -1}, {Role::pitch, 2}}), s),
              "R u11 v22 R w2 S-1000 T-2 w-10 S1000 T-2 w2 S0 R w20");
    EXPECT_EQ(run(Kind::canned_tap_rigid,
                  with(tap, {{Role::infeed, 7}, {Role::chip_break_distance, 1}, {Role::rpm_factor, 2}}), s),
              "R u11 v22 R w2 S1000 T1.25 w-5 S-2000 T1.25 w-4 S1000 T1.25 w-10 S-2000 T1.25 w2 S0 R w20");
    EXPECT_EQ(run(Kind::canned_tap_rigid, with(tap, {{Role::infeed, 7}, {Role::stop_distance_first, 2}}), s),
              "R u11 v22 R w2 S1000 T1.25 w-5 S-1000 T1.25 w2 S1000 T1.25 w-3 T1.25 w-10 S-1000 T1.25 w2 S0 R w20");
    EXPECT_EQ(
        run(Kind::canned_tap_rigid,
            with(canned_hole, {{Role::surface, 0}, {Role::infeed, 7}, {Role::chip_break_turns, 2}, {Role::dwell, 1}}),
            s),
        "R u11 v22 R w2 S1000 T1.25 w-7 D1 S-1000 T1.25 w-4.5 S1000 T1.25 w-10 D1 S-1000 T1.25 w2 S0 S1000 R")
        << "without a direction of its own the spindle goes on as before";
    EXPECT_EQ(run(Kind::canned_tap_rigid, with(tap, {{Role::infeed, 7}}), s),
              "R u11 v22 R w2 S1000 T1.25 w-5 S-1000 T1.25 w-4 S1000 T1.25 w-10 S-1000 T1.25 w2 S0 R w20")
        << "how far it goes back is the machine's";
    EXPECT_EQ(run(Kind::canned_tap_rigid, with(tap, {{Role::infeed, 0}}), s), run(Kind::canned_tap_rigid, tap, s));
    s.feed = unknown;
    EXPECT_FALSE(expand_hole({Kind::canned_tap_rigid, tap}, s).ok());
}

TEST(canned, Boring) {
    const Values bore = with(canned_hole, {{Role::return_level, 20}});
    EXPECT_EQ(run(Kind::canned_bore_feed, bore, standing(20)), "R u11 v22 R w2 L w-10 L w2 R w20");
    EXPECT_EQ(run(Kind::canned_bore_feed, with(bore, {{Role::feed_out, 1}, {Role::dwell_bottom, 0}}), standing(20)),
              "R u11 v22 R w2 L w-10 D0 L w20");
    EXPECT_EQ(run(Kind::canned_bore_stop, bore, standing(20)), "R u11 v22 R w2 L w-10 S0 R w20 S1000");
    const Values shift = {{Role::shift_u, 0.5}, {Role::shift_v, 0}};
    EXPECT_EQ(run(Kind::canned_bore_orient, with(bore, shift), standing(20)),
              "R u11 v22 R w2 L w-10 S0 held R u11.5 R w20 R u11 S1000");
    EXPECT_EQ(run(Kind::canned_bore_manual, bore, standing(20)), "R u11 v22 R w2 L w-10 S0 ? S1000");
    EXPECT_EQ(run(Kind::canned_bore_manual, with(bore, {{Role::manual_retract, 1}}), standing(20)),
              "R u11 v22 R w2 L w-10 S0 ? R w2 S1000 R w20");
}

/// Without a retract plane: in from the height where the tool is, out at the top of the counterbore.
TEST(canned, BackBoring) {
    const Values v = {{Role::target_u, 11}, {Role::target_v, 22}, {Role::bottom, -30}, {Role::counterbore_top, -25},
                      {Role::shift_u, 0},   {Role::shift_v, 3},   {Role::dwell, 1}};
    EXPECT_EQ(run(Kind::canned_back_bore, v, standing(20)),
              "R u11 v22 S0 held R v25 R w-30 R v22 S1000 L w-25 D1 S0 held R v25 R w20 R v22 S1000");
}

TEST(canned, RetractPlaneBelowTheBottom) {
    for (const Sample& s : canned_samples()) {
        const Expansion e = expand_hole({s.kind, with(s.values, {{Role::retract_plane, -21}})}, standing(20));
        EXPECT_FALSE(e.ok()) << int(s.kind);
        ASSERT_FALSE(e.complaints.empty());
        EXPECT_EQ(e.complaints.at(0).role, Role::retract_plane) << int(s.kind);
    }
}

/// Moving everything moves the steps, and nothing else; the cycle ends over the hole.
TEST(canned, PathIsCarriedAlong) {
    for (const Sample& s : canned_samples()) {
        Situation a = situation(), b = situation(137);
        b.at.x += 3;
        b.at.y -= 8;
        Values moved = s.values;
        for (cl::CycleValue& v : moved) {
            if (v.role == Role::target_u) v.value += 3;
            if (v.role == Role::target_v) v.value -= 8;
            for (const Role height :
                 {Role::retract_plane, Role::bottom, Role::return_level, Role::counterbore_top, Role::surface})
                if (v.role == height) v.value += 37;
        }
        const Expansion one = expand_hole({s.kind, s.values}, a), two = expand_hole({s.kind, moved}, b);
        ASSERT_TRUE(one.ok()) << complaints(one);
        ASSERT_EQ(one.steps.size(), two.steps.size()) << int(s.kind);
        EXPECT_EQ(walk(one, a.at).end, (geom::Vec3{3, -4, 50})) << int(s.kind);
        for (std::size_t i = 0; i < one.steps.size(); ++i) {
            a.at = cl::position_after(a.at, one.steps[i]);
            b.at = cl::position_after(b.at, two.steps[i]);
            EXPECT_NEAR(geom::distance(a.at + geom::Vec3{3, -8, 37}, b.at), 0, 1e-9) << int(s.kind) << " step " << i;
        }
    }
}

}  // namespace
}  // namespace obrys::cycles::test
