#include <gtest/gtest.h>

#include <random>

#include "read/rs274/fanuc/reading.hpp"

namespace obrys::read::rs274 {

using testing::pick;
using testing::Reading;

namespace {

void check_tree(const Reading& r, const std::string& text) {
    const std::size_t size = r.sources[r.file].text.size();
    for (const program::Unit& u : r.units) {
        for (std::size_t i = 0; i < u.exprs.size(); ++i) {
            const program::Expr& e = u.exprs[i];
            ASSERT_LE(e.begin, e.end) << text;
            ASSERT_LE(e.end, size) << text;
            ASSERT_TRUE(e.kind != program::ExprKind::binary || (e.a < i && e.b < i)) << text;
        }
        for (const auto& b : u.branches)
            ASSERT_TRUE(b.target == program::no_target || b.target <= u.statements.size()) << text;
        for (const auto& j : u.jumps)
            ASSERT_TRUE(j.target == program::no_target || j.target <= u.statements.size()) << text;
    }
    for (const base::Diagnostic& d : r.diagnostics.all()) {
        ASSERT_LE(d.where.begin, d.where.end) << text;
        ASSERT_LE(d.where.end, size) << text;
    }
}

}  // namespace

/// Pieces of programs in any order are read, whatever they mean.
TEST(FanucProperty, AnyTextIsRead) {
    const std::vector<std::string> pieces{
        "G0",    "G1",    "X1.", "Y-2",   "Z#1", "G65",   "P1000", "IF[#1EQ#0]", "THEN",    "GOTO10", "WHILE[#1LT2]",
        "DO1",   "END1",  "\n",  "\n",    "N10", "/2",    "(A",    ")",          "#3000=1", "#1=",    "[",
        "]",     "M98",   "M99", "G71",   "G70", "Q20",   "U1",    "W-1",        "G90",     "G92",    "G16",
        "G68",   "R45.",  "G51", "G43.4", "H1",  "T0101", "%",     "O2",         ";",       "DPRNT[", "ELSE",
        "ENDIF", "G54.1", "G10", "L2",    "G87", "K3",    ",C1.",  "G66",        "G67",     "\xFF",   "999999999999",
        "M97",   "G31",   "G32", "F1.5",  "G53", "#5041", "SIN[",  "G28",        "I1.",     "J2.",    "G83",
    };
    for (unsigned seed = 0; seed < 3000; ++seed) {
        std::mt19937 random(seed);
        std::string text;
        for (int n = std::uniform_int_distribution<int>(1, 25)(random); n > 0; --n) text += pick(random, pieces) + " ";
        SCOPED_TRACE("seed " + std::to_string(seed));
        check_tree(Reading(text, "A.NC", read_fanuc), text);
        check_tree(Reading(text, "A.NC", read_haas), text);
        check_tree(testing::lathe(text), text);
        if (HasFatalFailure()) return;
    }
}

/// A number without point is the same length as with one, a thousandth of it.
TEST(FanucProperty, IncrementsAreThousandths) {
    for (unsigned seed = 0; seed < 500; ++seed) {
        std::mt19937 random(seed);
        const int n = std::uniform_int_distribution<int>(-99'999'999, 99'999'999)(random);
        const Reading r = testing::fanuc("%\nO1\nG21\nG0 X" + std::to_string(n) + "\nM30\n%\n");
        const program::Unit& u = r.unit();
        ASSERT_EQ(program::code_of(u.words[u.statements[1].first]), program::Code::x) << seed;
        EXPECT_DOUBLE_EQ(u.literal(u.words[u.statements[1].first]), n / 1000.0) << seed;
    }
}

}  // namespace obrys::read::rs274
