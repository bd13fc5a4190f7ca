#include "shop/files/heidenhain/views.hpp"

#include <cmath>

#include "shop/reading_testing.hpp"

namespace obrys::shop {
namespace {

struct ToolTable : Reading {
    HeidenhainTable table;
    explicit ToolTable(const std::string& text, const std::string& name = "TOOL.T") {
        table = read_heidenhain_table(add(text, name), sources, diagnostics);
    }
};

TEST(HeidenhainViews, Tools) {
    ToolTable t(
        "BEGIN TOOL .T MM\n"
        "T     NAME          L        R        R2      DL      DR     DR2    TL RT TIME1 CUR.TIME TYP   LCUTS ANGLE "
        "CUT. T-ANGLE PITCH TMAT     CDT  NMAX\n"
        "5     BALL          +100     +6       +6      -0,1    +0,05  +0.01  L  7  60             MILL  +20   6     2  "
        "                HSS      FR2  8000\n"
        "5.1   BALL          +98.5    +6       +0                            0                    9\n"
        "2     DRILL         +90      +2,5                                                        DRILL                "
        "  118     +0,8\n"
        "3     NOTHING\n"
        "[END]\n");
    const auto tools = tools_of(t.table, t.diagnostics);
    EXPECT_EQ(t.complaints(), "");
    ASSERT_EQ(tools.size(), 4U);
    EXPECT_EQ(tools[0].type, "DRILL");
    EXPECT_EQ(tools[0].point_angle, 118);
    EXPECT_EQ(tools[0].pitch, 0.8);
    EXPECT_EQ(tools[0].corner_radius, 0);
    EXPECT_EQ(tools[0].assumed, "");
    EXPECT_EQ(tools[1].assumed, "tool 3: length 0 mm, radius 0 mm");
    const Tool& ball = tools[2];
    EXPECT_EQ(ball.number, 5U);
    EXPECT_EQ(ball.edge, 1U);
    EXPECT_EQ(ball.kind, ToolKind::ball);
    EXPECT_EQ(ball.length, 100);
    EXPECT_EQ(ball.radius, 6);
    EXPECT_EQ(ball.corner_radius, 6);
    EXPECT_EQ(ball.delta_length, -0.1);
    EXPECT_EQ(ball.delta_radius, 0.05);
    EXPECT_EQ(ball.delta_corner_radius, 0.01);
    EXPECT_EQ(ball.cutting_length, 20);
    EXPECT_EQ(ball.plunge_angle, 6);
    EXPECT_EQ(ball.teeth, 2);
    EXPECT_TRUE(ball.locked);
    EXPECT_EQ(ball.replacement, 7U);
    EXPECT_EQ(ball.cutter_material, "HSS");
    EXPECT_EQ(ball.cutting_data, "FR2");
    EXPECT_EQ(ball.max_speed, 8000);
    EXPECT_EQ(tools[3].number, 5U);
    EXPECT_EQ(tools[3].index, 1U);
    EXPECT_EQ(tools[3].edge, 2U);
    EXPECT_EQ(tools[3].length, 98.5);
    EXPECT_FALSE(tools[3].plunge_angle);
    EXPECT_FALSE(tools[3].locked);
}

TEST(HeidenhainViews, InchAndMistakes) {
    ToolTable t(
        "BEGIN TOOL .T INCH\nT      L        R    DR\n1      +2       +0.5 0\n40000  1        1    1\n2      1x       "
        "+1   0\n3      +123,45678,5 1\n4.10   1        1    0\n6      1        2    0\n[END]\n");
    const auto tools = tools_of(t.table, t.diagnostics);
    EXPECT_EQ(t.complaints(),
              "TOOL.T:4:1: error: row 40000, column T: row numbers go up to 32767.9 [job-value]\n  40000  1        1   "
              " 1\n  ^~~~~\n"
              "TOOL.T:5:8: error: row 2, column L: \"1x\" is not a number [job-value]\n  2      1x       +1   0\n      "
              "   ^~\n"
              "  remedy: write a number like +5 or +5.25\n"
              "TOOL.T:6:8: error: row 3, column L: the value runs over into the next column [job-value]\n  3      "
              "+123,45678,5 1\n         ^~~~~~~~~\n"
              "  remedy: the values stand below the column names\n"
              "TOOL.T:6:17: error: row 3, column R: the value runs over into the next column [job-value]\n  3      "
              "+123,45678,5 1\n                  ^~~~~\n"
              "  remedy: the values stand below the column names\n"
              "TOOL.T:7:1: error: row 4.10, column T: row numbers go up to 32767.9 [job-value]\n  4.10   1        1    "
              "0\n  ^~~~\n");
    ASSERT_EQ(tools.size(), 4U);
    EXPECT_DOUBLE_EQ(tools[0].length, 50.8);
    EXPECT_DOUBLE_EQ(tools[0].radius, 12.7);
    EXPECT_EQ(tools.back().number, 6U);
    ToolTable columns("BEGIN TOOL .T MM\nT  NAME\n1  A\n[END]\n");
    EXPECT_TRUE(tools_of(columns.table, columns.diagnostics).empty());
    EXPECT_EQ(columns.diagnostics.all().at(0).text, "the table has no column L");
    EXPECT_EQ(columns.diagnostics.all().at(0).remedy, "its columns are: T NAME");
}

TEST(HeidenhainViews, Pockets) {
    ToolTable t(
        "BEGIN TOOL_P .TCH MM\nP     T      TNAME   ST F L PLC\n0     5      BALL         \n1     7              S  F "
        "L %00000000\n2.13\n[END]\n");
    const auto p = pockets_of(t.table, t.diagnostics);
    EXPECT_EQ(t.complaints(), "");
    ASSERT_EQ(p.size(), 3U);
    EXPECT_EQ(p[0].tool, 5U);
    EXPECT_EQ(p[0].tool_name, "BALL");
    EXPECT_FALSE(p[0].special || p[0].fixed || p[0].locked);
    EXPECT_TRUE(p[1].special && p[1].fixed && p[1].locked);
    EXPECT_EQ(p[2].magazine, 2U);
    EXPECT_EQ(p[2].pocket, 13U);
    EXPECT_FALSE(p[2].tool);
}

TEST(HeidenhainViews, DatumsAndPresets) {
    ToolTable t(
        "BEGIN NULL .D MM\nD    X          Y          Z          C          W     DOC\n0    +0         +0         "
        "+0\n12   +25,5      -12.25                +90        +3    links\n[END]\n",
        "NULL.D");
    const auto d = datums_of(t.table, t.diagnostics);
    EXPECT_EQ(t.complaints(), "");
    ASSERT_EQ(d.size(), 2U);
    EXPECT_EQ(d.at(12).position.x, 25.5);
    EXPECT_EQ(d.at(12).position.y, -12.25);
    EXPECT_TRUE(std::isnan(d.at(12).position.z));
    EXPECT_TRUE(std::isnan(d.at(12).rotary[0]));
    EXPECT_DOUBLE_EQ(d.at(12).rotary[2], geom::pi / 2);
    EXPECT_EQ(d.at(12).secondary[2], 3);
    EXPECT_EQ(d.at(12).comment, "links");
    EXPECT_EQ(d.at(0).rotation, 0);
    ToolTable p(
        "BEGIN PRESET .PR MM\nNR  DOC    ROT     X       Y\n1   Z 3    -45     +1      -\n2   bad    4x      +1      "
        "+2\n[END]\n",
        "PRESET.PR");
    const auto presets = datums_of(p.table, p.diagnostics);
    EXPECT_DOUBLE_EQ(presets.at(1).rotation, -geom::pi / 4);
    EXPECT_TRUE(std::isnan(presets.at(1).position.y));
    EXPECT_TRUE(std::isnan(presets.at(2).rotation));
    EXPECT_EQ(p.diagnostics.all().size(), 1U);
}

TEST(HeidenhainViews, Points) {
    ToolTable t(
        "BEGIN A .PNT MM\nNR   X     Y     Z     FADE CLEARANCE\n0    +10   +20   +0    N    +50\n1    +11   +21       "
        "  Y\n[END]\n",
        "A.PNT");
    const auto p = points_of(t.table, t.diagnostics);
    ASSERT_EQ(p.size(), 2U);
    EXPECT_EQ(p[0].position.x, 10);
    EXPECT_FALSE(p[0].hidden);
    EXPECT_EQ(p[0].clearance, 50);
    EXPECT_TRUE(p[1].hidden);
    EXPECT_TRUE(std::isnan(p[1].position.z));
    EXPECT_TRUE(std::isnan(p[1].clearance));
}

TEST(HeidenhainViews, CuttingData) {
    ToolTable t(
        "BEGIN A.CDT\nNR  WMAT      TMAT       Vc1   F1    Vc2   F2\n0   St 33-1   HSSE/TiN   40    0,016 55\n1   C 15 "
        "     HC-P35     70    0,040 100   0,050\n[END]\n",
        "A.CDT");
    const auto all = cutting_data_of(t.table, t.diagnostics);
    EXPECT_EQ(t.complaints(), "");
    const auto pair = find_cutting_data(all, "c 15", "HC-P35", 2);
    ASSERT_TRUE(pair);
    EXPECT_EQ(pair->speed, 100);
    EXPECT_EQ(pair->feed, 0.05);
    EXPECT_TRUE(find_cutting_data(all, "St 33-1", "HSSE/TiN"));
    EXPECT_FALSE(find_cutting_data(all, "St 33-1", "HSSE/TiN", 2));
    EXPECT_FALSE(find_cutting_data(all, "St 33-1", "HSSE/TiN", 3));
    EXPECT_FALSE(find_cutting_data(all, "C 15", "HSS"));
    Tool tool;
    tool.radius = 5;
    tool.teeth = 4;
    const SpindleAndFeed s = spindle_and_feed({.speed = 100, .feed = 0.05}, tool);
    EXPECT_NEAR(s.speed, 3183.0988618379069, 1e-9);  // 100 m/min on a circumference of 31.4159 mm
    EXPECT_NEAR(s.feed, 636.61977236758138, 1e-9);
    EXPECT_TRUE(std::isnan(spindle_and_feed({.speed = 100, .feed = 0.05}, Tool{}).speed));
    ToolTable w("BEGIN WMAT.TAB\nNR  NAME      DOC\n0   St 33-1   Baustahl\n1\n[END]\n", "WMAT.TAB");
    const auto m = materials_of(w.table);
    ASSERT_EQ(m.size(), 1U);
    EXPECT_EQ(m[0].comment, "Baustahl");
}

}  // namespace
}  // namespace obrys::shop
