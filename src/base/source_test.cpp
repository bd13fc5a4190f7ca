#include "base/source.hpp"

#include <gtest/gtest.h>

#include "base/codes.hpp"
#include "base/diagnostic.hpp"

namespace obrys::base {
namespace {

TEST(Sources, LinesWhateverTheirEnds) {
    Sources s;
    const auto f = s.add("a.MPF", "N10 A\r\nN20 B\nN30 C\rN40 D");
    EXPECT_EQ(s.line(f, 1), "N10 A");
    EXPECT_EQ(s.line(f, 2), "N20 B");
    EXPECT_EQ(s.line(f, 3), "N30 C");
    EXPECT_EQ(s.line(f, 4), "N40 D");
    EXPECT_EQ(s.line(f, 5), "");
    EXPECT_EQ(s.position(f, 7).line, 2U);
    EXPECT_EQ(s.position(f, 1000).line, 4U);
}

TEST(Sources, ColumnsCountCharacters) {
    Sources s;
    const auto utf8 = s.add("u", "ÚÚX");
    EXPECT_EQ(s.position(utf8, 4).column, 3U);
    const auto cp1252 = s.add("c", "\xDA\xDAX");
    EXPECT_EQ(s.position(cp1252, 2).column, 3U);
    EXPECT_EQ(s.line_utf8({cp1252, 0, 1}), "ÚÚX");
}

TEST(Sources, ByteOrderMarkIsDropped) {
    Sources s;
    EXPECT_EQ(s[s.add("b", "\xEF\xBB\xBFN10")].text, "N10");
}

TEST(Sources, BlockNumbers) {
    Sources s;
    const auto f = s.add("a", "N68 G0\n/3 N70 X1\nG1\n  n80 Y", BlockNumbers::n_word);
    EXPECT_EQ(s.block_number(f, 2), 68U);
    EXPECT_EQ(s.block_number(f, 10), 70U);
    EXPECT_EQ(s.block_number(f, 18), std::nullopt);
    EXPECT_EQ(s.block_number(f, 24), 80U);
    const auto h = s.add("h", "12 L X+1", BlockNumbers::leading);
    EXPECT_EQ(s.block_number(h, 4), 12U);
}

TEST(Diagnostics, RenderedWithCaretRemedyAndStack) {
    Sources s;
    const auto f = s.add("A.MPF", "N10 G0\nN20 R2=5/R1\n");
    const Diagnostic d{Severity::error, codes::arithmetic, {f, 14, 18}, "division by zero",
                       "guard it",      {{f, 0, 6}},       {}};
    EXPECT_EQ(render(d, s),
              "A.MPF:2:8: error: division by zero [arithmetic]\n"
              "  N20 R2=5/R1\n"
              "         ^~~~\n"
              "  remedy: guard it\n"
              "  called from A.MPF:1:1: N10 G0\n");
}

TEST(Diagnostics, LongLinesAreShownAroundThePlace) {
    Sources s;
    const auto f = s.add("L", std::string(50'000, 'a') + "b" + std::string(50'000, 'c'));
    const std::string text = render({Severity::error, codes::syntax, {f, 50'000, 50'001}, "here", {}, {}, {}}, s);
    EXPECT_LT(text.size(), 600U);
    const auto caret = text.find("^"), line = text.find("\n  ...") + 1;
    EXPECT_EQ(text[line + (caret - text.rfind('\n', caret) - 1)], 'b');
}

TEST(Diagnostics, EndlessComplaintsAreCounted) {
    Diagnostics d;
    d.set_limit_per_code(10);
    for (int i = 0; i < 25; ++i) d.add({Severity::warning, codes::unknown_word, {}, "x", {}, {}, {}});
    EXPECT_EQ(d.all().size(), 10U);
    EXPECT_EQ(d.dropped(), 15U);
    EXPECT_FALSE(d.has_errors());
}

TEST(Diagnostics, LongStacksAreShortened) {
    const std::vector<Span> stack(100);
    const ShownStack s = shown(stack);
    EXPECT_EQ(s.inner.size() + s.outer.size() + s.left_out, 100U);
    EXPECT_EQ(s.inner.size() + s.outer.size(), 12U);
}

}  // namespace
}  // namespace obrys::base
