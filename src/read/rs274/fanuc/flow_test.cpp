#include <gtest/gtest.h>

#include "read/rs274/fanuc/reading.hpp"

namespace obrys::read::rs274 {

using program::Modal;
using testing::fanuc;
using testing::haas;
using testing::m;
using testing::on_haas;
using testing::on_mill;
using testing::program;
using testing::Reading;

TEST(FanucMacro, AssignmentsAreExpressionsWithoutBrackets) {
    EXPECT_EQ(on_mill("#1=#2+#3*2"), "#1=(#2 + (#3 * 2))");
    EXPECT_EQ(on_mill("#1=#2 OR #3 AND 4"), "#1=(#2 bor (#3 band 4))");
    EXPECT_EQ(on_mill("#1=-#2"), "#1=(neg #2)");
    EXPECT_EQ(on_mill("#[#1+1]=5"), "R[(#1 + 1)]=5");
    EXPECT_EQ(on_mill("#1=ATAN[#2]/[#3]"), "#1=f5(#2,#3)");
    EXPECT_EQ(on_mill("#1=10 MOD 3 (REST)"), "#1=(10 mod 3)");
    EXPECT_EQ(on_mill("#1=#0"), "#1=#0");
    EXPECT_EQ(on_mill("#0=1"), "4:1 there is no parameter #0");
    EXPECT_EQ(on_mill("#1=BIN[#2]"), "4:4 the function BIN is not run");
    EXPECT_EQ(on_mill("#1=2 X5."), "4:6 'X' cannot stand behind an assignment");
}

TEST(FanucMacro, IfThenAndGoto) {
    EXPECT_EQ(on_mill("IF[#1 EQ 2]THEN#3=4"), "if (#1 == 2) ->4\n+#3=4\n+endif");
    EXPECT_EQ(on_mill("IF [#1 GT #2] GOTO 20\nX1.\nN20 Y1."), "jump either 20 if (#1 > #2)\nX1\nY1");
    EXPECT_EQ(on_mill("GOTO #5"), "jump either #5");
    EXPECT_EQ(on_mill("IF [#1 EQ 1] THEN\nX1.\nELSE\nY1.\nENDIF"), "if (#1 == 1) ->4\nX1\nelse ->5\nY1\nendif");
    const Reading r = fanuc(program("GOTO 20\nN10 X1.\nN0020 Y1."));
    ASSERT_EQ(r.unit().jumps.size(), 1U);
    EXPECT_EQ(r.unit().jumps[0].target, 3U) << "leading zeros do not matter";
    const Reading twice = fanuc(program("N20 X1.\nGOTO 20\nN20 Y1."));
    EXPECT_EQ(twice.unit().jumps[0].target, program::no_target) << "the run takes the next one";
}

TEST(FanucMacro, Loops) {
    EXPECT_EQ(on_mill("WHILE[#1 LT 5]DO1\n#1=#1+1\nEND1"), "while (#1 < 5) ->4\n#1=(#1 + 1)\nendwhile ->1");
    EXPECT_EQ(on_mill("DO 2\nGOTO 9\nEND 2\nN9"), "loop ->4\njump either 9\nendloop ->1\n");
    EXPECT_EQ(on_mill("DO 4\nEND 4"), "4:4 DO needs a number from 1 to 3");
    EXPECT_EQ(on_mill("DO 1\nDO 1\nEND 1\nEND 1"), "5:1 DO 1 stands inside another DO 1");
    EXPECT_EQ(on_mill("END 1"), "4:1 END 1 without DO 1");
    EXPECT_EQ(on_mill("DO 1\nDO 2\nEND 1\nEND 2"), "5:1 DO 2 crosses END 1");
    EXPECT_EQ(on_mill("WHILE[#1 LT 5]DO1"), "4:1 DO 1 without END 1");
    EXPECT_EQ(on_mill("IF[#1 LT 5]THEN"), "4:1 IF … THEN without ENDIF");
    EXPECT_EQ(on_mill("IF #1 GOTO 5"), "4:1 I has no value");
    EXPECT_EQ(on_mill("WHILE #1 DO1"), "4:7 expected [ behind WHILE, found '#'");
}

TEST(FanucMacro, AlarmsAndStops) {
    EXPECT_EQ(on_mill("#3000=7 (TOO FAR)"), "procedure 11((f44((7 + 3000),0) << \" TOO FAR\"))");
    EXPECT_EQ(on_haas("#3000=7 (TOO FAR)"), "procedure 11((f44((7 + 1000),0) << \" TOO FAR\"))");
    EXPECT_EQ(on_mill("#3006=1 (LOOK)"), "procedure 0(\"LOOK\")\n+M0");
    EXPECT_EQ(on_mill("DPRNT[X#1[53]**END]"), "procedure 12(((\"X\" << f44(#1,3)) << \"  END\"))");
    const Reading r = fanuc(program("POPEN\n#3003=1\nPCLOS"));
    EXPECT_EQ(r.messages(), "");
    EXPECT_EQ(r.unit().ignored.size(), 3U);
}

TEST(FanucMacro, SystemVariablesAreWhatTheyMean) {
    const auto what = [](program::SystemVariable v) { return "#" + std::to_string(static_cast<int>(v)); };
    const std::string code = what(program::SystemVariable::code_in_force);
    EXPECT_EQ(on_mill("#1=#5042"), "#1=#5042" + what(program::SystemVariable::coordinate) + "[2]");
    EXPECT_EQ(on_mill("#1=#5023"), "#1=#5023" + what(program::SystemVariable::machine_coordinate) + "[3]");
    EXPECT_EQ(on_mill("#1=#4003"), "#1=#4003" + code + "[8,90,91]") << "one reading, that the job can give";
    EXPECT_EQ(on_mill("#1=#4001"), "#1=#4001" + code + "[3,0,0]");
    EXPECT_EQ(on_mill("#1=#1000"), "#1=#1000") << "a parameter that is not known until the job gives it";
    EXPECT_EQ(on_mill("#1=#5221"), "#1=#5221");
    EXPECT_EQ(on_mill("#500=1"), "#500=1");
}

TEST(FanucCalls, Subprograms) {
    EXPECT_EQ(on_mill("M98 P1000"), "call O1000");
    EXPECT_EQ(on_mill("M98 P0012 L3"), "call O12 x3");
    EXPECT_EQ(on_mill("M98 P31000"), "call O1000 x3");
    EXPECT_EQ(on_mill("M98 P00031000"), "call O1000 x3");
    EXPECT_EQ(on_haas("M98 P31000"), "call O31000") << "five digits name a program";
    EXPECT_EQ(on_mill("X1. M98 P1000"), "X1\n+call O1000") << "behind the motion";
    EXPECT_EQ(on_mill("M98 P#1"), "indirect #1");
    EXPECT_EQ(on_mill("M98"), "4:1 the number of the subprogram is missing");
    EXPECT_TRUE(fanuc(program("M98 P5")).unit().calls[0].shares_parameters);
}

/// B-63684EN page 278: I-3.0 I4.0 D5.0 sets #4, then #7 twice, the later one wins.
TEST(FanucCalls, ArgumentsOfMacros) {
    EXPECT_EQ(on_mill("G65 A1.0 B2.0 I-3.0 I4.0 D5.0 P1000"), "call O1000(1r,2r,_,-3r,_,_,5r)");
    EXPECT_EQ(on_mill("G65 P1000 L2 I1. J2. K3. I4. J5. K6."), "call O1000(_,_,_,1r,2r,3r,4r,5r,6r) x2");
    EXPECT_EQ(on_mill("G65 P1000 K3. I4."), "call O1000(_,_,_,_,_,3r,4r)");
    EXPECT_EQ(on_mill("G65 P1000 A#2"), "call O1000(#2)");
    EXPECT_EQ(on_mill("G65 P1000 Z-5.\n"), "call O1000(_,_,_,_,_,_,_,_,_,_,_,_,_,_,_,_,_,_,_,_,_,_,_,_,_,-5r)");
    EXPECT_EQ(on_mill("G65 P1000 O5"), "4:11 'O' cannot stand here");
    EXPECT_EQ(on_mill("G65 A1."), "4:1 the number of the macro is missing");
    EXPECT_EQ(on_mill("G90 X1. G65 P5 A1."), "X1 " + m(Modal::absolute) + "\n+call O5(1r)");
    const Reading r = fanuc(program("G65 P1000 A360 H1 X100"));
    const auto& call = r.unit().calls[0];
    EXPECT_EQ(r.unit().numbers[r.unit().exprs[call.arguments[0]].a], 0.36);
    EXPECT_EQ(r.unit().numbers[r.unit().exprs[call.arguments[10]].a], 1);
    EXPECT_EQ(r.unit().numbers[r.unit().exprs[call.arguments[23]].a], 0.1);
    EXPECT_FALSE(call.shares_parameters);
}

TEST(FanucCalls, ModalMacros) {
    EXPECT_EQ(on_mill("G66 P9011 L2 A1.\nX5.\nG67"), "modal O9011(1r) x2\nX5\nmodal-end");
    EXPECT_EQ(on_mill("G66.1 P1 A1."), "unsupported{G66.1|a macro called by every block}");
}

TEST(FanucCalls, TheWayBack) {
    const Reading r = fanuc("%\nO1\nM98 P2\nM30\nO2\nX1.\nM99\n%\n");
    ASSERT_EQ(r.units.size(), 2U);
    EXPECT_EQ(r.units[0].name, "O1");
    EXPECT_EQ(r.units[1].name, "O2");
    EXPECT_EQ(r.tree(1), "0 X1\n1 return\n");
    EXPECT_EQ(on_mill("M99 P100"), "return") << "its first word leads to the jump";
}

TEST(FanucCalls, LocalSubprogramsOfHaas) {
    EXPECT_EQ(on_haas("M97 P100 L2\nM30\nN100 X1.\nM99"),
              "repeat-count 2 ->4\n+call \"N100\" ->5\n+end-repeat-count ->1\nM30\nX1\nlabel-end\n+return");
}

TEST(FanucPrograms, SignsNamesAndSkips) {
    EXPECT_EQ(testing::body(fanuc("%\nO0012 (TITLE)\nG21\n/X1.\n/2 X2.\nN10 /3 X3.\nM30\n%\n")), "/0 X1\n/2 X2\n/3 X3");
    EXPECT_EQ(fanuc("%\nO0012 (TITLE)\nM30\n%\n").unit().name, "O12");
    EXPECT_EQ(fanuc("%\n:0007\nM30\n%\n").unit().name, "O7");
    EXPECT_EQ(fanuc("%\nONONAME (X)\nM30\n%\n").unit().name, "ONONAME");
    EXPECT_EQ(fanuc("%\nG21\nM30\n%\n", "dir/part.nc").unit().name, "PART");
    const Reading missing = fanuc("O1\nG21\nM30\n");
    ASSERT_EQ(missing.diagnostics.all().size(), 1U);
    EXPECT_EQ(missing.diagnostics.all()[0].severity, base::Severity::note);
    const Reading leader = fanuc("====\nMade by hand\n====\n%\nO1\nG21\nM30\n%\nG0 X[\n");
    EXPECT_EQ(leader.diagnostics.all().size(), 2U) << leader.messages();
    EXPECT_EQ(leader.unit().problems.size(), 0U);
    EXPECT_EQ(testing::body(fanuc("%\nO1\nG21\nX1.;Y1.;\nM30;\n%\n")), "X1\nY1");
}

TEST(FanucTurning, LathesBeginWithDiametersAndFeedPerRevolution) {
    const Reading r = testing::lathe("%\nO1\nG21\nG0 X40. W-5.\nT0203\nG50 S2000\nM30\n%\n");
    EXPECT_EQ(r.messages(), "");
    EXPECT_EQ(r.tree(), "0 " + m(Modal::metric_all) + "\n1 X40 Z=q1(-5r) " + m(Modal::rapid) +
                            "\n2 T2 D3 tool-change\n3 LIMS2000\n4 M30\n");
    EXPECT_TRUE(r.unit().traits->begins_as_lathe);
    EXPECT_EQ(testing::lathe("%\nO1\nG0 X40.\nM99\n%\n").tree(), "0 X40 " + m(Modal::rapid) + "\n1 return\n");
}

TEST(FanucTurning, SingleCyclesAreFourWays) {
    const Reading r = testing::lathe("%\nO1\nG21\nG90 X30. Z-20. F0.2\nX28.\nG0 X50.\nM30\n%\n");
    EXPECT_EQ(r.messages(), "");
    const std::string tree = r.tree();
    const std::string cycle = "X=(_CYCLE_END_X + (2r * _CYCLE_TAPER)) " + m(Modal::rapid);
    const std::size_t once = tree.find(cycle);
    ASSERT_NE(once, std::string::npos) << tree;
    EXPECT_NE(tree.find(cycle, once + 1), std::string::npos) << "X28. repeats the cycle\n" << tree;
    EXPECT_NE(tree.find("X50 " + m(Modal::rapid)), std::string::npos) << tree;
    EXPECT_NE(tree.find("_CYCLE_END_Z=-20r"), std::string::npos) << tree;
}

TEST(FanucTurning, RepetitiveCyclesAreDefinitions) {
    const Reading r = testing::lathe(
        "%\nO1\nG21\nG71 U2. R1.\nG71 P10 Q20 U0.4 W0.1 F0.3\nN10 G0 X20.\nN20 G1 Z-5. F0.1\nG70 P10 Q20\nM30\n%\n");
    EXPECT_EQ(r.messages(), "");
    EXPECT_EQ(r.unit().problems.size(), 0U);
    ASSERT_EQ(r.unit().cycles.size(), 3U);
    EXPECT_TRUE(r.unit().cycles[0].sets_only);
    EXPECT_EQ(r.unit().cycles[0].first_block, program::no_expr);
    EXPECT_FALSE(r.unit().cycles[1].sets_only);
    EXPECT_EQ(r.unit().cycles[1].kind, cl::CycleKind::lathe_remove_along);
    EXPECT_EQ(r.unit().cycles[2].kind, cl::CycleKind::lathe_finish);
    EXPECT_EQ(r.unit().labels.size(), 2U) << "N10 and N20";
}

}  // namespace obrys::read::rs274
