#include "shop/kinematics.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace obrys::shop {
namespace {

using geom::radians;
using geom::Vec3;

const Joint x_joint{"X", false, {1, 0, 0}, {}}, y_joint{"Y", false, {0, 1, 0}, {}}, z_joint{"Z", false, {0, 0, 1}, {}};

/// C in A, both lines through (10, 20, -300).
Chain table_ac() {
    return {
        {{"C", true, {0, 0, 1}, {10, 20, -300}}, {"A", true, {1, 0, 0}, {10, 20, -300}}, x_joint, y_joint, z_joint}};
}
/// B at the spindle, its line 80 mm above the gauge point.
Chain head_b() { return {{x_joint, y_joint, z_joint, {"B", true, {0, 1, 0}, {0, 0, 80}}}}; }
/// C of the table, B of the head inclined by 45 degrees (nutating head).
Chain table_c_head_b() {
    const double s = std::sqrt(0.5);
    return {{{"C", true, {0, 0, 1}, {100, 50, 0}}, x_joint, y_joint, z_joint, {"B", true, {0, s, s}, {0, 0, 60}}}};
}

void expect_near(Vec3 a, Vec3 b, const std::string& what, double by = 1e-7) {
    EXPECT_NEAR(a.x, b.x, by) << what;
    EXPECT_NEAR(a.y, b.y, by) << what;
    EXPECT_NEAR(a.z, b.z, by) << what;
}

TEST(Kinematics, ThreeAxesMoveTheTipByTheToolsLength) {
    const Chain c{{x_joint, y_joint, z_joint}};
    const std::vector<double> at{5, 6, -70};
    const ToolPose p = pose_of(c, at, 30);
    expect_near(p.tip, {5, 6, -100}, "tip");
    expect_near(p.axis, {0, 0, 1}, "axis");
    const AxisPositions back = positions_for(c, p, 30);
    ASSERT_EQ(back.positions.size(), 1U);
    EXPECT_EQ(back.positions[0].values, at);
    EXPECT_EQ(positions_for(c, {{0, 0, 0}, {0, 1, 1}}, 30).reach, Reach::not_inclined);
}

// By hand. A turns the tool against the workpiece counter-clockwise about +x: its axis (0,0,1) goes to (0,-sin,cos).
TEST(Kinematics, SwivellingTableByHand) {
    const Chain c = table_ac();
    const ToolPose p = pose_of(c, std::vector<double>{0, radians(30), 10, 20, -300 + 100}, 100);
    expect_near(p.axis, {0, -0.5, std::sqrt(0.75)}, "axis");
    expect_near(p.tip, {10, 20, -300}, "the tip stands in the centre and stays there");
    const ToolPose q = pose_of(c, std::vector<double>{radians(90), radians(30), 10, 20, -200}, 100);
    expect_near(q.axis, {0.5, 0, std::sqrt(0.75)}, "turned by C");  // (0,-1) turned a quarter: (1,0)
    // tip 50 mm beside the centre in machine x: the table frame has it at the quarter turn, in y
    const ToolPose r = pose_of(c, std::vector<double>{radians(90), 0, 60, 20, -200}, 100);
    expect_near(r.tip, {10, 70, -300}, "tip");
}

TEST(Kinematics, SwivellingHeadByHand) {
    const Chain c = head_b();
    // B 90: the tool points along +x; gauge point 80 below the line, then 80 beside it in -x of the line
    const ToolPose p = pose_of(c, std::vector<double>{0, 0, 0, radians(90)}, 20);
    expect_near(p.axis, {1, 0, 0}, "axis");
    expect_near(p.tip, {-100, 0, 80}, "tip");
    const AxisPositions back = positions_for(c, p, 20);
    ASSERT_EQ(back.positions.size(), 1U);
    EXPECT_NEAR(back.positions[0].values[3], radians(90), 1e-12);
    EXPECT_EQ(positions_for(c, {{0, 0, 0}, {0, 0.1, 1}}, 20).reach, Reach::not_inclined);
}

TEST(Kinematics, NutatingHeadReachesTheHorizontal) {
    const Chain c = table_c_head_b();
    // half a turn about (0, 1, 1) brings +z to +y
    const ToolPose p = pose_of(c, std::vector<double>{0, 0, 0, 0, geom::pi}, 0);
    expect_near(p.axis, {0, 1, 0}, "axis");
    EXPECT_EQ(positions_for(c, {{0, 0, 0}, {0, 0.5, -0.5}}, 0).reach, Reach::not_inclined);
}

TEST(Kinematics, BothSolutionsOfATable) {
    Chain c = table_ac();
    c.joints[1].min = radians(-115);
    c.joints[1].max = radians(30);
    const ToolPose tilted{{0, 0, 0}, {1, 0, 1}};  // 45 degrees towards +x: A 45 with C 90, A -45 with C -90
    const AxisPositions found = positions_for(c, tilted, 100);
    ASSERT_EQ(found.positions.size(), 2U);
    EXPECT_TRUE(found.positions[0].in_limits());
    EXPECT_NEAR(found.positions[0].values[0], radians(-90), 1e-9);
    EXPECT_NEAR(found.positions[0].values[1], radians(-45), 1e-9);
    EXPECT_EQ(found.positions[1].outside, "A");
    EXPECT_NEAR(found.positions[1].values[0], radians(90), 1e-9);
    EXPECT_NEAR(found.positions[1].values[1], radians(45), 1e-9);
    // C stands near 270 degrees already: the same direction, without a turn
    const std::vector<double> near{radians(260), 0, 0, 0, 0};
    EXPECT_NEAR(positions_for(c, tilted, 100, near).positions.at(0).values[0], radians(270), 1e-9);
}

TEST(Kinematics, WhereTheToolStandsInTheRotaryAxisThatOneStays) {
    const std::vector<double> near{radians(37), 0, 0, 0, 0};
    const AxisPositions found = positions_for(table_ac(), {{1, 2, 3}, {0, 0, 5}}, 100, near);
    ASSERT_EQ(found.positions.size(), 1U);
    EXPECT_TRUE(found.positions[0].singular);
    EXPECT_EQ(found.positions[0].values[0], radians(37));
    EXPECT_NEAR(found.positions[0].values[1], 0, 1e-9);
    expect_near(pose_of(table_ac(), found.positions[0].values, 100).tip, {1, 2, 3}, "tip");
}

TEST(Kinematics, ThereAndBack) {
    std::mt19937 random(7);
    std::uniform_real_distribution<double> angle(-3, 3), place(-400, 400);
    for (const Chain& c :
         {table_ac(), head_b(), table_c_head_b(), Chain{{x_joint, y_joint, z_joint}},
          Chain{{z_joint, {"A", true, {1, 0, 0}, {0, 5, 6}}, y_joint, x_joint, {"B", true, {0, 1, 0}, {1, 2, 90}}}}})
        for (int n = 0; n < 500; ++n) {
            std::vector<double> v;
            for (const Joint& j : c.joints) v.push_back(j.rotary ? angle(random) : place(random));
            const double tool_length = std::abs(place(random));
            const ToolPose pose = pose_of(c, v, tool_length);
            const AxisPositions found = positions_for(c, pose, tool_length, v);
            const std::string what = "seed 7, case " + std::to_string(n);
            ASSERT_EQ(found.reach, Reach::reached) << what;
            for (const AxisPosition& p : found.positions) {
                EXPECT_TRUE(p.in_limits());
                const ToolPose again = pose_of(c, p.values, tool_length);
                expect_near(again.tip, pose.tip, what);
                expect_near(again.axis, pose.axis, what);
            }
            // the one it came from is the first, since nothing has to turn
            for (std::size_t i = 0; i < v.size(); ++i) EXPECT_NEAR(found.positions[0].values[i], v[i], 1e-5) << what;
        }
}

TEST(Kinematics, WhatIsNotKnownIsNotInTheLimits) {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const AxisPositions found = positions_for({{x_joint, y_joint, z_joint}}, {{1, nan, 0}, {0, 0, 1}}, 0);
    ASSERT_EQ(found.positions.size(), 1U);
    EXPECT_FALSE(found.positions[0].in_limits());
    EXPECT_EQ(positions_for(table_ac(), {{0, 0, 0}, {nan, 0, 1}}, 0).reach, Reach::unsuitable);
    EXPECT_EQ(positions_for(table_ac(), {{0, 0, 0}, {0, 0, 0}}, 0).reach, Reach::unsuitable);
    EXPECT_EQ(positions_for({{x_joint, y_joint}}, {}, 0).reach, Reach::unsuitable);
    EXPECT_EQ(positions_for({{x_joint, y_joint, x_joint}}, {}, 0).reach, Reach::unsuitable);
}

// The linear joints as they follow a tip: put back into the chain they must give that tip.
TEST(Kinematics, FollowersBringTheTipThere) {
    std::mt19937 random(7);
    std::uniform_real_distribution<double> any(-300, 300), angle(-3, 3);
    for (const Chain& c : {table_ac(), head_b(), table_c_head_b(), Chain{{x_joint, y_joint, z_joint}}}) {
        for (int n = 0; n < 50; ++n) {
            std::vector<double> values;
            for (const Joint& j : c.joints) values.push_back(j.rotary ? angle(random) : any(random));
            const Vec3 tip{any(random), any(random), any(random)};
            const std::vector<Follower> all = followers(c, values, 55);
            ASSERT_EQ(all.size(), 3U);
            for (const Follower& f : all) values[f.joint] = dot(f.along, tip) + f.at;
            expect_near(pose_of(c, values, 55).tip, tip, "tip of case " + std::to_string(n));
        }
    }
    EXPECT_TRUE(followers(Chain{{x_joint, y_joint}}, {}, 0).empty());
    for (const double v : joints_at(Chain{{x_joint, y_joint}}, {}, true, {1, 2, 3}, 0)) EXPECT_TRUE(std::isnan(v));
    const std::vector<double> swivelled{0.3, 0.4, 9, 9, 9};
    expect_near(pose_of(table_ac(), joints_at(table_ac(), swivelled, true, {1, 2, 3}, 70), 70).tip, {1, 2, 3},
                "counted");
    const std::vector<double> as_at_0 = joints_at(table_ac(), swivelled, false, {1, 2, 3}, 70);
    expect_near({as_at_0[2], as_at_0[3], as_at_0[4]}, {1, 2, 73}, "not counted");
    EXPECT_TRUE(followers(Chain{{x_joint, y_joint, {"W", false, {1, 0, 0}, {}}}}, {}, 0).empty())
        << "two in one direction";
}

}  // namespace
}  // namespace obrys::shop
