#include "write/tape.hpp"

#include <gtest/gtest.h>

#include <bit>
#include <set>

namespace obrys::write {
namespace {

TEST(Tape, IsoRowsHaveAnEvenNumberOfHoles) {
    std::string text = "\r\n\t";
    for (char c = ' '; c < 0x7F; ++c) text += c;
    const std::string rows = punched(text, Tape::iso);
    ASSERT_EQ(rows.size(), text.size());
    for (std::size_t i = 0; i < rows.size(); ++i) {
        const auto row = static_cast<unsigned char>(rows[i]);
        EXPECT_EQ(std::popcount(row) % 2, 0);
        EXPECT_EQ(row & 0x7F, text[i]);
    }
    EXPECT_EQ(punched("N1 G0\n", Tape::iso), "N\xB1\xA0G\x30\n");
}

TEST(Tape, EiaRowsHaveAnOddNumberOfHolesAndAreDifferent) {
    const std::string text = "0123456789ABCDEFGHIJKLMNOPQRSTUVWXYZ \t%&+-/,.\n";
    const std::string rows = punched(text, Tape::eia);
    ASSERT_EQ(rows.size(), text.size());
    for (const char row : rows) EXPECT_EQ(std::popcount(static_cast<unsigned char>(row)) % 2, 1);
    EXPECT_EQ(std::set<char>(rows.begin(), rows.end()).size(), rows.size());
    EXPECT_EQ(punched("%\r\nG1X-2.5\n", Tape::eia), "\x0B\x80\x67\x01\x37\x40\x02\x6B\x15\x80");
}

TEST(Tape, CharactersThatTheCodeHasNotAreNamedOnceAndLeftOut) {
    const auto eia = missing_characters("N1 (a#)\nN2 (\n", Tape::eia);
    ASSERT_EQ(eia.size(), 3U);
    EXPECT_EQ(eia[0].character, "(");
    EXPECT_EQ(eia[0].line, 1U);
    EXPECT_EQ(punched("a(B", Tape::eia), "\x61\x62");
    const auto iso = missing_characters("x\n(\xC5\x99)\n\x1F", Tape::iso);
    ASSERT_EQ(iso.size(), 2U);
    EXPECT_EQ(iso[0].character, "\xC5\x99");
    EXPECT_EQ(iso[0].line, 2U);
    EXPECT_TRUE(missing_characters("\xC5\x99", Tape::none).empty());
    EXPECT_EQ(punched("\xC5\x99", Tape::none), "\xC5\x99");
}

}  // namespace
}  // namespace obrys::write
