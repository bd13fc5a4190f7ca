#include "check/open_way.hpp"

#include <gtest/gtest.h>

namespace obrys::check {
namespace {

using geom::Vec3;
using Kind = OpenWay::Kind;
const Vec3 above_stock{NAN, NAN, 0};  // clear of the stock from Z0 on
const Vec3 lathe{20, NAN, 0.5};       // outside of X20, or right of Z0.5

TEST(OpenWay, DownFromAHeightNobodyKnowsComesFromAbove) {
    const OpenWay w = open_way({50, 50, NAN}, {50, 50, -5}, above_stock);
    ASSERT_EQ(w.kind, Kind::swept);
    EXPECT_EQ(w.to, (Vec3{50, 50, -5}));
    EXPECT_GT(w.from.z, 0);
    EXPECT_EQ(w.from.x, 50);
}

TEST(OpenWay, UpToAHeightNobodyKnowsGoesAbove) {
    const OpenWay w = open_way({50, 50, -5}, {50, 50, NAN}, above_stock);
    ASSERT_EQ(w.kind, Kind::swept);
    EXPECT_EQ(w.from, (Vec3{50, 50, -5}));
    EXPECT_GT(w.to.z, 0);
}

TEST(OpenWay, EndIsJudgedWhereTheWayIsNotKnown) {
    EXPECT_EQ(open_way({NAN, NAN, -5}, {50, 50, -5}, above_stock).kind, Kind::end);
    EXPECT_EQ(open_way({NAN, NAN, NAN}, {50, 50, -5}, above_stock).kind, Kind::end);
    EXPECT_EQ(open_way({0, 50, NAN}, {50, 50, -5}, above_stock).kind, Kind::end);
    EXPECT_EQ(open_way({NAN, 0, NAN}, {15, 0, -20}, lathe).kind, Kind::end);
    EXPECT_EQ(open_way({NAN, NAN, -5}, {NAN, 50, -5}, above_stock).kind, Kind::lost);
}

TEST(OpenWay, BesideIsProvedClearIsTakenForGranted) {
    EXPECT_EQ(open_way({NAN, NAN, 2}, {50, 50, 2}, above_stock).kind, Kind::beside);
    EXPECT_EQ(open_way({NAN, NAN, NAN}, {50, 50, NAN}, above_stock).kind, Kind::clear);
    EXPECT_EQ(open_way({30, 0, -5}, {NAN, 0, NAN}, lathe).kind, Kind::clear);
    EXPECT_EQ(open_way({10, 0, -5}, {NAN, 0, NAN}, lathe).kind, Kind::lost);
}

TEST(OpenWay, TurningComesFromOutsideOrFromTheRight) {
    EXPECT_EQ(open_way({15, 0, NAN}, {15, 0, -20}, lathe).kind, Kind::swept);
    EXPECT_EQ(open_way({NAN, 0, -20}, {15, 0, -20}, lathe).kind, Kind::swept);
    // From beyond the axis there is no such side.
    EXPECT_EQ(open_way({NAN, 0, -20}, {-5, 0, -20}, {NAN, NAN, 0.5}).kind, Kind::end);
}

TEST(Whereabouts, WhatBecomesOfMoves) {
    Whereabouts w;
    OpenMove m = w.open({NAN, NAN, NAN}, {50, 50, NAN}, true, above_stock);
    EXPECT_TRUE(m.start && !m.assumed && !m.left_out);
    m = w.open({50, 50, NAN}, {50, 50, -5}, true, above_stock);
    EXPECT_TRUE(!m.start && !m.assumed && !m.left_out);
    m = w.open({50, 50, -5}, {50, 50, NAN}, true, above_stock);  // home
    EXPECT_TRUE(m.assumed && !m.start && !m.left_out);
    m = w.open({50, 50, NAN}, {0, 0, NAN}, false, above_stock);  // feed at a height nobody knows
    EXPECT_TRUE(m.left_out);
    EXPECT_EQ(m.way.kind, Kind::lost);
}

TEST(Whereabouts, OutOfThePocketByAnUnknownWayIsLeftOut) {
    Whereabouts w;
    w.known({50, 50, -5});
    EXPECT_TRUE(w.open({50, 50, -5}, {NAN, NAN, NAN}, true, above_stock).left_out);
    EXPECT_TRUE(w.open({NAN, NAN, NAN}, {50, 50, NAN}, true, above_stock).left_out);
    const OpenMove m = w.open({50, 50, NAN}, {50, 50, -5}, true, above_stock);
    EXPECT_TRUE(m.left_out);
    EXPECT_EQ(m.way.kind, Kind::swept);
    EXPECT_FALSE(w.open({NAN, 50, 5}, {50, 50, 5}, true, above_stock).left_out);
}

}  // namespace
}  // namespace obrys::check
