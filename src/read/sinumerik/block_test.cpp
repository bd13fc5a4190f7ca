#include <gtest/gtest.h>

#include "read/sinumerik/reading.hpp"

namespace obrys::read::sinumerik {

using testing::one;
using testing::Reading;

namespace {

std::string modal(program::Modal m, int number = 0) {
    return "m" + std::to_string(static_cast<int>(m)) + (number != 0 ? "." + std::to_string(number) : "");
}

}  // namespace

TEST(SinumerikBlock, WordsWithoutAndWithSign) {
    EXPECT_EQ(one("X10 Y-.5 Z+12.250 F.2"), "X10 Y-0.5 Z12.25 F0.2");
    EXPECT_EQ(one("X=R1+5 CR=5 F=-2"), "X=(R1 + 5) CR5 F-2");
    EXPECT_EQ(one("X 10 Y = 20"), "X10 Y20");
    EXPECT_EQ(one("x10 g1"), "X10 " + modal(program::Modal::linear, 1));
    EXPECT_EQ(one("X1.123456789 Y12345678901 Z0.0000000001"), "X1.123456789 Y12345678901 Z1e-10");
    EXPECT_EQ(one("Z30.4EX-4 A2"), "Z0.00304 A2");
}

TEST(SinumerikBlock, CompactBlocks) {
    EXPECT_EQ(one("N10G0G54X-10Y.20Z30.4M3"),
              modal(program::Modal::rapid) + " " + modal(program::Modal::datum, 54) + " X-10 Y0.2 Z30.4 M3");
    EXPECT_EQ(one("N10 G3 G505_VAR=10"),
              modal(program::Modal::arc_ccw, 3) + " " + modal(program::Modal::datum, 505) + " _VAR=10");
    EXPECT_EQ(one("X=R1Y=R2"), "X=R1 Y=R2");
}

TEST(SinumerikBlock, PositionsWithTheirOwnReference) {
    EXPECT_EQ(one("X=IC(-5) Z=AC(10) C=DC(90)"), "X=q1(-5) Z=q0(10) C=q2(90)");
    EXPECT_EQ(one("C=ACP(R1) B=ACN(2)"), "C=q3(R1) B=q4(2)");
}

TEST(SinumerikBlock, ExtendedAddresses) {
    EXPECT_EQ(one("S2=500 M2=3 X1=5"), "value S[2]=500 value M[2]=3 axis X1=5");
    EXPECT_EQ(one("AX[AXIS_EW]=R1 F[X]=2 FA[Z]=30"), "axis AX[AXIS_EW]=R1 value F[X]=2 value FA[Z]=30");
    EXPECT_EQ(one("CIP X1 I1=2 J1=3"), modal(program::Modal::arc_via) + " X1 I12 J13");
    EXPECT_EQ(one("SPOS=90 SPOS[2]=45"), "SPOS90 value SPOS[2]=45");
}

TEST(SinumerikBlock, Assignments) {
    EXPECT_EQ(one("R1=5 R2=R1 R[3]=7 $R[4]=1"), "R1=5 R2=R1 R[3]=7 $R#1[4]=1");
    EXPECT_EQ(one("N30 _X=0 _Z=-10 ARR[1,2]=3"), "_X=0 _Z=-10 ARR[1,2]=3");
}

TEST(SinumerikBlock, ToolAndTechnology) {
    EXPECT_EQ(one("T=5 D1"), "T5 D1");
    EXPECT_EQ(one("T=\"DRILL 8.5\" M6"), "T=\"DRILL 8.5\" M6");
    EXPECT_EQ(one("G96 S300 LIMS=3000 M3 M=QU(8)"),
              modal(program::Modal::surface_speed_on, 96) + " S300 LIMS3000 M3 M8");
    EXPECT_EQ(one("G=2 X1"), modal(program::Modal::arc_cw, 2) + " X1");
}

TEST(SinumerikBlock, NumbersSkipSignsAndComments) {
    EXPECT_EQ(one("/N10 X1 ; Y2"), "/0 X1");
    EXPECT_EQ(one("/3 N10 X1"), "/3 X1");
    EXPECT_EQ(one(":100 X1"), "X1");
    EXPECT_EQ(one("MSG(\"a;b\") ; c"), "procedure 0(\"a;b\")");
    const Reading r("\n ; only a comment\nN10\n\tX1\n");
    EXPECT_EQ(r.tree(), "0 \n1 X1\n");
}

TEST(SinumerikBlock, LineEndsAndStrayBytes) {
    EXPECT_EQ(Reading("X1\r\nX2\rX3\nX4\x1A").tree(), "0 X1\n1 X2\n2 X3\n3 X4\n");
    EXPECT_EQ(Reading("\xEF\xBB\xBFX1\n").tree(), "0 X1\n");
    EXPECT_EQ(Reading("").tree(), "");
    EXPECT_EQ(Reading("%\n%MPF100\nX1\n").tree(), "0 X1\n");
    EXPECT_EQ(Reading("X1 ; \xE1\xE9 CP1252\nMSG(\"\xB0\")").tree(), "0 X1\n1 procedure 0(\"\xC2\xB0\")\n");
}

TEST(SinumerikBlock, SpansCoverTheWords) {
    const Reading r("N10 G1 X-1.5 Y=R1 + 2  F.2 ; c\n  N20 X 7\n");
    EXPECT_EQ(r.text_of(0, 1), "X-1.5");
    EXPECT_EQ(r.text_of(0, 2), "Y=R1 + 2");
    EXPECT_EQ(r.text_of(0, 3), "F.2");
    EXPECT_EQ(r.sources.text(r.unit().span(r.unit().statements[0])), "N10 G1 X-1.5 Y=R1 + 2  F.2");
    EXPECT_EQ(r.sources.text(r.unit().span(r.unit().statements[1])), "N20 X 7");
}

TEST(SinumerikBlock, IgnoredWordsAreCountedOnce) {
    const Reading r("G64 SOFT FNORM X1\nSOFT\nSTOPRE\nOTOL=0.01 FGROUP(X,Y)\n");
    EXPECT_EQ(r.tree(), "0 " + modal(program::Modal::continuous, 64) + " X1\n1 \n2 \n3 \n");
    ASSERT_EQ(r.unit().ignored.size(), 5u);
    EXPECT_EQ(r.unit().ignored[0].text, "SOFT");
    EXPECT_EQ(r.unit().ignored[0].count, 2u);
    EXPECT_EQ(r.unit().ignored[4].text, "FGROUP");
    EXPECT_TRUE(r.unit().words.size() == 2);
}

TEST(SinumerikBlock, UnsupportedWordsKeepTheRestOfTheBlock) {
    EXPECT_EQ(one("MEAS=2 G91 G1 Z=5"), "unsupported{MEAS=2|measuring} " + modal(program::Modal::incremental, 91) +
                                            " " + modal(program::Modal::linear, 1) + " Z5");
    EXPECT_EQ(one("POS[X]=R1+1 X2"), "value POS[X]=(R1 + 1) X2");
    EXPECT_EQ(one("CYCLE93(1,2,,\"a)\")"), "cycle call CYCLE93(1,2,_,\"a)\")");
    EXPECT_EQ(one("A3=1 C3=R1 A4"), "unsupported{A3=1|tool orientation} unsupported{C3=R1|tool orientation} A4");
    // What follows belongs to these words: it must not be taken for a motion.
    EXPECT_EQ(one("G25 X10 Z20"), "unsupported{G25 X10 Z20|working area or spindle limits set by the program}");
    EXPECT_EQ(one("ID=1 WHENEVER $A_IN[1] DO X10 ; c"),
              "unsupported{ID=1 WHENEVER $A_IN[1] DO X10|synchronized action}");
}

TEST(SinumerikBlock, UnknownWords) {
    EXPECT_EQ(one("G1 X1 QQQ"), modal(program::Modal::linear, 1) + " X1 unknown{QQQ|}");
    EXPECT_EQ(one("G999 X1"), "unknown{G999|no such G function} X1");
    EXPECT_EQ(one("P5 X1"), "unknown{P5|} X1");
    EXPECT_EQ(one("X1 N20"), "X1 unknown{N20|a block number stands only at the begin of a block}");
}

TEST(SinumerikBlock, NamesLikeWordsAreFoundWhereDefined) {
    const Reading r("DEF REAL D1W,F1\nD1W=5 X=D1W+F1\nF1=2\nD1 F1\n");
    EXPECT_EQ(r.tree(), "0 define 3 D1W F1\n1 D1W=5 X=(D1W + F1)\n2 F1=2\n3 D1 F1\n");
}

TEST(SinumerikBlock, ALongLineTakesLinearTime) {
    std::string line = "X1";
    while (line.size() < 100'000) line += " Y2";
    const Reading r(line + "\nX=3\n");
    EXPECT_EQ(r.unit().statements.size(), 2u);
    std::string open(100'000, '(');
    EXPECT_EQ(Reading("R1=" + open).codes(), std::vector<std::string>{"syntax"});
}

}  // namespace obrys::read::sinumerik
