#include "shop/files/linuxcnc/table.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include "shop/reading_testing.hpp"

namespace obrys::shop {
namespace {

struct TblTable : Reading {
    LinuxcncTable table;
    explicit TblTable(const std::string& text) {
        table = read_linuxcnc_table(add(text, "tool.tbl"), sources, diagnostics);
    }
    std::vector<Tool> tools(double mm_per_unit = 1) { return tools_of(table, mm_per_unit, diagnostics); }
};

const std::string mill =
    "; head\r\n"
    "T1 P7 X1 Y2 Z3.5 A4 B5 C6 U7 V8 W9 D10 ; Fr\xC3\xA4ser; 10 mm \r\n"
    "\r\n"
    " q0.000000 d.5 z-1.5E1 p2 t3;drill\r\n"
    "T0 P0 ;no tool\r\n";

TEST(LinuxcncTable, WordsInAnyOrder) {
    TblTable t(mill);
    const auto tools = t.tools();
    EXPECT_EQ(t.complaints(), "");
    ASSERT_EQ(tools.size(), 2U);
    EXPECT_EQ(tools[0].number, 1U);
    EXPECT_EQ(tools[0].name, "Fr\xC3\xA4ser; 10 mm");
    EXPECT_EQ(tools[0].kind, ToolKind::other);
    EXPECT_EQ(tools[0].radius, 5);
    EXPECT_EQ(tools[0].length, 3.5);
    EXPECT_EQ(tools[0].assumed, "");
    ASSERT_TRUE(tools[0].table);
    EXPECT_EQ(tools[0].table->offset, (std::array<double, 9>{1, 2, 3.5, 4, 5, 6, 7, 8, 9}));
    EXPECT_EQ(tools[0].table->pocket, 7);
    EXPECT_EQ(tools[1].number, 3U);
    EXPECT_EQ(tools[1].name, "drill");
    EXPECT_EQ(tools[1].length, -15);
    EXPECT_EQ(tools[1].radius, 0.25);
    EXPECT_EQ(t.sources.position(tools[1].where).line, 4U);
    EXPECT_EQ(find_line(t.table, 3), 3U);
    EXPECT_EQ(find_line(t.table, 0), 4U);
    EXPECT_FALSE(find_line(t.table, 2));
}

TEST(LinuxcncTable, LengthsAreConvertedAnglesNot) {
    TblTable t("T1 P1 X1 A30 W-2 D.5 Z.1 I95 J155 Q1\n");
    const auto tools = t.tools(25.4);
    ASSERT_EQ(tools.size(), 1U);
    EXPECT_DOUBLE_EQ(tools[0].nose_radius, 6.35);
    EXPECT_DOUBLE_EQ(tools[0].length, 2.54);
    const TableTool& row = *tools[0].table;
    EXPECT_DOUBLE_EQ(row.diameter, 12.7);
    EXPECT_DOUBLE_EQ(row.offset[0], 25.4);
    EXPECT_EQ(row.offset[3], 30);
    EXPECT_DOUBLE_EQ(row.offset[8], -50.8);
    EXPECT_EQ(row.front_angle, 95);
    EXPECT_EQ(row.back_angle, 155);
    EXPECT_EQ(row.orientation, 1);
}

/// The place in the control's list as `rs274` names it in CHANGE_TOOL: every P counts, also of lines it passes over.
TEST(LinuxcncTable, IndexCountsEveryPocket) {
    TblTable t("T1 P1\nT2 P2\nT4 P4 Z\nT6 P6 K3\nT8 D1\nT9 P9\nP13 D1\nT14 P14\n");
    std::string seen;
    for (const Tool& tool : t.tools())
        seen += std::to_string(tool.number) + "@" + std::to_string(tool.table->index) + " ";
    EXPECT_EQ(seen, "1@1 2@2 9@5 14@7 ");
}

/// Corner of the outline's nose: where the cutting part lies as seen from the programmed point, and along which
/// directions (degrees from +Z towards +X) its straight edges leave the nose.
struct Shape {
    double z = 0, x = 0;
    std::vector<double> edges;
};

Shape shape_of(const Tool& t) {
    const geom::Contour c = outline(t);
    Shape s;
    for (std::size_t i = 0; i < c.vertices.size(); ++i) {
        const geom::Vec2 a = c.vertices[i].p, b = c.vertices[(i + 1) % c.vertices.size()].p;
        s.z += a.x / static_cast<double>(c.vertices.size());
        s.x += a.y / static_cast<double>(c.vertices.size());
        const double length = std::hypot(b.x - a.x, b.y - a.y);
        if (c.vertices[i].bulge != 0 || std::abs(length - t.edge_length) > 1e-9) continue;
        const bool outwards = std::hypot(b.x, b.y) > std::hypot(a.x, a.y);
        const double sign = outwards ? 1 : -1;
        double angle = std::atan2(sign * (b.y - a.y), sign * (b.x - a.x)) * 180 / geom::pi;
        if (angle < -1e-9) angle += 360;
        s.edges.push_back(angle);
    }
    std::sort(s.edges.begin(), s.edges.end());
    return s;
}

/// The nine orientations with the angles that LinuxCNC's sample table lathe.tbl has. The outline must lie on the side
/// that the orientation names and its edges must leave in the directions I and J, whatever they are called on the way.
TEST(LinuxcncTable, LatheToolsPointWhereTheTableSays) {
    struct Case {
        int q;
        double i, j, z, x;
    };
    for (const Case& c :
         {Case{1, 95, 155, -1, 1}, Case{2, 85, 25, 1, 1}, Case{3, 275, 335, 1, -1}, Case{4, 265, 205, -1, -1},
          Case{5, 210, 150, -1, 0}, Case{6, 120, 60, 0, 1}, Case{7, -30, 30, 1, 0}, Case{8, 240, 300, 0, -1}}) {
        TblTable t("T1 P1 D0.8 I" + std::to_string(c.i) + " J" + std::to_string(c.j) + " Q" + std::to_string(c.q) +
                   "\n");
        const auto tools = t.tools();
        ASSERT_EQ(tools.size(), 1U);
        EXPECT_EQ(tools[0].kind, ToolKind::turning);
        EXPECT_EQ(tools[0].assumed, "edge length 12 mm") << c.q;
        const Shape s = shape_of(tools[0]);
        const auto side = [](double v) { return std::abs(v) < 1e-9 ? 0.0 : v > 0 ? 1.0 : -1.0; };
        EXPECT_EQ(side(s.z), c.z) << "Q" << c.q;
        EXPECT_EQ(side(s.x), c.x) << "Q" << c.q;
        const auto turn = [](double a) { return a < 0 ? a + 360 : a; };
        std::vector<double> expected{turn(c.i), turn(c.j)};
        std::sort(expected.begin(), expected.end());
        ASSERT_EQ(s.edges.size(), 2U);
        EXPECT_NEAR(s.edges[0], expected[0], 1e-9) << "Q" << c.q;
        EXPECT_NEAR(s.edges[1], expected[1], 1e-9) << "Q" << c.q;
    }
}

TEST(LinuxcncTable, WhatALatheToolDoesNotSayIsAssumed) {
    TblTable t("T1 P1 D0.8 Q2\nT2 P2 D0.8 Q6\nT3 P3 Q9 D2\nT4 P4 Q2 I10 J350\n");
    const auto tools = t.tools();
    ASSERT_EQ(tools.size(), 4U);
    EXPECT_EQ(tools[0].assumed, "tip angle 80 degrees, entering angle 95 degrees, edge length 12 mm");
    EXPECT_EQ(tools[1].assumed, "tip angle 80 degrees, entering angle 50 degrees, edge length 12 mm");
    EXPECT_EQ(tools[2].orientation, 9);
    EXPECT_EQ(tools[2].nose_radius, 1);
    EXPECT_EQ(tools[3].tip_angle, 80);  // 10 and 350 degrees enclose no insert of that orientation
    EXPECT_EQ(t.complaints(), "");
}

TEST(LinuxcncTable, ColumnsOfOldFiles) {
    TblTable mills(
        "TOOLNO POCKET LENGTH DIAMETER COMMENT\n\n  1  2  +0.511000 0.125 1/8 end mill\n20 21\t4.299\t1.0\n");
    auto tools = mills.tools(25.4);
    ASSERT_EQ(tools.size(), 2U);
    EXPECT_EQ(tools[0].name, "1/8 end mill");
    EXPECT_EQ(tools[0].table->pocket, 2);
    EXPECT_DOUBLE_EQ(tools[0].length, 0.511 * 25.4);
    EXPECT_DOUBLE_EQ(tools[0].radius, 0.125 * 12.7);
    EXPECT_EQ(tools[1].name, "");
    ASSERT_EQ(mills.diagnostics.all().size(), 1U);
    EXPECT_EQ(mills.diagnostics.all()[0].text, "a tool table in columns, as LinuxCNC before 2.4 wrote it");
    EXPECT_EQ(mills.diagnostics.all()[0].severity, base::Severity::warning);
    TblTable lathes("POC FMS ZOFFSET XOFFSET DIAM FRONT BACK ORIENT COMMENT\n3 4 1.5 -2 0.8 85 25 2 ;finish\n");
    tools = lathes.tools();
    ASSERT_EQ(tools.size(), 1U);
    EXPECT_EQ(tools[0].number, 3U);
    EXPECT_EQ(tools[0].name, "finish");
    EXPECT_EQ(tools[0].table->offset[0], -2);
    EXPECT_EQ(tools[0].table->offset[2], 1.5);
    EXPECT_EQ(tools[0].nose_radius, 0.4);
    EXPECT_EQ(tools[0].tip_angle, 60);
    EXPECT_EQ(tools[0].entering_angle, 95);
}

TEST(LinuxcncTable, MistakesArePlacedAndTheRestIsRead) {
    TblTable t(
        "T1 P1 Dx\nT2 P2 K3\nT3.5 P3\nT4\nP5 D1\nT17P17 D3\n12 text\nT6 P6 Z+-5\nT7 P7 D1 D2\nT7 P8\nT-1 P1\nT9\tP9 "
        "Q12\n"
        "T10 P10 Z1e999\n");
    const auto tools = t.tools();
    EXPECT_EQ(
        t.complaints(),
        "tool.tbl:1:7: error: D needs a number [job-value]\n  T1 P1 Dx\n        ^~\n"
        "  remedy: LinuxCNC reads as far as it understands, or passes over the line\n"
        "tool.tbl:2:7: error: \"K3\" is no word of a tool table [job-value]\n  T2 P2 K3\n        ^~\n"
        "  remedy: the letters are T P X Y Z A B C U V W D I J Q, a comment begins with ;\n"
        "tool.tbl:3:1: error: T needs a whole number [job-value]\n  T3.5 P3\n  ^~~~\n"
        "  remedy: LinuxCNC reads as far as it understands, or passes over the line\n"
        "tool.tbl:4:1: error: T4 has no pocket [job-value]\n  T4\n  ^~\n"
        "  remedy: write P and a number: without it the tool does not come into LinuxCNC's list\n"
        "tool.tbl:5:1: error: the tool has no number [job-value]\n  P5 D1\n  ^~~~~\n  remedy: write T and its number\n"
        "tool.tbl:6:1: error: T needs a whole number [job-value]\n  T17P17 D3\n  ^~~~~~\n"
        "  remedy: LinuxCNC reads as far as it understands, or passes over the line\n"
        "tool.tbl:7:1: error: this is no line of a tool table [job-value]\n  12 text\n  ^~~~~~~\n"
        "  remedy: a tool is written T1 P1 D6.0 Z-20.5 ; comment\n"
        "tool.tbl:8:7: error: Z needs a number [job-value]\n  T6 P6 Z+-5\n        ^~~~\n"
        "  remedy: LinuxCNC reads as far as it understands, or passes over the line\n"
        "tool.tbl:9:10: warning: the line has two words D [job-file]\n  T7 P7 D1 D2\n           ^~\n"
        "  remedy: the last one counts\n"
        "tool.tbl:10:1: warning: T7 is already there [job-file]\n  T7 P8\n  ^~~~~\n  remedy: the first line counts\n"
        "tool.tbl:11:1: error: a tool number is 0 or more [job-value]\n  T-1 P1\n  ^~~~~~\n"
        "tool.tbl:12:3: warning: a tab between the words of a tool [job-file]\n  T9 P9 Q12\n    ^\n"
        "  remedy: LinuxCNC parts words at blanks only: write a blank\n"
        "tool.tbl:13:9: error: Z needs a number [job-value]\n  T10 P10 Z1e999\n          ^~~~~~\n"
        "  remedy: LinuxCNC reads as far as it understands, or passes over the line\n"
        "tool.tbl:12:7: error: the orientation Q of a lathe tool is 1 to 9, or 0 for none [job-value]\n"
        "  T9 P9 Q12\n        ^~~\n");
    ASSERT_EQ(tools.size(), 2U);
    EXPECT_EQ(tools[0].number, 7U);
    EXPECT_EQ(tools[0].radius, 1);
    EXPECT_EQ(tools[1].number, 9U);
    EXPECT_EQ(tools[1].kind, ToolKind::other);
}

TEST(LinuxcncTable, OneWordChangesAlone) {
    TblTable t(mill);
    EXPECT_EQ(set_field(t.table, 1, 'Z', -20.25), std::nullopt);
    EXPECT_EQ(set_field(t.table, 3, 'D', 12), std::nullopt);
    EXPECT_EQ(set_field(t.table, 3, 'X', 0.125), std::nullopt);
    EXPECT_EQ(set_field(t.table, 3, 'Z', 1), std::nullopt);
    EXPECT_EQ(write_linuxcnc_table(t.table),
              "; head\r\nT1 P7 X1 Y2 Z-20.25 A4 B5 C6 U7 V8 W9 D10 ; Fr\xC3\xA4ser; 10 mm \r\n\r\n"
              " q0.000000 d12 z1 p2 t3 X0.125;drill\r\nT0 P0 ;no tool\r\n");
    EXPECT_EQ(comment_of(t.table.lines[3]), "drill");
    EXPECT_EQ(set_field(t.table, 3, 'T', 1).value_or(""), "T1 is already there");
    EXPECT_EQ(set_field(t.table, 3, 'T', 3), std::nullopt);
    EXPECT_TRUE(set_field(t.table, 0, 'D', 1));
    EXPECT_TRUE(set_field(t.table, 9, 'D', 1));
    EXPECT_TRUE(set_field(t.table, 1, 'K', 1));
    EXPECT_TRUE(set_field(t.table, 1, 'Q', 1.5));
    EXPECT_TRUE(set_field(t.table, 1, 'D', std::numeric_limits<double>::quiet_NaN()));
    TblTable old("1 2 +0.5 0.25 ;c\n");
    EXPECT_EQ(set_field(old.table, 0, 'Z', 2), std::nullopt);
    EXPECT_EQ(write_linuxcnc_table(old.table), "1 2 +2 0.25 ;c\n");
    EXPECT_EQ(comment_of(old.table.lines[0]), "c");
    EXPECT_EQ(set_field(old.table, 0, 'X', 2).value_or(""), "the table has no column for X");
}

TEST(LinuxcncTable, ToolsAreAdded) {
    TblTable t("T1 P1\r\n; end");
    EXPECT_EQ(add_tool(t.table, 5, 3), std::nullopt);
    EXPECT_TRUE(add_tool(t.table, 1, 4));
    EXPECT_TRUE(add_tool(t.table, -2, 4));
    EXPECT_EQ(set_field(t.table, 1, 'D', 6), std::nullopt);
    EXPECT_EQ(write_linuxcnc_table(t.table), "T1 P1\r\nT5 P3 D6\r\n; end");
    TblTable open("T1 P1");
    EXPECT_EQ(add_tool(open.table, 2, 2), std::nullopt);
    EXPECT_EQ(write_linuxcnc_table(open.table), "T1 P1\nT2 P2");
    TblTable none("");
    EXPECT_EQ(add_tool(none.table, 2, 2), std::nullopt);
    EXPECT_EQ(write_linuxcnc_table(none.table), "T2 P2\n");
    EXPECT_EQ(none.tools().at(0).where, (base::Span{0, 0, 0}));
}

/// Any bytes come back.
RC_GTEST_PROP(LinuxcncTable, AnyTextComesBack, (const std::string& noise)) {
    RC_PRE(!noise.starts_with("\xEF\xBB\xBF"));  // the byte order mark is dropped by base::Sources
    const std::string alphabet[] = {"T1 P1",   "\r\n",     "\n", "\r",      " D6", " ;c",
                                    "1 2 3 4", " 5 6 7 8", "\t", "POC A B", "Z",   "\xE4"};
    std::string text = noise;
    for (int i = *rc::gen::inRange(0, 20); i > 0; --i)
        text += alphabet[*rc::gen::inRange<std::size_t>(0, std::size(alphabet))];
    TblTable t(text);
    RC_ASSERT(write_linuxcnc_table(t.table) == text);
    (void)t.tools();
}

/// A value that is set is read again as it was set, and no other value or comment of the table changes by it.
RC_GTEST_PROP(LinuxcncTable, WhatIsSetIsReadAgain, ()) {
    TblTable t(*rc::gen::element(mill, std::string("1 2 +0.5 0.25 ;c\n3 4 1 -2 0.8 85 25 2 finish\n")));
    const auto line = *rc::gen::inRange<std::size_t>(0, t.table.lines.size());
    const char letter = *rc::gen::elementOf(std::string("XYZABCUVWDIJ"));
    const double value = *rc::gen::inRange(-1'000'000, 1'000'000) / 4096.0;
    LinuxcncTable after = t.table;
    const auto problem = set_field(after, line, letter, value);
    if (problem) RC_ASSERT(write_linuxcnc_table(after) == write_linuxcnc_table(t.table));
    const TblTable again(write_linuxcnc_table(after));
    RC_ASSERT(again.table.lines.size() == t.table.lines.size());
    for (std::size_t i = 0; i < again.table.lines.size(); ++i) {
        RC_ASSERT(comment_of(again.table.lines[i]) == comment_of(t.table.lines[i]));
        RC_ASSERT(comment_of(after.lines[i]) == comment_of(t.table.lines[i]));
        for (const char l : std::string_view("TPXYZABCUVWDIJQ")) {
            const auto expected =
                !problem && i == line && l == letter ? std::optional(value) : value_of(t.table.lines[i], l);
            RC_ASSERT(value_of(again.table.lines[i], l) == expected);
            RC_ASSERT(value_of(after.lines[i], l) == expected);
        }
    }
}

}  // namespace
}  // namespace obrys::shop
