// Kinds of milling tools that tool tables say.
#include <array>
#include <cmath>
#include <utility>

#include "shop/files/heidenhain/views.hpp"
#include "shop/reading_testing.hpp"

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

}  // namespace
}  // namespace obrys::shop
