#include <gtest/gtest.h>

#include "read/heidenhain/reading.hpp"

/// Line ends, continuation by `~`, bytes that do not belong, what stands around the program.
namespace obrys::read::heidenhain {

using program::Modal;
using testing::complaint;
using testing::modal;
using testing::one;
using testing::Reading;

namespace {

const std::string straight_word = modal(Modal::linear);

std::string with_line_ends(std::string text, const std::string& ends) {
    std::string out;
    for (const char c : text) out += c == '\n' ? ends : std::string(1, c);
    return out;
}

const std::string program_text =
    "0 BEGIN PGM T MM\n1 ; comment\n2 L X+1 Y+2 R0 FMAX\n3 L Z-1 F100 M3 ; comment\n4 CYCL DEF 200 BOHREN ~\n"
    "    Q200=2 ;ABSTAND ~\n    Q201=-20 ;TIEFE ~\n    Q206=150\n5 CYCL CALL\n6 LBL 1\n7 Q1 = Q1 + 1\n"
    "8 FN 12: IF +Q1 LT +5 GOTO LBL 1\n9 END PGM T MM\n";

}  // namespace

TEST(KlartextText, EveryLineEndGivesTheSameTree) {
    const Reading unix_ends(program_text);
    EXPECT_EQ(unix_ends.messages(), "");
    for (const char* ends : {"\r\n", "\r", "\n\n", "\r\r\n", " \n", "\t \r\n"}) {
        const Reading other(with_line_ends(program_text, ends));
        EXPECT_EQ(other.tree(), unix_ends.tree()) << ::testing::PrintToString(ends);
        EXPECT_EQ(other.messages(), "") << ::testing::PrintToString(ends);
    }
}

TEST(KlartextText, ALoneCarriageReturnInALineIsABlank) {
    EXPECT_EQ(Reading("1 L X+1\r Y+2\n2 L X+3\n").tree(),
              "0 " + straight_word + " X1 Y2\n1 " + straight_word + " X3\n");
    EXPECT_EQ(Reading("1 L X+1\rY+2 M3\n").tree(), "0 " + straight_word + " X1 Y2 M3\n");
    EXPECT_EQ(Reading("1 L X+1 Y+2\r\n2 L\rX+3\r\n").tree(),
              "0 " + straight_word + " X1 Y2\n1 " + straight_word + " X3\n");
}

TEST(KlartextText, TildeGoesOnInTheNextLine) {
    EXPECT_EQ(one("1 L X+1 ~\n  Y+2"), straight_word + " X1 Y2");
    EXPECT_EQ(one("1 L X+1 ~ \r\n  Y+2 ~\r\n  Z+3"), straight_word + " X1 Y2 Z3");
    EXPECT_EQ(one("1 L X+1 ; a comment ~\n Y+2"), straight_word + " X1 Y2");
    EXPECT_EQ(Reading("1 ; a comment ~\n goes on X+5\n2 L X+1\n").tree(), "0 " + straight_word + " X1\n");
    EXPECT_EQ(Reading("1 Q1 = Q2 ~\n  + Q3\n2 Q4 = 1\n").tree(), "0 Q1=(Q2 + Q3)\n1 Q4=1\n");
    EXPECT_EQ(Reading("1 L X+1 ~").tree(), "0 " + straight_word + " X1\n");  // nothing follows
    EXPECT_EQ(complaint("1 L X+1 ~ Y+2"), "this is no word of a path block: '~'");
}

TEST(KlartextText, BytesThatDoNotBelong) {
    EXPECT_EQ(Reading("1 L X+1\n\x1A").tree(), "0 " + straight_word + " X1\n");
    EXPECT_EQ(Reading(std::string("1 L X+1\n\0\0", 10)).messages(), "");
    EXPECT_NE(Reading(std::string("1 L X+1\0Y+2\n", 12)).messages(), "");
    EXPECT_EQ(Reading("\xEF\xBB\xBF"
                      "0 BEGIN PGM T MM\n1 L X+1\n2 END PGM T MM\n")
                  .messages(),
              "");
    EXPECT_NE(Reading("1 L \xFF+1\n").messages(), "");
    EXPECT_EQ(Reading("").tree(), "");
    EXPECT_EQ(Reading("\n\r\n \t\n").tree(), "");
}

TEST(KlartextText, WhatStandsInFrontOfTheProgramIsLeftOut) {
    const Reading r("written by a postprocessor\n===\n0 BEGIN PGM T MM\n1 L X+1\n2 END PGM T MM\n");
    EXPECT_EQ(r.codes(), std::vector<std::string>{"no-effect"});
    EXPECT_EQ(r.tree(), "0 " + modal(Modal::metric_all) + "\n1 " + straight_word + " X1\n");
}

TEST(KlartextText, WhatStandsBehindTheProgramIsNotRun) {
    const Reading r("0 BEGIN PGM T MM\n1 L X+1\n2 END PGM T MM\n3 L X+2\nrubbish\n");
    EXPECT_EQ(r.tree(), "0 " + modal(Modal::metric_all) + "\n1 " + straight_word + " X1\n");
    EXPECT_EQ(r.messages(),
              "TEST.H:4:1: warning: the text behind END PGM is no part of the program and is not run [not-run]\n"
              "  3 L X+2\n  ^~~~~~~\n"
              "  remedy: keep it in a file of its own, or take the first END PGM out\n");
}

TEST(KlartextText, AProgramWithoutItsEndIsSaid) {
    const Reading r("0 BEGIN PGM T MM\n1 L X+1\n");
    EXPECT_EQ(r.codes(), std::vector<std::string>{"unclosed"});
    EXPECT_EQ(complaint("1 L X+1\n"), "");  // a piece of a program
}

TEST(KlartextText, LongLinesAreRead) {
    std::string text = "1 L";
    for (int i = 0; i < 20'000; ++i) text += " X+1";
    const Reading r(text + "\n2 L Y+2\n");
    EXPECT_EQ(r.unit.statements.size(), 2u);
    EXPECT_EQ(r.unit.words.size(), 20'003u);
}

TEST(KlartextText, NamesOfPrograms) {
    for (const char* path : {"TNC:\\dir\\Teil.H", "Teil.h", "TNC:/a/teil.h", "teil", "teil.H"})
        EXPECT_EQ(Reading(std::string("CALL PGM ") + path).tree(), "0 call TEIL\n") << path;
    EXPECT_EQ(Reading("CALL PGM ..\\teil.I").tree(), "0 call TEIL.I\n") << "a DIN/ISO program beside TEIL.H";
}

TEST(KlartextText, Likelihood) {
    EXPECT_GT(likelihood("0 BEGIN PGM A MM\n1 L X+1 FMAX\n2 END PGM A MM\n", "A.H"), 70);
    EXPECT_GT(likelihood("0 begin pgm a mm\n1 tool call 1 z s100\n", "a.txt"), 50);
    EXPECT_LT(likelihood("N10 G1 X10\nN20 G01 Y=R5\n", "A.MPF"), 10);
    EXPECT_LT(likelihood("%A G71 *\nN10 G01 X+1 *\n", "A.I"), 30);
}

}  // namespace obrys::read::heidenhain
