#include "base/slip.hpp"

#include <gtest/gtest.h>

namespace obrys::base {

TEST(Slip, ACommaBetweenDigitsIsADecimalPoint) {
    EXPECT_EQ(slip_in_number("X90,5", 3), "write a decimal point in place of the comma");
    EXPECT_EQ(slip_in_number("X90, Y1", 3), "");
    EXPECT_EQ(slip_in_number("X ,C5", 2), "");
    EXPECT_EQ(slip_in_number(",5", 0), "");
}

TEST(Slip, LettersThatLookLikeDigits) {
    EXPECT_NE(slip_in_number("X9O Y1", 2).find("digit 0"), std::string_view::npos);
    EXPECT_NE(slip_in_number("XO.", 1).find("digit 0"), std::string_view::npos);
    EXPECT_NE(slip_in_number("Z-5o", 3).find("digit 0"), std::string_view::npos);
    EXPECT_NE(slip_in_number("Xl0 X1l", 6).find("digit 1"), std::string_view::npos);
    EXPECT_EQ(slip_in_number("G65 O5", 4), "") << "a word of its own";
    EXPECT_EQ(slip_in_number("X9OR", 2), "") << "a name";
    EXPECT_EQ(slip_in_number("X9 Q5", 3), "");
    EXPECT_EQ(slip_in_number("X", 7), "");
}

}  // namespace obrys::base
