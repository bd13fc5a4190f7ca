#include <gtest/gtest.h>

#include "read/rs274/reading.hpp"

namespace obrys::read::rs274 {

using program::Modal;
using testing::m;
using testing::one;

// Each of these rs274 (LinuxCNC 2.9) refuses too.
TEST(Rs274Check, CoordinatesHaveOneUser) {
    EXPECT_EQ(one("G80 X1"), "1:1 coordinates beside G80, which uses none");
    EXPECT_EQ(one("G28 G0 X1"), "1:1 G28 and G0 both use coordinates");
    EXPECT_EQ(one("G92"), "1:1 G92 without a coordinate");
    EXPECT_EQ(one("G81 R1"), "1:1 G81 without a coordinate");
    EXPECT_EQ(one("G33.1 K1"), "1:1 G33.1 without a coordinate");
    EXPECT_EQ(one("G0 X1 ^45"), "1:4 X and a polar coordinate in one block");
}

TEST(Rs274Check, LettersHaveAUser) {
    EXPECT_EQ(one("G0 X1 P2"), "1:7 no code of the block uses P");
    EXPECT_EQ(one("G0 I1"), "1:4 no code of the block uses I");
    EXPECT_EQ(one("D1"), "1:1 no code of the block uses D");
    EXPECT_EQ(one("G10 L2 P1 K1"), "1:11 no code of the block uses K");
    EXPECT_EQ(one("G40 D1"), "1:5 no code of the block uses D");
    EXPECT_EQ(one("M3 S1 Q1"), "1:7 no code of the block uses Q");
}

TEST(Rs274Check, ALetterThatTheModalMotionMayUseIsLeftToTheRun) {
    EXPECT_EQ(one("X1 P2"), "X1 P2");
    EXPECT_EQ(one("I1"), "I1");
    EXPECT_EQ(one("M101 P1 Q2"), "M101 P1 Q2");
}

TEST(Rs274Check, WhatACodeNeeds) {
    EXPECT_EQ(one("G4"), "1:1 G4 does not say how long");
    EXPECT_EQ(one("G10 L3 P1"), "1:1 G10 needs L0, L1, L2, L10, L11 or L20");
    EXPECT_EQ(one("G10 L2 P10 X1"), "1:8 G10 L2 and L20 know P0 to P9");
    EXPECT_EQ(one("G10 L1 P0 X1"), "1:8 there is no tool with this number");
    EXPECT_EQ(one("G33 Z1"), "1:1 the pitch K is missing");
    EXPECT_EQ(one("G33 Z1 K1 F1"), "1:11 the pitch says how fast; F cannot");
    EXPECT_EQ(one("G96"), "1:1 G96 does not say how fast");
    EXPECT_EQ(one("G53 G2 X1 Y1 I1"), "1:1 only G0 and G1 move in machine coordinates");
    EXPECT_EQ(one("G76 X1"), "1:1 G76 needs P, I, J and K");
    EXPECT_EQ(one("F-1"), "1:1 F cannot be negative");
    EXPECT_EQ(one("T-1"), "1:1 T cannot be negative");
}

TEST(Rs274Check, WordsOfOutputsAndOrientedStopsAreKept) {
    EXPECT_EQ(one("M66 P0 L3 Q2"), "M66 P0 L3 Q2");
    EXPECT_EQ(one("M62 P1 G1 X1"), "M62 P1 X1 " + m(Modal::linear));
    EXPECT_EQ(one("M19 R90 Q1"), "M19 CR90 Q1");
    EXPECT_EQ(one("M61 Q5"), "M61 Q5");
    EXPECT_EQ(one("S100 $0 M3"), "S100 M3");
    EXPECT_EQ(one("S100 $1 M3"), "S100 M3 unsupported{$1|a second spindle}");
}

TEST(Rs274Check, SurfaceSpeedHasItsLimit) {
    EXPECT_EQ(one("G96 D2500 S200"), m(Modal::surface_speed_on, 96) + " S200 LIMS2500");
}

TEST(Rs274Check, AMotionThatIsNotRunTakesItsCoordinatesWithIt) {
    EXPECT_EQ(one("G6.3 F100"), "F100 unsupported{G6.3|a word without function}");
    EXPECT_EQ(one("G[#1] X1"), "unsupported{G[#1]|a computed G code}");
    EXPECT_EQ(one("G[1+1] X1 R2"), "X1 CR2 " + m(Modal::arc_cw));
}

}  // namespace obrys::read::rs274
