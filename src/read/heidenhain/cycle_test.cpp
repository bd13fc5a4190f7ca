#include <gtest/gtest.h>

#include "read/heidenhain/reading.hpp"

namespace obrys::read::heidenhain {

using testing::complaint;
using testing::Reading;

namespace {

/// What the cycles of a text say, names left out: two spellings of one cycle agree in it.
std::string cycles(const std::string& text) {
    const Reading r(text);
    return r.messages() + r.tree();
}

}  // namespace

TEST(KlartextCycle, TheNameIsInAnyLanguage) {
    const std::string english = cycles("1 CYCL DEF 200 DRILLING ~\n Q200=2 ;SET-UP CLEARANCE ~\n Q201=-20 ;DEPTH\n");
    EXPECT_EQ(cycles("1 CYCL DEF 200 BOHREN ~\n Q200=2 ;SICHERHEITS-ABST. ~\n Q201=-20 ;TIEFE\n"), english);
    EXPECT_EQ(cycles("1 CYCL DEF 200 VRTANI ~\n Q200=2 ;BEZPECNOSTNI VZDAL. ~\n Q201=-20 ;HLOUBKA\n"), english);
    EXPECT_EQ(cycles("1 CYCL DEF 200 PER\xC7"
                     "AGE ~\r\n Q200=+2 ~\r\n Q201=-20\r\n"),
              english);
    EXPECT_EQ(cycles("1 CYCL DEF 200 Q200=2 Q201=-20\n"), english);
    EXPECT_EQ(Reading("1 CYCL DEF 200 BOHREN ~\n Q200=2 ~\n Q201=-20\n").unit.statements.size(), 1u);
}

TEST(KlartextCycle, LinesOfTheOldFormBelongTogether) {
    const std::string english = cycles(
        "1 CYCL DEF 1.0 PECKING\n2 CYCL DEF 1.1 SET UP 2\n3 CYCL DEF 1.2 DEPTH -20\n4 CYCL DEF 1.3 PECKG 5\n"
        "5 CYCL DEF 1.4 DWELL 0\n6 CYCL DEF 1.5 F100\n");
    const std::string german = cycles(
        "1 CYCL DEF 1.0 TIEFBOHREN\n2 CYCL DEF 1.1 ABST 2\n3 CYCL DEF 1.2 TIEFE -20\n4 CYCL DEF 1.3 ZUSTLG 5\n"
        "5 CYCL DEF 1.4 V.ZEIT 0\n6 CYCL DEF 1.5 F100\n");
    EXPECT_EQ(german, english);
    EXPECT_EQ(cycles("1 CYCL DEF 1.0 HLUBOKE VRTANI\n2 CYCL DEF 1.1 VZDAL. +2\n3 CYCL DEF 1.2 HLOUBKA -20\n"
                     "4 CYCL DEF 1.3 PRISUV 5\n5 CYCL DEF 1.4 C.PRODLEVA 0\n6 CYCL DEF 1.5 F100\n"),
              english);
    EXPECT_EQ(cycles("1 CYCLE DEF 1.0 PECKING\n2 CYCLE DEF 1.1 DIST2\n3 CYCLE DEF 1.2 DEPTH-20\n"
                     "4 CYCLE DEF 1.3 PLNGNG5\n5 CYCLE DEF 1.4 DWELL0\n6 CYCLE DEF 1.5 F100\n"),
              english);
    EXPECT_EQ(Reading("1 CYCL DEF 1.0 X\n2 CYCL DEF 1.1 DIST 2\n").unit.cycles.size(), 1u);
}

TEST(KlartextCycle, ALineOfTheOldFormThatIsMissingIsNamed) {
    for (const int n : {7, 8, 9, 10, 11, 12, 13, 14, 19, 26, 32}) {
        const std::string cycle = "CYCL DEF " + std::to_string(n), first = std::to_string(n) + ".1";
        for (const std::string behind :
             {"2 L X+1\n", "2 L X+1 M3\n", "2 CYCL DEF 200\n", "2 CYCL CALL\n", "2 LBL 1\n", ""})
            EXPECT_EQ(complaint("1 " + cycle + ".0 NAME\n" + behind), cycle + ".0 stands without its " + first)
                << behind;
    }
    EXPECT_EQ(
        complaint("1 CYCL DEF 1.0 X\n2 CYCL DEF 1.1 DIST 2\n3 CYCL DEF 1.3 PECKG 5\n4 CYCL DEF 1.4 DWELL 0\n5 L X+1\n"),
        "CYCL DEF 1.0 stands without its 1.2, 1.5");
    EXPECT_EQ(complaint("1 CYCL DEF 7.0 X\n2 CYCL DEF 7.1 X+1\n3 CYCL DEF 7.3 Z+2\n4 L X+1\n"),
              "CYCL DEF 7.0 stands without its 7.2");
    // Empty lines reset what they are for, comments may stand between, and lines behind the first are for some
    // machines.
    EXPECT_EQ(
        Reading("1 CYCL DEF 8.0 X\n; why\n2 CYCL DEF 8.1\n3 CYCL DEF 32.0 T\n4 CYCL DEF 32.1\n5 L X+1\n").messages(),
        "");
    EXPECT_EQ(Reading("1 CYCL DEF 7.0 X\n2 CYCL DEF 7.1 X+1\n3 CYCL DEF 7.2 Y+2\n4 L X+1\n").messages(), "");
    EXPECT_EQ(Reading("1 CYCL DEF 20.0 X ~\n Q1=-2 ~\n Q2=1\n4 L X+1\n").messages(), "");
}

TEST(KlartextCycle, ContoursByTheirLabels) {
    const Reading r("1 CYCL DEF 14.0 KONTUR\n2 CYCL DEF 14.1 KONTURLABEL 1 /2 / 15\n");
    EXPECT_EQ(r.messages(), "");
    ASSERT_EQ(r.unit.cycles.size(), 1u);
    ASSERT_EQ(r.unit.cycles[0].texts.size(), 3u);
    EXPECT_EQ(Reading("1 CYCL DEF 14.0 OBRY\x8A\n2 CYCL DEF 14.1 LBL OBRY\x8AU 1\n").tree(),
              Reading("1 CYCL DEF 14.0 CONTOUR\n2 CYCL DEF 14.1 CONTOUR LABEL 1\n").tree());
}

TEST(KlartextCycle, ABlockBetweenEndsTheCycle) {
    for (const std::string between : {"2 L X+1\n", "2 L X+1 M3\n"}) {
        const std::string said = Reading("1 CYCL DEF 9.0 DWELL\n" + between + "3 CYCL DEF 9.1 DWELL 1\n").messages();
        EXPECT_NE(said.find("CYCL DEF 9.1 stands without its 9.0"), std::string::npos) << said;
        EXPECT_NE(said.find("CYCL DEF 9.0 stands without its 9.1"), std::string::npos) << said;
    }
    EXPECT_EQ(complaint("1 CYCL DEF 9.0 DWELL\n2 ; comment\n3 CYCL DEF 9.1 DWELL 1\n"), "");
}

TEST(KlartextCycle, LinesWithoutNumberGoOnWithANumberedCycle) {
    EXPECT_EQ(cycles("0 BEGIN PGM T MM\n1 CYCL DEF 200 BOHREN\n Q200=2\n Q201=-20\n2 END PGM T MM\n"),
              cycles("0 BEGIN PGM T MM\n1 CYCL DEF 200 BOHREN ~\n Q200=2 ~\n Q201=-20\n2 END PGM T MM\n"));
}

TEST(KlartextCycle, Mistakes) {
    EXPECT_TRUE(Reading("CYCL DEF 14.0 X\nCYCL DEF 14.1 L \"A\n").unit.cycles[0].texts.empty());
    EXPECT_TRUE(Reading("CYCL DEF 999 X ~\n Q200=2\n").unit.problems.empty());
    EXPECT_EQ(complaint("CYCL DEF X"), "the number of a cycle is due behind CYCL DEF, found 'X'");
    EXPECT_EQ(complaint("CYCL DEF 200 BOHREN ~\n Q200=ABC"), "a number or a Q parameter is missing here, found 'ABC'");
    EXPECT_EQ(complaint("CYCL DEF 200 BOHREN ~\n Q200=2 ~\n Q201 -20"), "'=' is due behind Q201");
    EXPECT_EQ(complaint("CYCL DEF 200 BOHREN ~\n Q200=2*Q5"), "this is no parameter of a cycle: '*Q5'");
    const Reading unknown("CYCL DEF 999 X ~\n Q200=2\n");
    ASSERT_EQ(unknown.unit.cycles.size(), 1u);
    EXPECT_EQ(unknown.unit.cycles[0].use, program::CycleUse::refused);
    const Reading foreign("CYCL DEF 200 BOHREN ~\n Q218=5\n");
    EXPECT_EQ(foreign.unit.problems.size(), 1u);
}

}  // namespace obrys::read::heidenhain
