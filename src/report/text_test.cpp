#include <gtest/gtest.h>

#include "report/sample.hpp"

namespace obrys::report {
namespace {

TEST(TextReport, ReadsAsDocumented) {
    const sample::Sample s = sample::make();
    EXPECT_EQ(to_text(s.subject()), R"(MAIN.MPF: not fully checked: 1 thing was not checked; 1 finding

with blank/SUB.SPF:2:1: error: cuts into the finished part: 1.250 mm deep along X [gouge]
  N5 G1 X=18 Z2 ; ö
  ^~~~~~~~~~~~~
  called from MAIN.MPF:2:5: N20 SUB
  move 1: from X30.000 Z5.000 to X18.000 Z2.000 mm (X radius)
  volume 400.000 mm3

not checked:
  MAIN.MPF:3:5: unknown word FOO (2 times) [unknown-word]
    N30 FOO <x> & M30

assumed:
  R3 = 150 is set from outside [assumption]

2 moves: 1 rapid (0.000 mm), 1 feed (12.369 mm); 7 blocks executed
stock: 50.000 cm3 before, 49.600 cm3 after; section 800.000 mm2 before, 796.500 mm2 after (exact)
)");
}

TEST(TextReport, TheVerdictComesFirst) {
    sample::Sample s = sample::make();
    s.result.unchecked.clear();
    s.result.verdict = check::verdict_of(s.result);
    EXPECT_TRUE(to_text(s.subject()).starts_with("MAIN.MPF: 1 finding\n"));
    s.result.findings.clear();
    s.result.verdict = check::verdict_of(s.result);
    EXPECT_TRUE(to_text(s.subject()).starts_with("MAIN.MPF: clean: nothing found in 2 moves\n"));
}

TEST(TextReport, ColoursOnlyWhenAsked) {
    const sample::Sample s = sample::make();
    EXPECT_EQ(to_text(s.subject()).find('\x1b'), std::string::npos);
    const std::string coloured = to_text(s.subject(), {.colours = true, .listed = true, .all = false});
    EXPECT_NE(coloured.find("\x1b[1;33mnot fully checked: 1 thing was not checked; 1 finding\x1b[0m"),
              std::string::npos);
    EXPECT_NE(coloured.find("SUB.SPF:2:1: \x1b[1;31merror:\x1b[0m cuts"), std::string::npos);
}

TEST(TextReport, PassesOfOneLineAreOneFinding) {
    sample::Sample s = sample::make();
    check::Finding deeper = s.result.findings[0], counted = deeper;
    deeper.move = 5;
    deeper.text = "cuts into the finished part: 2.500 mm deep along X";
    deeper.amounts[0].value = 2;
    counted.move = 7;
    counted.more = 30;
    s.result.findings.push_back(deeper);
    s.result.findings.push_back(counted);
    const std::string text = to_text(s.subject());
    EXPECT_TRUE(text.starts_with("MAIN.MPF: not fully checked: 1 thing was not checked; 1 finding\n"));
    EXPECT_NE(text.find("2.500 mm deep along X [gouge]"), std::string::npos);
    EXPECT_NE(text.find("\n  33 passes, worst 2.000 mm, first move 1\n  move 5: from"), std::string::npos);
    EXPECT_EQ(text.find("move 7"), std::string::npos);
    const std::string all = to_text(s.subject(), {.colours = false, .listed = true, .all = true});
    EXPECT_NE(all.find("  with blank/SUB.SPF:2:1: move 7: cuts"), std::string::npos);
    EXPECT_NE(all.find("and 30 more that are not listed"), std::string::npos);
}

TEST(ByDanger, RapidsFirstRestMaterialLast) {
    check::Result r;
    std::vector<check::Finding>& f = r.findings;
    f.resize(5);
    for (std::uint32_t i = 0; i < 5; ++i) f[i].where = {0, i, i + 1};
    f[0].code = base::codes::rest_material;
    f[1].code = base::codes::arithmetic;
    f[2].code = base::codes::gouge;
    f[2].amounts = {{"depth_x_mm", 1}};
    f[3].code = base::codes::gouge;
    f[3].amounts = {{"depth_x_mm", 2}};
    f[4].code = base::codes::rapid_in_stock;
    EXPECT_EQ(by_danger(r, check::groups_of(r)), (std::vector<std::size_t>{4, 3, 2, 1, 0}));
}

TEST(PlaceOf, LinesColumnsAndBlocks) {
    const sample::Sample s = sample::make();
    const Place p = place(s.sources, {1, 9, 27});  // the whole line with its line end
    EXPECT_EQ(p.line, 2u);
    EXPECT_EQ(p.column, 1u);
    EXPECT_EQ(p.end_line, 2u);
    EXPECT_EQ(p.end_column, 18u);
    EXPECT_EQ(p.block, 5u);
    EXPECT_TRUE(place(s.sources, check::nowhere).file.empty());
}

}  // namespace
}  // namespace obrys::report
