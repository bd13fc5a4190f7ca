/// Rows beside each other, from what a simulation says of them alone: forces of
/// ../shared/spec/oracle/physics/force.json.

#include "check/force/rings.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "sim/force/milling.hpp"

namespace obrys::check::force {
namespace {

shop::Tool ball(double diameter) {
    shop::Tool t;
    t.kind = shop::ToolKind::ball;
    t.radius = t.corner_radius = diameter / 2;
    t.cutting_length = 20;
    t.teeth = 4;
    return t;
}

shop::Tool end_mill(double diameter) {
    shop::Tool t;
    t.kind = shop::ToolKind::end_mill;
    t.radius = diameter / 2;
    t.cutting_length = 20;
    t.teeth = 4;
    return t;
}

sim::cutting::Law oracle_law() {
    sim::cutting::Law law;
    law.cut = {750, 300, 150};
    law.edge = {20, 15, 3};
    return law;
}

sim::force::Forces forces_of(const Engaged& e, double feed) {
    return sim::force::forces(e.rings, 4, {feed, 0}, oracle_law(), 360);
}

/// A row of a ball at 0.75 mm from the last one, 1 mm deep: what is left of the way of the last row, to the right.
TEST(Engaged, rows_of_a_ball) {
    Met met;
    met.high = 1;
    met.right = -0.375;
    met.left = 3;
    met.section = 0.7476742192421858;
    met.way = {1, 0};
    const Engaged e = engaged(edges_of(ball(10), 0), met);
    EXPECT_NEAR(e.share, 1, 1e-3);
    const sim::force::Forces f = forces_of(e, 0.018);
    EXPECT_NEAR(f.mean_resultant, 65.09848191063196, 0.03 * 65);
    EXPECT_NEAR(f.peak, 92.63386702148166, 0.05 * 93);
}

TEST(Engaged, a_shallower_row_of_a_ball) {
    Met met;
    met.high = 0.3;
    met.right = -0.15;
    met.left = std::sqrt(25 - 4.7 * 4.7);
    met.section = 0.08944286104679135;
    met.way = {1, 0};
    const sim::force::Forces f = forces_of(engaged(edges_of(ball(10), 0), met), 0.018);
    EXPECT_NEAR(f.mean_resultant, 30.166152076160266, 0.03 * 30);
}

TEST(Engaged, a_wall_and_a_slot_of_an_end_mill) {
    Met met;
    met.high = 5;
    met.right = -5;
    met.left = -3;
    met.section = 10;
    met.way = {1, 0};
    const sim::force::Forces wall = forces_of(engaged(edges_of(end_mill(10), 0), met), 0.035);
    EXPECT_NEAR(wall.mean_resultant, 110.17215897772088, 0.01 * 110);
    EXPECT_NEAR(wall.peak, 238.76006189011022, 0.01 * 239);
    met.left = 5;
    met.section = 50;
    const Engaged slot = engaged(edges_of(end_mill(10), 0), met);
    EXPECT_NEAR(slot.share, 1, 1e-6);
    EXPECT_NEAR(sim::force::section(slot.rings, met.way), 50, 1e-6);
    met.section = 25;  // half of it was air
    EXPECT_NEAR(engaged(edges_of(end_mill(10), 0), met).share, 0.5, 1e-6);
}

/// Straight down the end of the tool removes its circle, on a ramp the end and the flank share what is removed.
TEST(Engaged, downwards_the_end_cuts) {
    Met met;
    met.high = 1;
    met.all_round = true;
    met.right = -5;
    met.left = 5;
    met.way = {0, 1};
    const Engaged down = engaged(edges_of(end_mill(10), 0), met);
    EXPECT_NEAR(sim::force::section(down.rings, met.way), geom::pi * 25, 0.02 * geom::pi * 25);
    EXPECT_GT(sim::force::forces(down.rings, 4, {0, 0.02}, oracle_law()).mean.z, 0);
}

}  // namespace
}  // namespace obrys::check::force
