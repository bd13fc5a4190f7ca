#include "base/text.hpp"

#include <gtest/gtest.h>

#include <array>
#include <charconv>
#include <cmath>
#include <random>

#include "base/number.hpp"

namespace obrys::base {
namespace {

TEST(Text, Utf8IsToldWhereverTheOddByteStands) {
    for (std::size_t at = 0; at < 40; ++at) {
        std::string s(40, 'x');
        EXPECT_TRUE(is_utf8(s));
        s[at] = '\xDA';  // CP1252 for U acute; alone it is no UTF-8
        EXPECT_FALSE(is_utf8(s)) << at;
        s.insert(at + 1, "\x9A");
        EXPECT_TRUE(is_utf8(s)) << at;
    }
    EXPECT_FALSE(is_utf8("\xC0\x80"));          // overlong
    EXPECT_FALSE(is_utf8("\xED\xA0\x80"));      // surrogate
    EXPECT_FALSE(is_utf8("\xF4\x90\x80\x80"));  // past U+10FFFF
    EXPECT_TRUE(is_utf8("\xF4\x8F\xBF\xBF"));
}

TEST(Text, Cp1252BecomesUtf8) {
    EXPECT_EQ(cp1252_to_utf8("\xDAHEL \x80"), "ÚHEL €");
    EXPECT_EQ(as_utf8("ÚHEL"), "ÚHEL");
    EXPECT_EQ(character_count("ÚHEL"), 4U);
}

TEST(Text, BinaryIsToldFromPrograms) {
    EXPECT_FALSE(looks_binary("N10 G0 X1\r\n\tM30\x1A"));
    EXPECT_TRUE(looks_binary(std::string_view("N10\0G0", 6)));
}

TEST(Number, DecimalsAreTheNearestDouble) {
    for (const char* text :
         {"0.1", "-12.345", ".5", "5.", "+7", "123456789.123456789", "0.000000001", "99999999999999999999.5"}) {
        const NumberScan scan = scan_decimal(text);
        EXPECT_EQ(scan.length, std::string_view(text).size()) << text;
        EXPECT_EQ(scan.value, *parse_double(text[0] == '.' ? "0.5" : text)) << text;
    }
    EXPECT_EQ(scan_decimal("X5").length, 0U);
    EXPECT_EQ(scan_decimal("-").length, 0U);
    EXPECT_EQ(scan_decimal("1.2.3").length, 3U);
}

/// As the library rounds the exact value; values near the middle between two decimals among them.
TEST(Number, FixedIsTheNearestDecimal) {
    std::mt19937 random(20261127);  // NOLINT: the same values every time
    std::uniform_real_distribution<double> share(-1, 1);
    for (int i = 0; i < 200'000; ++i) {
        const int decimals = i % 9;
        const double ten = std::pow(10, decimals);
        double value = share(random) * std::pow(10, i % 13 - 4);
        if (i % 3 == 0) value = (std::round(value * ten) + 0.5) / ten;
        if (i % 11 == 0) value = std::nextafter(value, share(random));
        std::array<char, 64> buffer;
        const auto end = std::to_chars(buffer.data(), buffer.end(), value, std::chars_format::fixed, decimals).ptr;
        std::string expected(buffer.data(), end);
        if (expected.find_first_not_of("-0.") == std::string::npos && expected[0] == '-') expected.erase(0, 1);
        ASSERT_EQ(fixed(value, decimals), expected) << shortest(value);
    }
    EXPECT_EQ(fixed(1e300, 1).size(), 303U);
    EXPECT_EQ(fixed(NAN, 2), "nan");
    EXPECT_EQ(fixed(0, 0), "0");
}

TEST(Number, PrintsWithoutLocaleAndMinusZero) {
    EXPECT_EQ(fixed(-0.0004, 3), "0.000");
    EXPECT_EQ(fixed(2.0005, 3), "2.001");  // the double lies above the tie
    EXPECT_EQ(fixed(1234567.5, 1), "1234567.5");
    EXPECT_EQ(shortest(0.1), "0.1");
    EXPECT_EQ(shortest(-0.0), "0");
    EXPECT_EQ(*parse_double(shortest(1.0 / 3)), 1.0 / 3);
}

}  // namespace
TEST(Text, EndSignsOfOldEditorsAreNoText) {
    EXPECT_EQ(without_end_signs("M30\n\x1A"), "M30\n");
    EXPECT_EQ(without_end_signs("M30\x1A\x1A\r\n"), "M30");
    EXPECT_EQ(without_end_signs(std::string_view("M30\n\x1A\0\0", 7)), "M30\n");
    EXPECT_EQ(without_end_signs("M30\n \r\n"), "M30\n \r\n");
    EXPECT_EQ(without_end_signs("M2\n\x1A\nX1\n"), "M2\n\x1A\nX1\n") << "what is behind it still is text";
    EXPECT_EQ(without_end_signs("\x1A"), "");
    EXPECT_EQ(without_end_signs(""), "");
}

}  // namespace obrys::base
