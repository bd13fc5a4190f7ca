#include <gtest/gtest.h>

#include "read/rs274/reading.hpp"

namespace obrys::read::rs274 {

using testing::Reading;

namespace {

std::string tree(const std::string& text, std::size_t unit = 0) {
    const Reading r(text + "M2\n");
    return r.messages() + r.tree(unit);
}
std::string complaint(const std::string& text) { return Reading(text).first_message(); }
std::vector<std::string> names(const Reading& r) {
    std::vector<std::string> out;
    for (const auto& u : r.units) out.push_back(u.name);
    return out;
}

}  // namespace

TEST(Rs274Flow, ElseifIsAnIfWithinTheElse) {
    EXPECT_EQ(tree("o1 if [#1 EQ 1]\nX1\no1 elseif [#1 EQ 2]\nX2\no1 else\nX3\no1 endif\n"),
              "0 if (#1 == 1) ->3\n"
              "1 X1\n"
              "2 else ->8\n"
              "3 +if (#1 == 2) ->6\n"
              "4 X2\n"
              "5 else ->7\n"
              "6 X3\n"
              "7 endif\n"
              "8 +endif\n"
              "9 M2\n");
    EXPECT_EQ(tree("o1 if [#1]\nX1\no1 endif\n"), "0 if #1 ->3\n1 X1\n2 endif\n3 M2\n");
}

TEST(Rs274Flow, BreakAndContinueAreJumps) {
    const Reading r("o1 while [#1 LT 3]\no2 if [#1]\no1 continue\no2 endif\no1 break\no1 endwhile\nM2\n");
    EXPECT_EQ(r.messages(), "");
    EXPECT_EQ(r.tree(),
              "0 while (#1 < 3) ->6\n1 if #1 ->4\n2 jump either _\n3 endif\n4 jump either _\n5 endwhile ->0\n6 M2\n");
    ASSERT_EQ(r.unit().jumps.size(), 2U);
    EXPECT_EQ(r.unit().jumps[0].target, 5U);
    EXPECT_EQ(r.unit().jumps[1].target, 6U);
}

TEST(Rs274Flow, DoAndRepeat) {
    const Reading r("o1 do\no1 continue\no1 break\no1 while [#1 GT 0]\nM2\n");
    EXPECT_EQ(r.tree(), "0 repeat\n1 jump either _\n2 jump either _\n3 until (not (#1 > 0)) ->0\n4 M2\n");
    EXPECT_EQ(r.unit().jumps[0].target, 3U);
    EXPECT_EQ(r.unit().jumps[1].target, 4U);
    EXPECT_EQ(tree("o<a> repeat [5]\nX1\no<a> endrepeat\n"),
              "0 repeat-count 5 ->3\n1 X1\n2 end-repeat-count ->0\n3 M2\n");
}

TEST(Rs274Flow, SubprogramsAreUnitsOfTheirOwn) {
    const Reading r("o<Do It> sub\nX#1\no<doit> endsub [#1+1]\nX1\no<DO IT> call [2] [#<_mine>]\nM2\n");
    EXPECT_EQ(r.messages(), "");
    EXPECT_EQ(names(r), (std::vector<std::string>{"TEST", "O<DOIT>"}));
    EXPECT_EQ(r.tree(0), "0 X1\n1 call O<DOIT>(2,_MINE)\n2 M2\n");
    EXPECT_EQ(r.tree(1), "0 X=#1\n1 _VALUE=(#1 + 1) _VALUE_RETURNED=1\n2 +return\n");
}

TEST(Rs274Flow, ReturnSaysThatNothingIsReturned) {
    const Reading r("o100 sub\no100 return\no100 endsub\nM2\n");
    EXPECT_EQ(r.tree(1), "0 _VALUE=0 _VALUE_RETURNED=0\n1 +return\n2 _VALUE=0 _VALUE_RETURNED=0\n3 +return\n");
}

TEST(Rs274Flow, ComputedCalls) {
    EXPECT_EQ(tree("o[#1+1] call [5]\n"), "0 indirect (#1 + 1)(5)\n1 M2\n");
    EXPECT_EQ(tree("o[10+1] call\n"), "0 call O11\n1 M2\n");
    EXPECT_EQ(tree("M98 P#2 L3\n"), "0 indirect #2 x3\n1 M2\n");
}

TEST(Rs274Flow, NumberedProgramsBehindTheEnd) {
    const Reading r("M98 P0200 L2\nM2\nO200 (hole)\nX1\nM99\nO300\nX2\nM99\n");
    EXPECT_EQ(r.messages(), "");
    EXPECT_EQ(names(r), (std::vector<std::string>{"TEST", "O200", "O300"}));
    EXPECT_EQ(r.tree(0), "0 call O200 x2\n1 M2\n");
    EXPECT_TRUE(r.unit().calls[0].shares_parameters);
    EXPECT_EQ(r.tree(1), "0 X1\n1 _VALUE=0 _VALUE_RETURNED=0\n2 +return\n");
    EXPECT_EQ(r.tree(2), "0 X2\n1 _VALUE=0 _VALUE_RETURNED=0\n2 +return\n");
}

TEST(Rs274Flow, AProgramWithoutM99RunsOnIntoTheNext) {
    const Reading r("M98 P200\nM2\nO200\nX1\nO300\nX2\nM99\n");
    EXPECT_EQ(r.messages(), "");
    EXPECT_EQ(r.tree(1), "0 X1\n1 call O300\n2 +return\n");
    EXPECT_EQ(r.tree(2), "0 X2\n1 _VALUE=0 _VALUE_RETURNED=0\n2 +return\n");
}

TEST(Rs274Flow, TextBehindTheEndIsReadOnce) {
    std::string text = "M2\n";
    for (int i = 0; i < 30000; ++i) text += "O" + std::to_string(i) + "\n";
    EXPECT_EQ(Reading(text).units.size(), 30001U);  // quadratic reading takes minutes here
}

TEST(Rs274Flow, ANumberAtTheBeginIsNoProgramOfItsOwn) {
    EXPECT_EQ(names(Reading("O1000 (part)\nX1\nM30\n")), (std::vector<std::string>{"TEST"}));
    EXPECT_EQ(names(Reading("O1000\nX1\nM99\n", "1000.nc")), (std::vector<std::string>{"1000", "O1000"}));
}

TEST(Rs274Flow, M99InTheMainProgramBeginsAnew) { EXPECT_EQ(Reading("X1\nM99\nX2\n").tree(), "0 X1\n1 jump start\n"); }

TEST(Rs274Flow, WhatFollowsTheEndIsNotRead) {
    const Reading remarks("%\nX1\nM2\nnonsense\n%\nmore\n");
    EXPECT_EQ(remarks.messages() + remarks.tree(), "0 X1\n1 M2\n");
    EXPECT_EQ(Reading("%\nX1\n%\nnonsense\n").messages(), "");
    EXPECT_EQ(complaint("%\nX1\n%\n(remark)\nX2\nX3\n"),
              "5:1 this block stands behind the % that ends the program and is never run");
    EXPECT_EQ(complaint("X1\n%\n"), "2:1 a % at the end needs one at the begin of the program");
    EXPECT_EQ(Reading("X1\n").unit().unended, "the program ends without M2 or M30");
    EXPECT_EQ(Reading("%\nX1\n").unit().unended, "the program ends without M2, M30 or its second %");
    EXPECT_EQ(Reading("X1\nM2\n").unit().unended + Reading("%\nX1\n%\n").unit().unended, "");
    EXPECT_EQ(Reading("o1 if [#1]\nM2\no1 endif\nX[1\nM2").first_message(), "4:2 this bracket is not closed");
}

/// Its own interpreter has ended the program before it comes there.
TEST(Rs274Flow, AnOldEditorsEndOfTextBehindM2IsNothing) {
    for (const char* sign : {"\x1A", "\x1A\x1A\n", "\x1A\r\n", " \x1A"}) {
        EXPECT_EQ(Reading("X1\nM2\n" + std::string(sign)).messages(), "");
        EXPECT_EQ(Reading("X1\r\nM30\r\n" + std::string(sign)).messages(), "");
        EXPECT_EQ(Reading("o1 sub\no1 endsub\nX1\nM2\n" + std::string(sign)).messages(), "");
        EXPECT_EQ(Reading("X1\nM99\n" + std::string(sign)).messages(), "");
        EXPECT_EQ(Reading("%\nX1\n%\n" + std::string(sign)).messages(), "");
    }
    EXPECT_NE(complaint("X1\nM2\n\x1A\nX2\n"), "") << "blocks that never run";
    EXPECT_NE(complaint("X1\x1A\nM2\n"), "") << "a sign that LinuxCNC refuses";
}

TEST(Rs274Flow, WrongStructureIsRefusedWhereItStands) {
    EXPECT_EQ(complaint("o1 endif\n"), "1:1 o1 endif without o1 if");
    EXPECT_EQ(complaint("o1 while [1]\no1 endif\n"), "2:1 o1 endif belongs to no if: o1 is the label of a while");
    EXPECT_EQ(complaint("o1 if [1]\no2 while [1]\no1 endif\nM2\n"), "2:1 o2 while without o2 endwhile");
    EXPECT_EQ(complaint("o1 if [1]\nX1\nM2\n"), "1:1 o1 if without o1 endif");
    EXPECT_EQ(complaint("o1 if 1\no1 endif\nM2\n"), "1:7 expected [ behind if, found '1'");
    EXPECT_EQ(complaint("o1 sub\no2 sub\no2 endsub\no1 endsub\nM2\n"),
              "2:1 a subprogram is defined within another: o2 sub in o1");
    EXPECT_EQ(complaint("o1 sub\nX1\nM2\n"), "1:1 o1 sub without its endsub");
    EXPECT_EQ(complaint("o1 sub\nM99\no1 endsub\nM2\n"), "2:1 o1 sub ends with endsub, not with M99");
    EXPECT_EQ(complaint("o1 endsub\n"), "1:1 o1 endsub stands in no subprogram");
    EXPECT_EQ(complaint("o1 repeat [2]\no1 break\no1 endrepeat\nM2\n"),
              "2:1 o1 break belongs to no while or do but to repeat");
    EXPECT_EQ(complaint("o1 if [1]\no1 endif\no1 if [1]\no1 endif\nM2\n"),
              "3:1 the label o1 belongs to the structure of line 1 already");
    EXPECT_EQ(complaint("o1 call 5\n"), "1:9 only a comment may stand behind an o-word, found '5'");
    EXPECT_EQ(complaint("o1 foo\n"), "1:4 no o-word begins here: 'foo'");
    EXPECT_EQ(complaint("M98 L2\n"), "1:1 M98 does not say which program");
}

TEST(Rs274Flow, TheTwoStylesOfSubprogramsDoNotMix) {
    EXPECT_EQ(complaint("M98 P1\nM2\nO1 sub\nO1 endsub\n"),
              "3:1 M98 of line 1 calls o1 sub, which only o1 call can call");
    EXPECT_EQ(complaint("o1 call\nM2\nO1\nM99\n"),
              "3:1 o1 call of line 1 calls the program O1, which only M98 can call");
    EXPECT_EQ(complaint("M98 P1\nM2\nO1\nO1 endsub\n"), "4:1 o1 endsub stands in no subprogram");
}

TEST(Rs274Flow, ALabelOfAnotherBranchMayBeUsedAgain) {
    EXPECT_EQ(complaint("o1 if [1]\no2 if [1]\no2 endif\no1 else\no2 if [1]\no2 endif\no1 endif\nM2\n"), "");
}

}  // namespace obrys::read::rs274
