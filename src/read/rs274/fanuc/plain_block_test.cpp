#include "read/rs274/fanuc/plain_block.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <sstream>

#include "read/rs274/fanuc/reading.hpp"

namespace obrys::read::rs274 {

using testing::pick;
using testing::Reading;

namespace {

/// Words with their places, how blocks depend on modes, and what was said. Where words stand for the whole line, how
/// long that is does not count: a comment behind it does.
std::string all_of(const Reading& r) {
    std::ostringstream out;
    for (const program::Unit& u : r.units) {
        out << u.name << ' ' << u.lengths_with_point << '\n';
        for (const program::Statement& s : u.statements)
            out << s.begin << ' ' << s.first << ' ' << static_cast<int>(s.kind) << ' ' << static_cast<int>(s.flags)
                << '\n';
        for (const program::Word& w : u.words) {
            const std::uint32_t length = program::is_literal(w) ? w.length : std::min<std::uint32_t>(w.length, 3);
            out << w.code << ' ' << w.form << ' ' << w.offset << ' ' << length << ' ' << w.payload << '\n';
        }
        for (const program::ModeSpan& s : u.modes.spans) out << s.first << ' ' << s.last << ' ' << s.use << '\n';
        for (const program::ModeUse& m : u.modes.uses)
            out << m.before << ' ' << m.after << ' ' << m.relied << ' ' << m.written << ' ' << m.whole << '\n';
        out << u.exprs.size() << ' ' << u.jumps.size() << '\n';
        for (const auto& j : u.jumps) out << j.target << '\n';
    }
    for (const base::Diagnostic& d : r.diagnostics.all())
        out << d.code << ' ' << d.where.begin << ' ' << d.text << '\n';
    return out.str();
}

/// Few shapes, so that they come again; and lines that change what they mean.
std::vector<std::string> lines_of(std::mt19937& random) {
    const std::vector<std::string> shapes{
        "X# Y#",    "G1X#Z#",   "G01 X# Y# Z# F#", "Z#",       "G2 X# Y# I# J#", "X#Y#R#",  "x# y#", "G3X#Z#R#",
        "G0 X# Z#", "N7 X# Y#", "U# W#",           "C# X#",    "X# I#",          "X# K#",   "A# X#", "X# X#",
        "F#",       "G00G1X#",  "X# R#",           "G1 Z# R#", "  X# Z#  ",      "N12G1X#", "G4 X#", "X#, C#"};
    const std::vector<std::string> numbers{"1.", "-2.5", "+0.125", ".5", "0.", "-.25", "12", "123456789.1", "3.1415"};
    const std::vector<std::string> modes{
        "G17", "G18",   "G90",        "G91",          "G20",   "G21",           "G81X1.Y2.Z-3.R1.F50.",
        "G80", "G16",   "G15",        "G95",          "G94",   "G68X0.Y0.R30.", "G69",
        "G98", "G99",   "G87Z-1.R1.", "G12.1",        "G13.1", "G1X1.,R2.",     "GOTO7",
        "O2",  "M98P2", "G92X1.Z2.",  "G90X3.Z-4.F.2"};
    std::vector<std::string> lines;
    for (int n = std::uniform_int_distribution<int>(3, 40)(random); n > 0; --n) {
        if (random() % 6 == 0) {
            lines.push_back(pick(random, modes));
            continue;
        }
        std::string line;
        for (const char c : pick(random, shapes)) line += c == '#' ? pick(random, numbers) : std::string(1, c);
        lines.push_back(line);
    }
    return lines;
}

}  // namespace

/// Blocks that are read as their like was are what the full reader makes of them, which a comment behind them calls.
TEST(PlainBlock, BothWaysOfReadingAgree) {
    for (unsigned seed = 0; seed < 3000; ++seed) {
        std::mt19937 random(seed);
        std::string fast = "%\nO1\nG21\n";
        std::vector<std::string> lines = lines_of(random);
        std::size_t longest = 0;
        for (const std::string& line : lines) longest = std::max(longest, line.size());
        std::string full = fast;
        for (const std::string& line : lines) {  // as many bytes of both, so that places are the same
            const std::string blanks(longest - line.size(), ' ');
            fast += line + blanks + "  \n";
            full += line + blanks + "()\n";
        }
        fast += "M30\n%\n";
        full += "M30\n%\n";
        SCOPED_TRACE("seed " + std::to_string(seed) + "\n" + fast);
        ASSERT_EQ(all_of(testing::fanuc(fast)), all_of(testing::fanuc(full)));
        ASSERT_EQ(all_of(testing::haas(fast)), all_of(testing::haas(full)));
        ASSERT_EQ(all_of(testing::lathe(fast)), all_of(testing::lathe(full)));
    }
}

/// What such a block is, and what is left to the full reader.
TEST(PlainBlock, NumbersHaveAPoint) {
    const auto is_plain = [](const std::string& text, bool lathe = false) {
        PlainBlock block;
        return scan_plain_block(text, 0, text.size(), lathe, block);
    };
    EXPECT_TRUE(is_plain("G1 X1. Y-.5 F200."));
    EXPECT_TRUE(is_plain("N10 X1.5\r\n"));
    EXPECT_FALSE(is_plain("X1"));  // counts least increments
    EXPECT_FALSE(is_plain("G4 X1."));
    EXPECT_FALSE(is_plain("G-1 X1."));
    EXPECT_FALSE(is_plain("X1. (A)"));
    EXPECT_FALSE(is_plain("X1.;Y2."));
    EXPECT_FALSE(is_plain("N10"));
    EXPECT_FALSE(is_plain("X#1"));
    EXPECT_FALSE(is_plain("F-5."));
    EXPECT_TRUE(is_plain("G3 X1. R-5."));
    EXPECT_FALSE(is_plain("G1 X1. R-5.", true));  // which way a corner goes
}

}  // namespace obrys::read::rs274
