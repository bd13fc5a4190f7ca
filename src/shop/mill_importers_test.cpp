// Kinds of milling tools that tables of controls say.
#include <cmath>

#include "shop/linuxcnc_table.hpp"
#include "shop/shop_test.hpp"

namespace obrys::shop {
namespace {

using enum ToolKind;

TEST(ToolT, TypesBecomeKinds) {
    Reading r;
    const auto t = read_tool_t(r.add("BEGIN TOOL .T MM\n"
                                     "T   NAME     L     R     R2    TYP        LCUTS T-ANGLE DOC  TIME1\n"
                                     "1   A        +90   +5    +0    MILL       +22\n"
                                     "2   A        +90   +5    +5    MILL_F     +0            long 20\n"
                                     "3   A        +90   +5    +1    9                        lang\n"
                                     "4   A        +90   +4          DRILL            118\n"
                                     "5   A        +90   +4          1\n"
                                     "6   A        +90   +4          CENT\n"
                                     "7   A        +90   +10         CSINK            60\n"
                                     "8   A        +90   +4          TAP\n"
                                     "9   A        +90   +4          REAM\n"
                                     "10  A        +90   +4          TCHP\n"
                                     "11  A        +90   +4    +4\n"
                                     "12  A        +90   +0          MILL\n"
                                     "13  A        +90   +6          TORUS\n"
                                     "14  A        +90   +6          BALL\n"
                                     "[END]\n",
                                     "TOOL.T"),
                               r.sources, r.diagnostics);
    EXPECT_EQ(r.complaints(),
              "TOOL.T:4:57: note: not taken from this file: DOC (2), TIME1 (1) [no-effect]\n"
              "  2   A        +90   +5    +5    MILL_F     +0            long 20\n"
              "                                                          ^~~~\n");
    ASSERT_EQ(t.size(), 14U);
    const std::array kinds{end_mill, ball,   bull_nose, drill, drill, centre_drill, countersink,
                           tap,      reamer, other,     other, other, end_mill,     ball};
    for (std::size_t i = 0; i < kinds.size(); ++i) EXPECT_EQ(t[i].kind, kinds[i]) << i + 1;
    for (const Tool& tool : t) EXPECT_TRUE(dimension_fault(tool).ok()) << tool.number << dimension_fault(tool).text;
    EXPECT_EQ(t[0].cutting_length, 22);
    EXPECT_FALSE(t[1].cutting_length);  // 0: nothing was entered
    EXPECT_EQ(t[3].assumed, "");
    EXPECT_EQ(t[4].assumed, "tool 5: point angle 118 degrees");
    EXPECT_EQ(t[4].point_angle, 118);
    EXPECT_EQ(t[5].assumed, "tool 6: point angle 90 degrees");
    EXPECT_EQ(t[6].point_angle, 60);
    EXPECT_EQ(assumed_kind(t[10]), ball);  // no TYP: by its R2
    EXPECT_EQ(assumed_kind(t[11]), other);
    EXPECT_EQ(t[13].corner_radius, 6);
}

/// A tool of one type with radius 5, corner radius 1 and length 100.
Tool toa(int type, const std::string& more = "") {
    Reading r;
    const auto t = read_toa(
        r.add("$TC_DP1[1,1]=" + std::to_string(type) + "\n$TC_DP3[1,1]=100\n$TC_DP6[1,1]=5\n$TC_DP7[1,1]=1\n" + more,
              "A.TOA"),
        r.sources, r.diagnostics);
    EXPECT_EQ(r.complaints(), "");
    return t.at(0);
}

TEST(Toa, TypesBecomeKinds) {
    const std::pair<int, ToolKind> all[]{
        {100, bull_nose}, {110, ball},      {111, ball},         {120, end_mill},    {121, bull_nose}, {130, end_mill},
        {131, bull_nose}, {140, bull_nose}, {145, other},        {150, t_slot},      {151, t_slot},    {200, drill},
        {205, drill},     {210, reamer},    {220, centre_drill}, {230, countersink}, {231, end_mill},  {240, tap},
        {241, tap},       {250, reamer},    {700, other},        {500, turning}};
    for (const auto& [type, kind] : all) {
        const Tool t = toa(type);
        EXPECT_EQ(t.kind, kind) << type;
        EXPECT_TRUE(dimension_fault(t).ok()) << type << dimension_fault(t).text;
    }
    EXPECT_EQ(toa(120).corner_radius, 0);  // it is not evaluated for 120
    EXPECT_EQ(toa(121).corner_radius, 1);
    EXPECT_EQ(toa(110).corner_radius, 5);
    EXPECT_EQ(toa(151).width, 1);
    EXPECT_EQ(toa(151).assumed, "neck diameter 5 mm");
    EXPECT_EQ(toa(200).assumed, "point angle 118 degrees");
    EXPECT_EQ(toa(121, "$TC_DP16[1,1]=0.5\n").corner_radius, 1.5);
    EXPECT_EQ(toa(121, "$TC_DP7[1,1]=9\n").kind, ball);  // larger than the radius: no more than a ball
}

TEST(Toa, ConesAndCaps) {
    const Tool cone = toa(155, "$TC_DP11[1,1]=10\n");
    EXPECT_EQ(cone.kind, form);
    ASSERT_EQ(cone.profile.size(), 3U);
    EXPECT_EQ(cone.profile[1].p, (geom::Vec2{5, 0}));
    EXPECT_NEAR(cone.profile[2].p.x, 5 + 100 * std::tan(geom::radians(10)), 1e-12);
    EXPECT_EQ(cone.assumed, "radius 5 mm at the tip, cutting edge up to the height of 100 mm");
    EXPECT_EQ(toa(156, "$TC_DP11[1,1]=10\n").profile.size(), 4U);
    EXPECT_EQ(toa(155, "$TC_DP11[1,1]=90\n").kind, other);
    const Tool cap = toa(111, "$TC_DP7[1,1]=13\n");  // 13 - sqrt(169 - 25) = 1
    EXPECT_EQ(cap.kind, form);
    ASSERT_EQ(cap.profile.size(), 3U);
    EXPECT_NEAR(cap.profile[1].p.y, 1, 1e-12);
    EXPECT_NEAR(4 * std::atan(cap.profile[0].bulge), std::asin(5.0 / 13), 1e-12);
}

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
