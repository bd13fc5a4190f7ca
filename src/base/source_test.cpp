#include "base/source.hpp"

#include <gtest/gtest.h>

#include <array>

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

/// Lines of a large text are found as far as somebody asks; whatever is asked first, they are the same.
TEST(Sources, LinesOfLargeTexts) {
    std::string text;
    std::vector<std::size_t> begins{0};
    const auto add = [&](std::size_t length, std::string_view end) {
        text += std::string(length, 'X');
        text += end;
        begins.push_back(text.size());
    };
    constexpr std::array<std::string_view, 3> ends{"\n", "\r\n", "\r"};
    const auto fill = [&](std::size_t size) {
        for (std::size_t i = 0; text.size() + 200 < size; ++i) add(1 + i % 97, ends[i % ends.size()]);
    };
    fill(Store::piece);
    add(Store::piece - 1 - text.size(), "\r\n");  // the CR is the last byte of a piece
    add(Store::piece + 5, "\n");                  // longer than a piece
    fill(4 * Store::piece);
    add(3, "\r");
    for (const bool forwards : {true, false}) {
        Sources sources;
        const std::uint32_t file = sources.add("a.nc", text);
        for (std::size_t i = 0; i < begins.size(); i += 37) {
            const std::size_t k = forwards ? i : begins.size() - 1 - i;
            const auto number = static_cast<std::uint32_t>(k + 1);
            const Position at = sources.position(file, static_cast<std::uint32_t>(begins[k]));
            ASSERT_EQ(at.line, number);
            ASSERT_EQ(at.column, 1U);
            std::string line = text.substr(begins[k], k + 1 < begins.size() ? begins[k + 1] - begins[k] : text.npos);
            while (line.ends_with('\n') || line.ends_with('\r')) line.pop_back();
            ASSERT_EQ(sources.line(file, number), line);
        }
        EXPECT_EQ(sources.line(file, static_cast<std::uint32_t>(begins.size() + 1)), "");
        EXPECT_EQ(sources.position(file, 0xFFFFFFFF).line, begins.size());
    }
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
