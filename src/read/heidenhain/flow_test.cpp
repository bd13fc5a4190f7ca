#include <gtest/gtest.h>

#include "read/heidenhain/reading.hpp"

/// Q parameter functions, labels, calls, tools.
namespace obrys::read::heidenhain {

using program::Function;
using program::Modal;
using program::SystemVariable;
using testing::complaint;
using testing::f;
using testing::modal;
using testing::one;
using testing::Reading;

namespace {
std::string system(const std::string& words, program::SystemVariable v, const std::string& index) {
    return "SYSREAD " + words + "#" + std::to_string(static_cast<int>(v)) + index;
}
}  // namespace

TEST(KlartextFunction, ArithmeticOfFn) {
    EXPECT_EQ(one("FN 0: Q5 = +10"), "Q5=10");
    EXPECT_EQ(one("FN0:Q5=-Q10"), "Q5=(neg Q10)");
    EXPECT_EQ(one("FN 1: Q1 = -Q2 + -5"), "Q1=((neg Q2) + -5)");
    EXPECT_EQ(one("FN 2: Q1 = +10 - +5"), "Q1=(10 - 5)");
    EXPECT_EQ(one("FN 3: Q2 = +3 * +3"), "Q2=(3 * 3)");
    EXPECT_EQ(one("FN 4: Q4 = +8 DIV +Q8"), "Q4=(8 / Q8)");
    EXPECT_EQ(one("FN 5: Q20 = SQRT 4"), "Q20=" + f(Function::sqrt, "4"));
    EXPECT_EQ(one("FN 6: Q20 = SIN-Q5"), "Q20=" + f(Function::sin, "(neg Q5)"));
    EXPECT_EQ(one("FN 7: Q21 = COS-Q5"), "Q21=" + f(Function::cos, "(neg Q5)"));
    EXPECT_EQ(one("FN 8: Q10 = +5 LEN +4"), "Q10=" + f(Function::root_of_squares, "5,4"));
    EXPECT_EQ(one("FN 13: Q20 = +10 ANG-Q1"), "Q20=" + f(Function::angle_of, "10,(neg Q1)"));
    EXPECT_EQ(one("FN 14: ERROR = 1005"), "procedure 1(1005)");
    EXPECT_EQ(one("FN 18: SYSREAD Q99 = ID50 NR3 IDXQ99"),
              "Q99=" + system("ID50 NR3 IDXQ99", SystemVariable::table_corner_radius, "[Q99]"));
    EXPECT_EQ(one("FN 18: SYSREAD Q99 = ID20 NR1"), "Q99=" + system("ID20 NR1", SystemVariable::tool_number, ""));
}

TEST(KlartextFunction, Jumps) {
    const std::string none = "jump either \"5\" if ";
    EXPECT_EQ(one("FN 9: IF +Q1 EQU +Q3 GOTO LBL 5"), none + "(Q1 == Q3)");
    EXPECT_EQ(one("FN 10: IF +10 NE -Q5 GOTO LBL 5"), none + "(10 <> (neg Q5))");
    EXPECT_EQ(one("FN 11: IF+Q1 GT+10 GOTO LBL 5"), none + "(Q1 > 10)");
    EXPECT_EQ(one("FN 12: IF +Q5 LT +0 GOTO LBL 5"), none + "(Q5 < 0)");
    EXPECT_EQ(one("FN 9: IF +0 EQU +0 GOTO LBL \"END\""), "jump either \"END\" if (0 == 0)");
    EXPECT_EQ(one("FN 9: IF +0 EQU +0 GOTO LBL QS3"), "jump either QS3 if (0 == 0)");
    EXPECT_EQ(complaint("FN 9: IF +Q1 NE +Q3 GOTO LBL 5"), "'EQU' is due here, found 'NE'");
    EXPECT_EQ(complaint("FN 9: IF +Q1 EQU +Q3 LBL 5"), "'GOTO' is due here, found 'LBL'");
    EXPECT_EQ(complaint("FN 9: IF +Q1 EQU GOTO LBL 5"), "a number or a Q parameter is missing here, found 'GOTO'");
}

TEST(KlartextFunction, Mistakes) {
    EXPECT_EQ(complaint("FN : Q1 = 5"), "FN needs the number of a function");
    EXPECT_EQ(complaint("FN 0: X = 5"), "a Q parameter is due here, found 'X'");
    EXPECT_EQ(complaint("FN 4: Q1 = +5 / +3"), "'DIV' is due here, found '/'");
    EXPECT_EQ(complaint("FN 1: Q1 = +5 +"), "a number or a Q parameter is missing here, found end of block");
    EXPECT_EQ(one("FN 23: Q1 = CDATA Q5"), "unsupported{FN 23: Q1 = CDATA Q5|circle through 3 points}");
    EXPECT_EQ(one("FN 45: X"), "unknown{FN 45: X|the control has no FN 45}");
}

TEST(KlartextFunction, AMistakeStandsInItsOwnBlock) {
    for (const char* wrong : {"FN 9: IF +Q1", "CALL LBL", "CALL PGM", "FN 14: ERROR = X", "CALL X", "RND", "LBL"}) {
        const Reading r(std::string("1 FN 9: IF +0 EQU +0 GOTO LBL 5\n2 ") + wrong + "\n3 LBL 5\n");
        ASSERT_EQ(r.unit.statements.size(), 3u) << wrong;
        EXPECT_EQ(r.unit.words_end(0), 1u) << wrong << "\n" << r.tree();
        EXPECT_EQ(r.codes(), std::vector<std::string>{"syntax"}) << wrong;
    }
}

TEST(KlartextFunction, AcceptedOnesAreListedOnly) {
    const Reading r("FN 19: PLC=+10/+Q3\nFN 19: PLC=+1/+2\nFN 38: SEND /\"x\"\n");
    EXPECT_EQ(r.messages(), "");
    EXPECT_EQ(r.unit.words.size(), 0u);
    ASSERT_EQ(r.unit.ignored.size(), 2u);
    EXPECT_EQ(r.unit.ignored[0].count, 2u);
}

TEST(KlartextLabel, NumbersNamesAndTheirCalls) {
    const Reading r("1 CALL LBL 5\n2 CALL LBL \"POS a\" REP 3\n3 LBL 5\n4 LBL \"POS a\"\n5 LBL 0\n");
    EXPECT_EQ(r.messages(), "");
    EXPECT_EQ(r.tree(), "0 call \"5\" ->2\n1 call \"POS a\" ->3 rep 3\n2 \n3 \n4 label-end\n");
    EXPECT_EQ(one("CALL LBL 2 REP"), "call \"2\"");
    EXPECT_EQ(one("CALL LBL 2 REP5"), "call \"2\" rep 5");
    EXPECT_EQ(one("CALL LBL 2 REP 5/5"), "call \"2\" rep 5");
    EXPECT_EQ(one("CALL LBL 2 REPQ5"), "call \"2\" rep Q5");
    EXPECT_EQ(one("CALL LBL QS5"), "call QS5");
    EXPECT_EQ(one("LBL 0"), "label-end");
    EXPECT_EQ(one("LBL 007"), "");
}

TEST(KlartextLabel, Mistakes) {
    EXPECT_EQ(Reading("1 LBL 5\n2 LBL 5\n").messages(),
              "TEST.H:2:7: error: the label 5 is there twice in this program [syntax]\n  2 LBL 5\n"
              "        ^\n  remedy: give one of them another number\n");
    EXPECT_EQ(complaint("LBL QS5"), "a label needs a fixed number or name here");
    EXPECT_EQ(complaint("LBL"), "a label is due here, found end of block");
    EXPECT_EQ(complaint("LBL X"), "a label is due here, found 'X'");
    for (const char* number : {"5.5", "65535", "99999999999999999999", "1E300"})
        EXPECT_EQ(complaint(std::string("LBL ") + number), "a label is a whole number up to 65534") << number;
    EXPECT_EQ(complaint("LBL \"\""), "a label's name is empty");
    EXPECT_EQ(complaint("LBL \"A"), "this text has no closing quote");
}

TEST(KlartextCall, Programs) {
    EXPECT_EQ(one("CALL PGM TNC:\\dir\\part.H"), "call PART");
    EXPECT_EQ(one("CALL PGM part ; comment"), "call PART");
    EXPECT_EQ(one("CALL PGM QS5"), "indirect QS5");
    EXPECT_EQ(complaint("CALL PGM"), "the name of a program is due behind CALL PGM");
}

TEST(KlartextTool, Calls) {
    const std::string z = modal(Modal::plane_xy), y = modal(Modal::plane_zx), x = modal(Modal::plane_yz);
    EXPECT_EQ(one("TOOL CALL 5 Z S2500"), "T5 tool-change " + z + " S2500");
    EXPECT_EQ(one("TOOL CALL 5.2 Y S2500 F350 DL+0,2 DR-1 DR2+0,05"),
              "T5.2 tool-change " + y + " S2500 F350 DL0.2 DR-1 DR20.05");
    EXPECT_EQ(one("TOOL CALL 5 X DR2:+0,05"), "T5 tool-change " + x + " DR20.05");
    EXPECT_EQ(one("TOOL CALL \"MILL D10\" Z SQ5"), "T=\"MILL D10\" tool-change " + z + " S=Q5");
    EXPECT_EQ(one("TOOL CALL Q5 Z"), "T=Q5 tool-change " + z);
    EXPECT_EQ(one("TOOL CALL QS5 Z"), "T=QS5 tool-change " + z);
    EXPECT_EQ(one("TOOL CALL S500"), "tool-change S500");
    EXPECT_EQ(one("TOOL CALL Z S500"), "tool-change " + z + " S500");
    EXPECT_EQ(one("TOOL CALL 0 Z"), "T0 tool-change " + z);
    EXPECT_EQ(one("TOOL CALL 1 Z S100 FZ0.1"), "T1 tool-change " + z + " S100 FZ0.1");
    EXPECT_EQ(complaint("TOOL CALL 5 Z G5"), "this is no word of TOOL CALL: 'G5'");
    EXPECT_EQ(complaint("TOOL CALL 5 Z DX5"), "DL, DR or DR2 is due here, found 'DX5'");
}

TEST(KlartextTool, Definitions) {
    EXPECT_EQ(one("TOOL DEF 114 L+1.000 R+0.000"), "T114 tool-definition length1 radius0");
    EXPECT_EQ(one("TOOL DEF 5 L+10 R+5 ; mill"), "T5 tool-definition length10 radius5");
    EXPECT_EQ(one("TOOL DEF 5 RQ5"), "T5 tool-definition radius=Q5");
    EXPECT_EQ(one("TOOL DEF 5"), "T5 tool-definition") << "makes it ready";
    EXPECT_EQ(complaint("TOOL DEF 5 X5"), "L and R of the tool are due here, found 'X5'");
}

}  // namespace obrys::read::heidenhain
