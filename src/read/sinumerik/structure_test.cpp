#include <gtest/gtest.h>

#include "read/sinumerik/reading.hpp"

namespace obrys::read::sinumerik {

using testing::one;
using testing::Reading;

TEST(SinumerikStructure, IfElse) {
    EXPECT_EQ(Reading("IF R1==1\nX1\nELSE\nX2\nENDIF\nX3\n").tree(),
              "0 if (R1 == 1) ->3\n1 X1\n2 else ->4\n3 X2\n4 endif\n5 X3\n");
    EXPECT_EQ(Reading("IF(R1==1)\nX1\nENDIF\n").tree(), "0 if (R1 == 1) ->3\n1 X1\n2 endif\n");
    EXPECT_EQ(Reading("N170 IF (R1<=2)\nSUB\nELSE\nENDIF").tree(),
              "0 if (R1 <= 2) ->3\n1 call SUB\n2 else ->3\n3 endif\n");
}

TEST(SinumerikStructure, Loops) {
    EXPECT_EQ(Reading("WHILE(R1<2)AND(R2>3)\nX1\nENDWHILE").tree(),
              "0 while ((R1 < 2) and (R2 > 3)) ->3\n1 X1\n2 endwhile ->0\n");
    EXPECT_EQ(Reading("FOR R1=1 TO R2+1\nX=R1\nENDFOR").tree(), "0 for R1=1..(R2 + 1) ->2\n1 X=R1\n2 endfor ->0\n");
    EXPECT_EQ(Reading("REPEAT\nX1\nUNTIL R1==2").tree(), "0 repeat\n1 X1\n2 until (R1 == 2) ->0\n");
    EXPECT_EQ(Reading("LOOP\nX1\nENDLOOP").tree(), "0 loop\n1 X1\n2 endloop ->0\n");
}

TEST(SinumerikStructure, Jumps) {
    EXPECT_EQ(one("GOTOF END1"), "jump forward \"END1\"");
    EXPECT_EQ(one("IF R1 == 1 GOTOB L1"), "jump backward \"L1\" if (R1 == 1)");
    EXPECT_EQ(one("GOTO N100"), "jump either \"N100\"");
    EXPECT_EQ(one("GOTOC \"L\"<<R1"), "jump quiet (\"L\" << R1)");
    EXPECT_EQ(one("GOTOS"), "jump start");
    EXPECT_EQ(Reading("DEF STRING[10] S1\nGOTOF S1").tree(), "0 define 4[10] S1\n1 jump forward S1\n");
    EXPECT_EQ(Reading("N20 IF R1==0 GOTOF A1 IF R1==2 GOTOF A2").tree(),
              "0 jump forward \"A1\" if (R1 == 0)\n1 +jump forward \"A2\" if (R1 == 2)\n");
    EXPECT_EQ(Reading("R1=R1+1 GOTOB A1").tree(), "0 R1=(R1 + 1)\n1 +jump backward \"A1\"\n");
}

TEST(SinumerikStructure, Labels) {
    const Reading r("N10 START: X1\nX2\nSTART: MID:\nX3\nGOTOB N10\nN40 X4");
    const auto places = [&](const char* name) { return r.unit().labels.at(program::Names(&r.names).id(name)); };
    EXPECT_EQ(places("START"), (std::vector<std::uint32_t>{0, 2}));
    EXPECT_EQ(places("MID"), (std::vector<std::uint32_t>{2}));
    EXPECT_EQ(places("N10"), (std::vector<std::uint32_t>{0}));
    EXPECT_EQ(places("N40"), (std::vector<std::uint32_t>{5}));
}

TEST(SinumerikStructure, BlockNumbersBecomeLabelsOnlyWhereNeeded) {
    EXPECT_TRUE(Reading("N10 X1\nN20 X2\nGOTOF END1\nEND1: M30").unit().labels.size() == 1);
}

TEST(SinumerikStructure, Case) {
    EXPECT_EQ(one("CASE R1 OF 1 GOTOF A1 2 GOTOB A2 DEFAULT GOTO A3"),
              "case R1 | 1 forward \"A1\" | 2 backward \"A2\" | _ either \"A3\"");
    EXPECT_EQ(one("CASE I1 OF-1 GOTO L1-2 GOTO L2"), "case I1 | -1 either \"L1\" | -2 either \"L2\"");
    EXPECT_EQ(one("CASE (I1+4) OF 'HC' GOTO \"A\"<<I1 DEFAULT GOTO (\"B\"<<2)"),
              "case (I1 + 4) | 12 either (\"A\" << I1) | _ either (\"B\" << 2)");
}

TEST(SinumerikStructure, RepeatedSections) {
    EXPECT_EQ(one("REPEAT A1 P=3"), "section A1 here x3");
    EXPECT_EQ(one("REPEAT A1 A2 P=R1"), "section A1 A2 xR1");
    EXPECT_EQ(one("N10 REPEATB A1"), "section A1 block");
    EXPECT_EQ(one("REPEATB A1 P=10"), "section A1 block x10");
}

TEST(SinumerikStructure, Calls) {
    EXPECT_EQ(one("PODPROG_ZL"), "call PODPROG_ZL");
    EXPECT_EQ(one("N10 L123 P3"), "call L123 x3");
    EXPECT_EQ(one("L340 ( _B10 )"), "call L340(_B10)");
    EXPECT_EQ(one("sub(1,,\"a\",)"), "call SUB(1,_,\"a\",_)");
    EXPECT_EQ(one("SUB()"), "call SUB()");
    EXPECT_EQ(one("SUB P=R1"), "call SUB xR1");
    EXPECT_EQ(one("MCALL L350(10,ABS(R4))"), "modal L350(10,f7(R4))");
    EXPECT_EQ(one("MCALL ; off"), "modal-end");
    EXPECT_EQ(one("CALL \"/_N_CUS_DIR/L\"<<R1"), "indirect (\"/_N_CUS_DIR/L\" << R1)");
    EXPECT_EQ(one("PCALL /_N_MPF_DIR/_N_WELLE_SPF(A1,20)"), "call WELLE(A1,20)");
    EXPECT_EQ(one("CALL BLOCK A1 TO A2"), "unsupported{CALL BLOCK A1 TO A2|call of a program section}");
    EXPECT_EQ(Reading("G0 X1 L100").tree(), "0 m0 X1\n1 +call L100\n");
}

TEST(SinumerikStructure, ProceduresAndReturn) {
    EXPECT_EQ(one("SETAL(65000)"), "procedure 1(65000)");
    EXPECT_EQ(one("SETMS"), "procedure 2()");
    EXPECT_EQ(one("MSG()"), "procedure 0()");
    EXPECT_EQ(one("RET"), "return");
    EXPECT_EQ(Reading("RET(\"A1\")").tree(),
              "0 unsupported{RET(\"A1\")|return to another place than the call}\n1 +return\n");
}

TEST(SinumerikStructure, Frames) {
    EXPECT_EQ(one("TRANS X10 Z=R1"), "frame 0 X10 Z=R1");
    EXPECT_EQ(one("ATRANS AX[A1]=5"), "aframe 0 axis AX[A1]=5");
    EXPECT_EQ(one("AROT RPL=30"), "aframe 1 RPL30");
    EXPECT_EQ(one("SCALE X2"), "frame 2 X2");
    EXPECT_EQ(one("MIRROR X0"), "frame 3 X0");
    EXPECT_EQ(one("TRANS"), "frame 0");
}

TEST(SinumerikStructure, MissingEndsAreClosedWhereTheyMust) {
    const Reading open("IF R1\nWHILE R2\nX1\nENDIF\nX2\n");
    EXPECT_EQ(open.codes(), std::vector<std::string>{"unclosed"});
    EXPECT_EQ(open.tree(), "0 if R1 ->5\n1 while R2 ->4\n2 X1\n3 +endwhile ->4\n4 endif\n5 X2\n");
    const Reading end("REPEAT\nX1\n");
    EXPECT_EQ(end.messages(),
              "TEST.MPF:1:1: error: REPEAT without UNTIL [unclosed]\n  REPEAT\n  ^~~~~~\n  remedy: add UNTIL where it "
              "ends\n");
    EXPECT_EQ(end.tree(), "0 repeat\n1 X1\n2 +until TRUE ->3\n");
}

}  // namespace obrys::read::sinumerik
