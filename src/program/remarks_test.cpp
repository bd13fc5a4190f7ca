#include "program/remarks.hpp"

#include <gtest/gtest.h>

#include "program/builder.hpp"

namespace obrys::program {
namespace {

/// One statement for each line that has words in front of its remark.
std::string remarked(const std::string& text, const RemarkSigns& signs) {
    Unit unit;
    unit.end = static_cast<std::uint32_t>(text.size());
    Names names;
    base::Diagnostics diagnostics;
    Builder build(unit, names, diagnostics, text);
    for (std::size_t at = 0; at < text.size(); at = std::min(text.find('\n', at), text.size()) + 1) {
        const char first = text[at];
        if (first == ';' || first == '(' || first == '*' || first == '\n') continue;
        const auto end = static_cast<std::uint32_t>(std::min(text.find('\n', at), text.size()));
        if (first == 'Q') {  // goes on
            build.end_statement(end);
            continue;
        }
        build.begin_block();
        build.statement(StatementKind::block, static_cast<std::uint32_t>(at));
        build.end_statement(end);
    }
    add_remarks(unit, text, signs);
    std::string out;
    for (const Remark& r : unit.remarks) out += std::to_string(r.statement) + ":" + r.text + "|";
    return out;
}

constexpr RemarkSigns semicolon{.to_line_end = ';'}, brackets{.brackets = true},
    klartext{.to_line_end = ';', .star_blocks = true, .goes_on = '~'};

TEST(Remarks, StandBeforeTheStatementThatTheyStandAt) {
    EXPECT_EQ(remarked("; head\nG0 X1 ; one\n\n;; two\n;$PATH=/_N_WKS_DIR\nM30\n", semicolon), "0:head|0:one|1:two|");
    EXPECT_EQ(remarked("(HEAD)\nG0 (ONE) X1 (TWO (NESTED))\nM30 (OPEN ( TWICE)", brackets),
              "0:HEAD|0:ONE|0:TWO (NESTED)|1:OPEN ( TWICE|");
}

TEST(Remarks, AreNoneBetweenQuotesNorBetweenTheWordsOfAStatement) {
    EXPECT_EQ(remarked("MSG \"a;b\" ; c\n", semicolon), "0:c|");
    EXPECT_EQ(remarked("12 CYCL DEF 200 ~\nQ200=2 ;SET-UP ~\nQ201=-5 ;DEPTH\n13 L ; home\n", klartext), "1:home|");
}

TEST(Remarks, HeadingsOfKlartextAreSome) {
    EXPECT_EQ(remarked("* - Roughing\n13 L\n14 L ; x\n", klartext), "0:Roughing|1:x|");
}

TEST(Remarks, BehindTheLastStatementStandAtNothing) { EXPECT_EQ(remarked("M30\n; end\n", semicolon), ""); }

}  // namespace
}  // namespace obrys::program
