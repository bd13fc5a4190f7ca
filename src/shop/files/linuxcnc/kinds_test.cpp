// Kinds of milling tools that the comments of a table say.
#include <array>
#include <cmath>
#include <utility>

#include "shop/files/linuxcnc/table.hpp"
#include "shop/reading_testing.hpp"

namespace obrys::shop {
namespace {

using enum ToolKind;

TEST(Tbl, TheKindIsWhatTheCommentPlainlySays) {
    Reading r;
    const auto t = read_tbl(
        r.add("T1 P1 D6 ;6 mm end mill, 2 flutes\nT2 P2 D6 ;Ball nose 6\nT3 P3 D5 ;#7 drill\nT4 P4 D6 ;spot drill\n"
              "T5 P5 D6 ;tap M6\nT6 P6 D6 ;drill and tap\nT7 P7 D6 ;drilling\nT8 P8 D6 ;12mm\nT9 P9 D6 ;ball end mill\n"
              "T10 P10 ;end mill\nT11 P11 D8 ;reamer\nT12 P12 D8 ;chamfer tool\nT13 P13 D9 ;center drill\n",
              "tool.tbl"),
        r.sources, 1, r.diagnostics);
    EXPECT_EQ(r.complaints(), "");
    const std::array kinds{end_mill, ball, drill, centre_drill, tap,     other,       other,
                           other,    ball, other, reamer,       chamfer, centre_drill};
    ASSERT_EQ(t.size(), kinds.size());
    for (std::size_t i = 0; i < kinds.size(); ++i) EXPECT_EQ(t[i].kind, kinds[i]) << t[i].name;
    for (const Tool& tool : t) EXPECT_TRUE(dimension_fault(tool).ok()) << tool.number;
    EXPECT_EQ(assumed_kind(t[7]), end_mill);
    EXPECT_EQ(t[2].assumed, "point angle 118 degrees");
    EXPECT_EQ(t[7].assumed, "");
}

}  // namespace
}  // namespace obrys::shop
