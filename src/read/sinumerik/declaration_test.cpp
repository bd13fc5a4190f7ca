#include <gtest/gtest.h>

#include "read/sinumerik/reading.hpp"

namespace obrys::read::sinumerik {

using program::Type;
using testing::one;
using testing::Reading;

TEST(SinumerikDeclaration, Variables) {
    EXPECT_EQ(one("DEF REAL A1,B2=1.5,C3[2,3]"), "define 3 A1 B2=1(1.5r) C3[2][3]");
    EXPECT_EQ(one("N10DEF INT VAR=0;comment"), "define 2 VAR=1(0)");
    EXPECT_EQ(one("DEF STRING[12] NAME=\"x\""), "define 4[12] NAME=1(\"x\")");
    EXPECT_EQ(one("DEF REAL VV[4]=(0.6,0.7), WW[9]=SET(0), UU[2]=REP(5)"),
              "define 3 VV[4]=2(0.6r,0.7r) WW[9]=2(0) UU[2]=3(5)");
    EXPECT_EQ(one("DEF NCK APW 5 APR 7 REAL PHU 5 LLI -100.0 ULI +100.0 VV[3,3]=SET(1,0)"),
              "define global 3 VV[3][3]=2(1,0)");
    EXPECT_EQ(one("DEF AXIS AX_W,AX_V"), "define 5 AX_W AX_V");
    EXPECT_EQ(one("DEF FRAME F1=CTRANS(X,1)"), "define 6 F1=1(f31(X,1))");
    EXPECT_EQ(one("DEF BOOL B1=TRUE"), "define 0 B1=1(TRUE)");
}

TEST(SinumerikDeclaration, Proc) {
    const Reading r("N10 PROC SUB(REAL AA, VAR INT BB[], STRING[32] CC=\"x\", AXIS DD, REAL EE[3]) SAVE DISPLOF\nX1\n",
                    "other.spf");
    EXPECT_EQ(r.messages(), "");
    const program::Unit& u = r.unit();
    EXPECT_EQ(u.name, "SUB");
    EXPECT_TRUE(u.has_proc);
    EXPECT_TRUE(u.save);
    ASSERT_EQ(u.parameters.size(), 5u);
    EXPECT_EQ(r.names.text(u.parameters[0].name), "AA");
    EXPECT_EQ(u.parameters[0].type, Type::real);
    EXPECT_TRUE(u.parameters[1].by_reference);
    EXPECT_TRUE(u.parameters[1].is_array);
    EXPECT_EQ(u.parameters[1].dimensions[0], program::no_expr);
    EXPECT_EQ(u.texts[u.exprs[u.parameters[2].preset].a], "x");
    EXPECT_EQ(u.parameters[3].type, Type::axis);
    EXPECT_TRUE(u.parameters[4].is_array);
    EXPECT_EQ(r.tree(), "0 X1\n");
    EXPECT_EQ(Reading("X1", "/a/b/my prog.mpf").unit().name, "MY PROG");
}

TEST(SinumerikDeclaration, ExternIsAccepted) {
    const Reading r("EXTERN SUB(REAL, VAR INT, STRING[10], REAL[,])\nSUB(1,R1,\"a\",V1)\n");
    EXPECT_EQ(r.messages(), "");
    EXPECT_EQ(r.unit().statements.back().kind, program::StatementKind::call);
}

TEST(SinumerikDeclaration, MacrosAreReplaced) {
    const Reading r(
        "DEFINE CUT AS G1 F0.1\nDEFINE M6 AS L6\nDEFINE IDX AS ARR[\nCUT X5\nG0M6\nR1=IDX 2]\nMSG(\"CUT\") ; CUT\n");
    EXPECT_EQ(r.messages(), "");
    const std::string tree = r.tree();
    EXPECT_NE(tree.find("m1.1 F0.1 X5\n"), std::string::npos) << tree;
    EXPECT_NE(tree.find("m0\n"), std::string::npos) << tree;
    EXPECT_NE(tree.find("+call L6\n"), std::string::npos) << tree;
    EXPECT_NE(tree.find("R1=ARR[2]\n"), std::string::npos) << tree;
    EXPECT_NE(tree.find("procedure 0(\"CUT\")\n"), std::string::npos) << tree;
}

TEST(SinumerikDeclaration, WordsOfAMacroPointAtItsUse) {
    const Reading r("DEFINE CUT AS G1 F0.1\nCUT X5\n");
    const auto last = static_cast<std::uint32_t>(r.unit().statements.size() - 1);
    EXPECT_EQ(r.text_of(last, 0), "CUT");
    EXPECT_EQ(r.text_of(last, 2), "X5");
}

TEST(SinumerikDeclaration, AMacroThatContainsItselfIsAnError) {
    const Reading r("DEFINE AA AS X1 AA\nAA\nX2\n");
    EXPECT_EQ(r.messages(), "TEST.MPF:2:1: error: a macro of this line contains itself [syntax]\n  AA\n  ^~\n");
}

}  // namespace obrys::read::sinumerik
