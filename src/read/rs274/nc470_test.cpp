#include <gtest/gtest.h>

#include "read/rs274/nc470_read.hpp"
#include "read/rs274/reading.hpp"

namespace obrys::read::rs274 {

namespace {

testing::Reading nc470(const std::string& text) { return testing::Reading(text, "TEST.NC", read_nc470); }

}  // namespace

TEST(Nc470, BlocksOfOneAxisAreRead) {
    const auto r = nc470(
        "%\nN1 T1 M6\nN2 S500 M3\nN3 G0 X1.000\nN4 Y2.000\nN5 G1 Z-3.000 D2 F100\nN6 G4 F1.5\n(TEXT)\nN7 M30\n%\n");
    EXPECT_EQ(r.messages(), "");
    const program::testing::TreeText tree(r.unit(), r.names);
    EXPECT_EQ(tree.statement(3), "Y2");
    EXPECT_EQ(r.unit().unended, "");
}

TEST(Nc470, WhatTheControlDoesNotHaveIsRefusedByName) {
    EXPECT_EQ(nc470("G0 X1 Y2\nM30\n").first_message(), "1:4 this control moves one axis at a time");
    EXPECT_EQ(nc470("G0 B90 Z2\nM30\n").first_message(), "1:4 this control moves one axis at a time");
    EXPECT_EQ(nc470("X1\nM30\n").first_message(), "1:1 no motion has been said before");
    EXPECT_EQ(nc470("G2 X1 I1\nM30\n").first_message(), "1:1 G2 is not among the G codes that are known of NC 470");
    EXPECT_EQ(nc470("G0 X1 R2\nM30\n").first_message(), "1:7 R is none of the letters that are known of NC 470");
    EXPECT_EQ(nc470("G4\nM30\n").first_message(), "1:1 G4 does not say how long");
    EXPECT_EQ(nc470("G4 F1 X1\nM30\n").first_message(), "1:1 an axis beside G4");
    EXPECT_EQ(nc470("G0 X=1\nM30\n").first_message(), "1:4 'X' begins something that this control does not have");
    EXPECT_EQ(nc470("G0 X1 D1.5\nM30\n").first_message(), "1:7 D is the number of an offset");
    EXPECT_EQ(nc470("G0 X1\n").unit().unended, "the program ends without M2 or M30");
}

TEST(Nc470, EveryLineIsReadWithoutHarm) {
    for (const char* text :
         {"%", "(", "G", "N", "N1", "G4 F", "D", "X", "X#1", "[1]", "/N1", ";", "M", "T", "G0X", "\x01"})
        EXPECT_EQ(nc470(std::string(text) + "\nM30\n").units.size(), 1u) << text;
}

}  // namespace obrys::read::rs274
