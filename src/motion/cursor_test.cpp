/// The fold over the stream: moves with both ends and what they are made with.

#include "motion/cursor.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace obrys::motion {

namespace {

cl::Record rec(cl::Step step) { return {std::move(step), {}, 0}; }

shop::Tool tool(std::uint32_t number, std::uint32_t edge, const char* name) {
    shop::Tool t;
    t.number = number;
    t.edge = edge;
    t.name = name;
    return t;
}

cl::ToolChange change(std::uint32_t number, std::uint32_t edge, const char* name = "") {
    cl::ToolChange c;
    c.number = number;
    c.edge = edge;
    c.name = name;
    return c;
}

}  // namespace

TEST(Cursor, MovesComeWithBothEndsAndTheirNumber) {
    Cursor cursor;
    EXPECT_FALSE(cursor.take(rec(cl::Feed{100})));
    const cl::Record first = rec(cl::Linear{{1, 2, 3}, {0, 0, 1}, true}), second = rec(cl::Linear{{4, 2, 3}});
    const auto a = cursor.take(first);
    ASSERT_TRUE(a);
    EXPECT_TRUE(std::isnan(a->from.x));
    EXPECT_EQ(a->to, (geom::Vec3{1, 2, 3}));
    EXPECT_EQ(a->index, 0U);
    EXPECT_TRUE(a->rapid);
    const auto b = cursor.take(second);
    ASSERT_TRUE(b);
    EXPECT_EQ(b->from, (geom::Vec3{1, 2, 3}));
    EXPECT_EQ(b->index, 1U);
    EXPECT_FALSE(b->rapid);
    EXPECT_EQ(b->state.feed.value, 100);
    EXPECT_EQ(cursor.moves(), 2U);
}

/// A user of steps follows five axes without keeping anything: both ends say how the tool stands, and where each axis.
TEST(Cursor, MovesHaveTheToolAxisAndAdditionalAxesAtBothEnds) {
    const cl::AxisEnd b{{'B'}, 30, true, false}, c{{'C'}, 90, true, true}, b_back{{'B'}, -10, true, false};
    const geom::Vec3 tilted{0.6, 0, 0.8};
    cl::Linear turns{{1, 2, 3}, tilted};
    turns.ends = {b};
    cl::Arc goes_on;
    goes_on.to = {4, 2, 3};
    goes_on.axis = {0, 0.6, 0.8};
    goes_on.ends = {c};
    cl::Thread back;
    back.to = {4, 2, 9};
    back.ends = {b_back};
    cl::Spline last;
    last.to = {5, 5, 5};
    last.axes = {{{'C'}, 120, 0, 0, 0, true}};
    Cursor cursor;
    const cl::Record r0 = rec(cl::Linear{{0, 0, 0}}), r1 = rec(turns), r2 = rec(goes_on), r3 = rec(back),
                     r4 = rec(last);
    const auto start = cursor.take(r0);
    EXPECT_TRUE(std::isnan(start->axis_from.z) && start->axes_from.empty() && start->axes_to.empty());
    EXPECT_EQ(start->axis_to, (geom::Vec3{0, 0, 1}));
    const auto first = cursor.take(r1);
    EXPECT_EQ(first->axis_from, (geom::Vec3{0, 0, 1}));
    EXPECT_EQ(first->axis_to, tilted);
    EXPECT_TRUE(first->axes_from.empty());
    EXPECT_EQ(first->axes_to, cl::AxisEnds{b});
    const auto second = cursor.take(r2);
    EXPECT_EQ(second->axis_from, tilted);
    EXPECT_EQ(second->axes_from, cl::AxisEnds{b});
    EXPECT_EQ(second->axes_to, (cl::AxisEnds{b, c}));
    const auto third = cursor.take(r3);
    EXPECT_EQ(third->axis_from, goes_on.axis);
    EXPECT_EQ(third->axes_from, (cl::AxisEnds{b, c}));
    EXPECT_EQ(third->axes_to, (cl::AxisEnds{b_back, c}));
    const auto fourth = cursor.take(r4);
    EXPECT_EQ(fourth->axes_from, (cl::AxisEnds{b_back, c}));
    EXPECT_EQ(find_axis(fourth->axes_to, {'C'})->to, 120);
    EXPECT_EQ(find_axis(fourth->axes_to, {'A'}), nullptr);
}

TEST(Cursor, WhatHoldsIsTheLastOfItsKind) {
    Cursor cursor;
    for (const cl::Step& s : std::vector<cl::Step>{cl::Feed{100}, cl::Feed{0.2, cl::FeedMode::per_rev},
                                                   cl::Spindle{900, cl::SpindleMode::rpm, 1, 0},
                                                   cl::Coolant{true, true}, cl::Tolerance{0.02}})
        cursor.take(rec(s));
    const State& s = cursor.state();
    EXPECT_EQ(s.feed, (cl::Feed{0.2, cl::FeedMode::per_rev}));
    EXPECT_EQ(s.spindle.speed, 900);
    EXPECT_EQ(s.coolant, (cl::Coolant{true, true}));
    EXPECT_EQ(s.tolerance.contour, 0.02);
}

TEST(Cursor, BracketsAreCounted) {
    Cursor cursor;
    cursor.take(rec(cl::CycleBegin{}));
    cursor.take(rec(cl::CycleBegin{}));
    EXPECT_EQ(cursor.state().cycles, 2U);
    for (int i = 0; i < 3; ++i) cursor.take(rec(cl::CycleEnd{}));
    EXPECT_EQ(cursor.state().cycles, 0U) << "one too many ends nothing";
}

TEST(Cursor, AnotherZeroMovesNothingButTheNumbers) {
    Cursor cursor;
    cursor.take(rec(cl::Datum{54, {100, 0, 0}}));
    cursor.take(rec(cl::Linear{{10, 0, 0}}));
    cursor.take(rec(cl::Datum{55, {130, 0, 0}}));
    const cl::Record to = rec(cl::Linear{{5, 0, 0}});
    const auto step = cursor.take(to);
    ASSERT_TRUE(step);
    EXPECT_EQ(step->from.x, -20) << "the tool has not moved";
    EXPECT_EQ(step->to_stock.x, 30) << "the stock stays in the first zero's frame";
    EXPECT_EQ(step->state.datum.number, 55U);
}

TEST(FindTool, ByNumberThenByNameAndEdge) {
    const std::vector<shop::Tool> tools{tool(1, 1, "MILL"), tool(1, 2, "MILL"), tool(0, 1, "DRILL")};
    EXPECT_EQ(find_tool(tools, change(1, 2)), &tools[1]);
    EXPECT_EQ(find_tool(tools, change(1, 0)), &tools[0]) << "no edge is said";
    EXPECT_EQ(find_tool(tools, change(1, 3)), nullptr);
    EXPECT_EQ(find_tool(tools, change(0, 0, "DRILL")), &tools[2]);
    EXPECT_EQ(find_tool(tools, change(7, 1, "MILL")), nullptr) << "the number counts";
    EXPECT_EQ(find_tool(tools, change(0, 0)), nullptr) << "none";
}

}  // namespace obrys::motion
