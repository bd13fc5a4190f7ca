#include <gtest/gtest.h>

#include "cycles/mill/mill_testing.hpp"

namespace obrys::cycles::test {
namespace {

const Values line_passes = {{Role::start_u, 0},       {Role::start_v, 0},     {Role::start_w, 3},
                            {Role::length, 100},      {Role::width, 30},      {Role::clearance, 2},
                            {Role::feed_plunge, 150}, {Role::feed_mill, 500}, {Role::feed_step, 200}};

// Tool radius 5: along u from -5 to 105, across v from 5 to 25.
TEST(multipass, LinesBackAndForth) {
    EXPECT_EQ(run(Kind::multipass, with(line_passes, {{Role::passes, 3}})),
              "R u-5 v5 R w5 F150 L w3 F500 L u105 F200 L v15 F500 L u-5 F200 L v25 F500 L u105 R w5");
    EXPECT_EQ(run(Kind::multipass, with(line_passes, {{Role::passes, 2}, {Role::length, -100}, {Role::width, -30}}),
                  situation(1)),
              "R w5 R u5 v-5 F150 L w3 F500 L u-105 F200 L v-25 F500 L u5 R w5");
    EXPECT_FALSE(expand_mill({Kind::multipass, with(line_passes, {{Role::passes, 0}})}, situation()).ok());
    EXPECT_FALSE(expand_mill({Kind::multipass, with(line_passes, {{Role::passes, 2.5}})}, situation()).ok());
}

TEST(multipass, RuledSurface) {  // a quarter of the way up with every pass; retract by the tool's diameter
    const Values v = {{Role::start_u, 0},  {Role::start_v, 0},    {Role::start_w, 0},   {Role::second_u, 100},
                      {Role::second_v, 0}, {Role::second_w, 2},   {Role::third_u, 100}, {Role::third_v, 40},
                      {Role::third_w, 6},  {Role::fourth_u, 0},   {Role::fourth_v, 40}, {Role::fourth_w, 4},
                      {Role::passes, 3},   {Role::feed_mill, 500}};
    EXPECT_EQ(run(Kind::ruled_surface, v),
              "F500 L u0 v0 w0 F250 L u100 w2 R w12 R u0 R w0 F500 L v20 w2 L u100 w4 R w14 R u0 R w2 L v40 w4 L u100 "
              "w6 R w16");
}

const Values face_mill = {
    {Role::start_u, 0},       {Role::start_v, 0},   {Role::start_w, 3},           {Role::length, 100},
    {Role::width, 30},        {Role::clearance, 2}, {Role::second_clearance, 20}, {Role::feed_mill, 500},
    {Role::end_surface, 0},   {Role::infeed, 2},    {Role::overlap, 1.5},         {Role::feed_position, 2000},
    {Role::side_clearance, 1}};

// Overlap 1.5 * 5 = 7.5: four passes, edges at 7.5, 15, 22.5, 30, centres 5 below. Two levels, 1.5 and 0.
TEST(multipass, FaceOutside) {
    EXPECT_EQ(run(Kind::face_mill, with(face_mill, {{Role::strategy, 0}})),
              "R u-6 v2.5 R w23 F2000 L w1.5 F500 L u106 F2000 L v10 F500 L u-6 F2000 L v17.5 F500 L u106 F2000 L v25 "
              "F500 L u-6 "
              "F2000 L w0 F500 L u106 F2000 L v17.5 F500 L u-6 F2000 L v10 F500 L u106 F2000 L v2.5 F500 L u-6 R w23");
}

TEST(multipass, FaceInside) {
    EXPECT_EQ(run(Kind::face_mill,
                  with(face_mill, {{Role::strategy, 1}, {Role::infeed, 3}, {Role::overlap, 1.99}, {Role::width, 19}})),
              "R u-6 v4.5 R w23 F2000 L w0 F500 L u95 L v14 L u-6 R w23");
}

TEST(multipass, FaceOneWay) {
    EXPECT_EQ(run(Kind::face_mill,
                  with(face_mill, {{Role::strategy, 2}, {Role::infeed, 3}, {Role::overlap, 1.99}, {Role::width, 19}})),
              "R u-6 v4.5 R w23 F2000 L w0 F500 L u106 F2000 L w2 L u-6 v14 L w0 F500 L u106 R w23");
}

TEST(multipass, FaceLeavesAllowanceForTheLastInfeed) {
    const Values v = with(
        face_mill, {{Role::strategy, 0}, {Role::width, 7}, {Role::allowance_floor, 0.5}, {Role::feed_finish, 300}});
    EXPECT_EQ(run(Kind::face_mill, v),
              "R u-6 v2 R w23 F2000 L w1.75 F500 L u106 F2000 L w0.5 F500 L u-6 F2000 L w0 F300 L u106 R w23");
}

TEST(multipass, FaceComplaints) {
    const Values v = with(face_mill, {{Role::strategy, 0}});
    EXPECT_FALSE(expand_mill({Kind::face_mill, with(v, {{Role::end_surface, 4}})}, situation()).ok());
    EXPECT_FALSE(expand_mill({Kind::face_mill, with(v, {{Role::strategy, 3}})}, situation()).ok());
    EXPECT_FALSE(expand_mill({Kind::face_mill, with(v, {{Role::overlap, 2}})}, situation()).ok());
    EXPECT_FALSE(expand_mill({Kind::face_mill, with(v, {{Role::infeed, 1e-6}})}, situation()).ok());
    Situation ball = situation();
    ball.tool_corner_radius = 5;
    EXPECT_FALSE(expand_mill({Kind::face_mill, v}, ball).ok());
    ball.tool_corner_radius = 1;  // reduces the step: 1.5 * 4 = 6, five passes
    const Expansion e = expand_mill({Kind::face_mill, with(v, {{Role::infeed, 3}})}, ball);
    EXPECT_EQ(walk(e, ball.at).feed_moves, 5u + 4u + 1u);
}

// Every point of the surface lies within the tool's radius of the lowest level's path (strategies 0 and 2).
TEST(multipass, FaceCoversTheSurface) {
    const std::uint32_t seed = 20260712;
    Random random(seed);
    for (int round = 0; round < 300; ++round) {
        const double length = random.in(-200, 200), width = random.in(-200, 200);
        const Values v = with(face_mill, {{Role::strategy, random.upto(1) == 0 ? 0.0 : 2.0},
                                          {Role::length, length},
                                          {Role::width, width},
                                          {Role::infeed, random.in(0.5, 5)},
                                          {Role::overlap, random.in(0.2, 1.999)}});
        const Situation s = situation();
        const Expansion e = expand_mill({Kind::face_mill, v}, s);
        ASSERT_TRUE(e.ok()) << complaints(e) << "seed " << seed << " round " << round;
        for (int k = 0; k < 40; ++k) {
            const geom::Vec2 p{random.in(0, 1) * length, random.in(0, 1) * width};
            double nearest = 1e300;
            geom::Vec3 at = s.at;
            for (const cl::Step& step : e.steps) {
                const geom::Vec3 to = cl::position_after(at, step);
                if (at.z == 0 && to.z == 0 && at.y == to.y)
                    nearest = std::min(
                        nearest, std::hypot(std::max({0.0, std::min(at.x, to.x) - p.x, p.x - std::max(at.x, to.x)}),
                                            p.y - to.y));
                at = to;
            }
            EXPECT_LE(nearest, 5 + 1e-9) << "seed " << seed << " round " << round;
        }
    }
}

}  // namespace
}  // namespace obrys::cycles::test
