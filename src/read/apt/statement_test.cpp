#include <gtest/gtest.h>

#include "read/apt/reading.hpp"
#include "read/apt/scanner.hpp"

namespace obrys::read::apt {

using program::Code;
using program::Modal;
using testing::has_modal;
using testing::Reading;
using testing::value;

TEST(AptStatement, APointIsAStraightMove) {
    const Reading r("UNITS/MM\nGOTO / 1.5, -2, 3.25E1\n");
    EXPECT_EQ(value(r, Code::x), 1.5);
    EXPECT_EQ(value(r, Code::y), -2);
    EXPECT_EQ(value(r, Code::z), 32.5);
    EXPECT_TRUE(has_modal(r, Modal::linear));
    EXPECT_EQ(r.messages(), "");
}

TEST(AptStatement, RapidHoldsForOnePoint) {
    const Reading r("UNITS/MM\nRAPID\nGOTO/0,0,0\nGOTO/1,0,0\n");
    const std::string tree = r.tree();
    const std::string rapid = "m" + std::to_string(static_cast<int>(Modal::rapid));
    const std::string linear = "m" + std::to_string(static_cast<int>(Modal::linear));
    EXPECT_LT(tree.find(rapid), tree.find(linear)) << tree;
    EXPECT_EQ(tree.find(linear), tree.rfind(linear)) << tree;
}

TEST(AptStatement, AStatementGoesOnBehindADollar) {
    const Reading r("UNITS/MM\nGOTO/1,$ the rest follows\n  2,   $\n3 $$ a note\n");
    EXPECT_EQ(value(r, Code::y), 2);
    EXPECT_EQ(value(r, Code::z), 3);
    EXPECT_EQ(r.messages(), "");
}

TEST(AptStatement, CardsOf80ColumnsAreNumbered) {
    const auto card = [](std::string words, const char* number) {
        words.resize(72, ' ');
        return words + number + "\n";
    };
    const std::string deck = card("UNITS/MM", "00000010") + card("GOTO/1,2,3", "00000020");
    EXPECT_TRUE(has_card_numbers(deck));
    const Reading r(deck);
    EXPECT_EQ(value(r, Code::z), 3);
    EXPECT_EQ(r.messages(), "");
    EXPECT_FALSE(
        has_card_numbers("$$ a line of a comment that is longer than the seventy-two columns of a card 1\n"
                         "$$ a line of a comment that is longer than the seventy-two columns of a card, too\n"));
}

TEST(AptStatement, UnknownWordsAreSaidWithTheNearest) {
    const Reading r("GOTP/1,2,3\nQUUX/5\n");
    EXPECT_EQ(r.problems(), "GOTP: did you mean GOTO?\nQUUX: no statement of cutter locations begins so\n");
}

TEST(AptStatement, PartProgramsAreNoCutterLocations) {
    const Reading r("P1=POINT/0,0,0\nGOLFT/L1,TO,L2\n");
    EXPECT_NE(r.problems().find("P1"), std::string::npos);
    EXPECT_NE(r.problems().find("GOLFT/L1,TO,L2: it is of an APT part program"), std::string::npos);
}

TEST(AptStatement, SynonymsTakeAWordAway) {
    const Reading r("SYN/'TLAXIS','$$*TLAXIS'\nUNITS/MM\nTLAXIS/1,0,0\nGOTO/0,0,0\n");
    EXPECT_FALSE(has_modal(r, Modal::tool_along));
}

TEST(AptStatement, WhatStandsBehindTheEndIsSaid) {
    const Reading r("UNITS/MM\nEND\nFINI\nGOTO/1,2,3\nGOTO/1,2,4\n");
    EXPECT_EQ(r.messages(), "4:1 this statement stands behind the end of the cutter locations and is never run\n");
    EXPECT_EQ(r.unit.unended, "");
}

TEST(AptStatement, AnEndThatIsMissingIsKept) { EXPECT_NE(Reading("UNITS/MM\n").unit.unended, ""); }

TEST(AptStatement, WrongPointsMarkTheNumber) {
    EXPECT_EQ(Reading("UNITS/MM\nGOTO/1,2\n").messages(),
              "2:6 a point has three coordinates, and three numbers more for the tool's axis\n");
    EXPECT_EQ(Reading("UNITS/MM\nGOTO/1,2,3,0,0,2\n").messages(),
              "2:12 this vector of the tool's axis has not the length 1\n");
    EXPECT_EQ(Reading("GOTO/1,2,3 $").messages(), "1:1 the text ends behind $, which wants a further line\n");
}

/// Its memory is bound, and what stands behind it is read.
TEST(AptStatement, AStatementWithoutEndIsSaid) {
    std::string text = "UNITS/MM\nGOTO/1,2,3";
    for (int i = 0; i < 40'000; ++i) text += i % 100 == 0 ? ",$\n1" : ",1";
    const Reading r(text + "\nGOTO/4,5,6\n");
    EXPECT_NE(r.messages().find("a statement of more than 65536 words, numbers and signs is not read"),
              std::string::npos)
        << r.messages();
    EXPECT_EQ(value(r, Code::z), 6);
    EXPECT_LE(r.messages().size(), 200U);
    // A text goes on to its line's end, however many words it has.
    std::string remark = "PPRINT/";
    for (int i = 0; i < 70'000; ++i) remark += " A";
    EXPECT_EQ(Reading(remark + "\n").messages(), "");
}

TEST(AptStatement, UnitsFollowFromTheFeedsWhereNothingSaysThem) {
    EXPECT_TRUE(has_modal(Reading("GOTO/1,2,3\nFEDRAT/5,IPM\n"), Modal::inch_all));
    EXPECT_TRUE(has_modal(Reading("GOTO/1,2,3\nFEDRAT/5,MMPM\n"), Modal::metric_all));
    EXPECT_EQ(Reading("GOTO/1,2,3\n").messages(),
              "1:1 no UNITS stands before the first length: lengths are taken as millimetres\n");
}

TEST(AptStatement, AFeedOfAnotherUnitIsConverted) {
    const Reading r("UNITS/MM\nFEDRAT/IPM,10\nGOTO/1,2,3\n");
    EXPECT_EQ(value(r, Code::feed), 254);
}

}  // namespace obrys::read::apt
