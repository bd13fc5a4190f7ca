#include <gtest/gtest.h>

#include "read/rs274/reading.hpp"

namespace obrys::read::rs274 {

using program::Modal;
using testing::m;
using testing::one;
using testing::Reading;

TEST(Rs274Block, WordsComeInTheOrderOfExecution) {
    EXPECT_EQ(one("G1 X1 Y2.5 F100"), "F100 X1 Y2.5 " + m(Modal::linear));
    EXPECT_EQ(one("G1 X#1 F100 Y2.5"), "F100 X=#1 Y2.5 " + m(Modal::linear));
    EXPECT_EQ(one("X1 G43 H1 G0 G54 M6 T1"),
              "T1 M6 X1 H-offset1 act " + m(Modal::tool_length) + " " + m(Modal::datum, 54) + " " + m(Modal::rapid));
    EXPECT_EQ(one("G91 G20 G18 F100 G1 X1"), "F100 X1 act " + m(Modal::plane_zx) + " " + m(Modal::inch_all) + " " +
                                                 m(Modal::incremental) + " " + m(Modal::linear));
    EXPECT_EQ(one("M2 M5 M9 G0 X1"), "M5 M9 M2 X1 " + m(Modal::rapid));
}

TEST(Rs274Block, BlanksAndCaseMeanNothing) {
    EXPECT_EQ(one("g 0 x 1 2 . 5 y - 3"), "X12.5 Y-3 " + m(Modal::rapid));
    EXPECT_EQ(one("n 1 0 g0x1"), "X1 " + m(Modal::rapid));
    EXPECT_EQ(one("/ G0 X1 Z#2"), "/0 X1 Z=#2 " + m(Modal::rapid));
}

TEST(Rs274Block, ADwellInFrontOfAMotionIsItsOwnStatement) {
    EXPECT_EQ(one("G4 P1.5 F100 G0 X1"), "0 F100 P1.5 " + m(Modal::dwell) + "\n1 +X1 " + m(Modal::rapid) + "\n");
    EXPECT_EQ(one("G4 P1.5"), "P1.5 " + m(Modal::dwell));
}

TEST(Rs274Block, AssignmentsStandBehindAllValues) {
    EXPECT_EQ(one("#1=2 G0 X#1 #2=#1"), "X=#1 #1=2 #2=#1 " + m(Modal::rapid));
}

TEST(Rs274Block, G80BesideAnotherMotionWordHasNoEffect) {
    EXPECT_EQ(one("G0 G80 X1"), one("G0 X1"));
    EXPECT_EQ(one("G80 G0 X1"), one("G0 X1"));
    EXPECT_EQ(one("G80"), one("G80 G80"));
    EXPECT_NE(one("G80"), one(""));
    EXPECT_EQ(one("G80 G0 G1 X1"), "1:8 two G codes of one group in the block: G1");
}

TEST(Rs274Block, ErrorsMarkTheWord) {
    EXPECT_EQ(one("G0 X1 X2"), "1:7 two X words in one block");
    EXPECT_EQ(one("G0 X[1"), "1:5 this bracket is not closed");
    EXPECT_EQ(one("G0 G1 X1"), "1:4 two G codes of one group in the block: G1");
    EXPECT_EQ(one("G6"), "1:1 LinuxCNC has no G code G6");
    EXPECT_EQ(one("(a (b))"), "1:4 a comment stands within a comment");
    EXPECT_EQ(one("(a"), "1:1 this comment is not closed");
    EXPECT_EQ(one("#0=1"), "1:1 there is no parameter #0");
    EXPECT_EQ(one("#5420=1"), "1:1 the parameter #5420 can only be read");
    EXPECT_EQ(one("#<_x>=1"), "1:1 a program cannot assign to the control's parameter #<_x>");
    EXPECT_EQ(one("G0 X1.2.3"), "1:8 the number has two points");
    EXPECT_EQ(one("G0 X1 N5"), "1:7 'N' cannot stand here");
}

}  // namespace obrys::read::rs274
