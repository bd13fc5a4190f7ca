#include "shop/files/siemens/toa.hpp"
#include "shop/reading_testing.hpp"

namespace obrys::shop {
namespace {

TEST(Toa, ToolsAreRead) {
    Reading r;
    const auto tools =
        read_toa(r.add("%_N_TO_INI_TOA\r\n;$PATH=/_N_INITIAL_DIR\r\nCHANDATA(1)\r\n"
                       "$TC_TP1[7]=1\r\n$TC_TP2[7]=\"FINISH;80\" ; comment\r\n"
                       "N10 $TC_DP1[7,1]=510\r\n$tc_dp2[ 7 , 1 ] = 2\r\n$TC_DP3[7,1]=50\r\n$TC_DP12[7,1]=-0.5\r\n"
                       "$TC_DP6[7,1]=0.8\r\n$TC_DP15[7,1]=.1\r\n"
                       "$TC_DP1[9,2]=120\r\n$TC_DP6[9,2]=8\r\n$TC_DP1[3,1]=520\r\nM17\r\n",
                       "A.TOA"),
                 r.sources, r.diagnostics);
    EXPECT_EQ(r.complaints(),
              "A.TOA:4:1: note: not taken from this file: $TC_TP1 (1) [no-effect]\n  $TC_TP1[7]=1\n  ^~~~~~~\n");
    ASSERT_EQ(tools.size(), 3U);
    EXPECT_EQ(tools[0].number, 3U);
    EXPECT_EQ(tools[0].kind, ToolKind::other);  // a grooving tool whose width is not known
    const Tool& t = tools[1];
    EXPECT_EQ(t.number, 7U);
    EXPECT_EQ(t.name, "FINISH;80");
    EXPECT_EQ(t.kind, ToolKind::turning);
    EXPECT_EQ(t.orientation, 2);
    EXPECT_DOUBLE_EQ(t.nose_radius, 0.9);
    EXPECT_DOUBLE_EQ(t.length, 49.5);
    EXPECT_EQ(parameter(t, 6), 0.8);
    EXPECT_EQ(parameter(t, 1), 510);
    EXPECT_EQ(t.assumed, "tip angle 80 degrees, entering angle 95 degrees, edge length 12 mm");
    EXPECT_EQ(tools[2].edge, 2U);
    EXPECT_EQ(tools[2].kind, ToolKind::end_mill);
    EXPECT_EQ(tools[2].radius, 8);
    EXPECT_EQ(tools[2].assumed, "");
}

TEST(Toa, MistakesArePlacedAndTheRestIsRead) {
    Reading r;
    const auto tools = read_toa(r.add("G1 "
                                      "X10\n$TC_DP1[1]=500\n$TC_DP1[0,1]=500\n$TC_DP6[1,1]=0,8\n$TC_DP2[1,1]=10\n$TC_"
                                      "TP2[1]=A\n$MN_X=1\n$TC_DP6[1,2]=4\n",
                                      "A.TOA"),
                                r.sources, r.diagnostics);
    EXPECT_EQ(
        r.complaints(),
        "A.TOA:1:1: error: this is not a line of tool data ($TC_DP1[1,1]=500) [job-file]\n  G1 X10\n  ^~~~~~\n"
        "A.TOA:2:9: error: tool data need a tool and an edge: [T,D] [job-value]\n  $TC_DP1[1]=500\n          ^\n"
        "A.TOA:3:9: error: the tool number is a whole number from 1 to 999999999 [job-value]\n  $TC_DP1[0,1]=500\n     "
        "     ^\n"
        "A.TOA:4:14: error: the value must be a finite number [job-value]\n  $TC_DP6[1,1]=0,8\n               ^~~\n"
        "A.TOA:5:14: error: the cutting edge position ($TC_DP2) is a whole number from 1 to 9 [job-value]\n  "
        "$TC_DP2[1,1]=10\n               ^~\n"
        "A.TOA:6:12: error: a tool name stands in quotes [job-value]\n  $TC_TP2[1]=A\n             ^\n"
        "A.TOA:7:1: error: this is not a name of tool data ($TC_DP1 … $TC_DP25, $TC_TP2) [job-file]\n  $MN_X=1\n  "
        "^~~~~\n");
    ASSERT_EQ(tools.size(), 1U);
    EXPECT_EQ(tools[0].edge, 2U);
}

TEST(Toa, NumbersBeyondEveryIntegerAreRefused) {
    Reading r;
    const std::string huge(100, '1');
    const auto tools =
        read_toa(r.add("$TC_DP1[1,1]=" + huge + "\n$TC_DP2[1,1]=" + huge + "\n$TC_DP1[2,1]=510.5\n$TC_DP1[" + huge +
                           ",1]=510\n$TC_DP1[3,1]=120\n$TC_DP6[3,1]=4\n",
                       "A.TOA"),
                 r.sources, r.diagnostics);
    const std::string said = r.complaints();
    EXPECT_NE(said.find("A.TOA:1:14: error: the tool type ($TC_DP1) is a whole number from 0 to 9999"),
              std::string::npos);
    EXPECT_NE(said.find("A.TOA:2:14: error: the cutting edge position ($TC_DP2)"), std::string::npos);
    EXPECT_NE(said.find("A.TOA:3:14: error: the tool type ($TC_DP1)"), std::string::npos);
    EXPECT_NE(said.find("A.TOA:4:9: error: the tool number is a whole number from 1 to 999999999"), std::string::npos);
    ASSERT_EQ(tools.size(), 1U);
    EXPECT_EQ(tools[0].kind, ToolKind::end_mill);
}

TEST(Tools, AListIsMerged) {
    Reading r;
    std::vector<Tool> tools(1);
    tools[0].number = 7;
    tools[0].kind = ToolKind::groove;
    tools[0].width = 3;
    const auto toa =
        read_toa(r.add("$TC_DP1[7,1]=520\n$TC_TP2[7]=\"G3\"\n$TC_DP1[2,1]=120\n", "A.TOA"), r.sources, r.diagnostics);
    EXPECT_EQ(r.complaints(), "");
    tools = merge_tools(tools, toa);
    ASSERT_EQ(tools.size(), 2U);
    EXPECT_EQ(tools[0].number, 2U);
    EXPECT_EQ(tools[1].kind, ToolKind::groove);
    EXPECT_EQ(tools[1].name, "G3");
    EXPECT_EQ(parameter(tools[1], 1), 520);
}

}  // namespace
}  // namespace obrys::shop
