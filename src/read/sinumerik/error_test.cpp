#include <gtest/gtest.h>

#include "read/sinumerik/reading.hpp"

namespace obrys::read::sinumerik {

using testing::Reading;

namespace {

std::string message(const std::string& text) { return Reading(text).messages(); }

}  // namespace

TEST(SinumerikError, PointsAtTheSmallestWrongWord) {
    EXPECT_EQ(message("N10 X1\nN20 G1 X=R1+*3 Y5\n"),
              "TEST.MPF:2:13: error: expected a value, found '*' [syntax]\n  N20 G1 X=R1+*3 Y5\n              ^\n");
    EXPECT_EQ(message("R1=(2+3\n"),
              "TEST.MPF:1:4: error: this parenthesis is not closed [syntax]\n  R1=(2+3\n     ^\n  remedy: add ')'\n");
    EXPECT_EQ(message("R1=SIN(2 3)\n"),
              "TEST.MPF:1:10: error: expected ',' or ')', found '3' [syntax]\n  R1=SIN(2 3)\n           ^\n");
    EXPECT_EQ(message("R1=ARR[2\n"),
              "TEST.MPF:1:9: error: expected ']', found end of block [syntax]\n  R1=ARR[2\n          ^\n  remedy: "
              "close the index\n");
    EXPECT_EQ(message("MSG(\"abc)\n"),
              "TEST.MPF:1:5: error: the string is not closed [syntax]\n  MSG(\"abc)\n      ^~~~~\n  remedy: add a "
              "quotation mark (\") at its end\n");
}

TEST(SinumerikError, Words) {
    EXPECT_EQ(
        message("G1 X Y5\n"),
        "TEST.MPF:1:4: error: the address X has no value [syntax]\n  G1 X Y5\n     ^\n  remedy: write X10 or X=…\n");
    EXPECT_EQ(message("G1 X1 RND2\n"),
              "TEST.MPF:1:7: error: RND needs '=' in front of its value [syntax]\n  G1 X1 RND2\n        ^~~~\n  "
              "remedy: write RND=2\n");
    EXPECT_EQ(message("G1 X1 CHR1.5 F2\n"),
              "TEST.MPF:1:7: error: CHR needs '=' in front of its value [syntax]\n  G1 X1 CHR1.5 F2\n        ^~~~~~\n  "
              "remedy: write CHR=1.5\n");
    EXPECT_EQ(message("G1 CR\n"),
              "TEST.MPF:1:4: error: CR has no value [syntax]\n  G1 CR\n     ^~\n  remedy: write CR=…\n");
    EXPECT_EQ(message("X1 # Y2\n"), "TEST.MPF:1:4: error: unexpected '#' [syntax]\n  X1 # Y2\n     ^\n");
    EXPECT_EQ(message("ARR[1]\n"),
              "TEST.MPF:1:7: error: expected '=', found end of block [syntax]\n  ARR[1]\n        ^\n  remedy: a block "
              "cannot consist of a value alone\n");
    EXPECT_EQ(message("R1='H1G'\n").find("TEST.MPF:1:4: error: 'H1G' is neither"), 0u);
}

TEST(SinumerikError, Structures) {
    EXPECT_EQ(message("ENDIF\n"),
              "TEST.MPF:1:1: error: ENDIF without IF [syntax]\n  ENDIF\n  ^~~~~\n  remedy: remove it, or add the IF it "
              "belongs to\n");
    EXPECT_EQ(message("IF R1\nELSE\nELSE\nENDIF\n"),
              "TEST.MPF:3:1: error: a second ELSE for one IF [syntax]\n  ELSE\n  ^~~~\n");
    EXPECT_EQ(message("N10 WHILE R1<2\n"),
              "TEST.MPF:1:5: error: WHILE without ENDWHILE [unclosed]\n  N10 WHILE R1<2\n      ^~~~~\n  remedy: add "
              "ENDWHILE where it ends\n");
    EXPECT_EQ(message("FOR R1=1 5\nENDFOR\n"),
              "TEST.MPF:1:10: error: expected TO in FOR, found '5' [syntax]\n  FOR R1=1 5\n           ^\n  remedy: "
              "write FOR R1=1 TO 10\n");
    EXPECT_EQ(message("GOTOF\n"),
              "TEST.MPF:1:6: error: the destination of the jump is missing [syntax]\n  GOTOF\n       ^\n  remedy: name "
              "a label or a block number\n");
    EXPECT_EQ(message("X1\nPROC AA\n"),
              "TEST.MPF:2:1: error: PROC stands only in the first block of a program [syntax]\n  PROC AA\n  ^~~~\n  "
              "remedy: split the text into one file a program\n");
    EXPECT_EQ(message("DEF FLOAT A1\n"),
              "TEST.MPF:1:5: error: DEF needs a type, found 'FLOAT' [syntax]\n  DEF FLOAT A1\n      ^~~~~\n  remedy: "
              "write DEF REAL, INT, BOOL, CHAR, STRING[n], AXIS or FRAME\n");
}

TEST(SinumerikError, SpoilsOnlyItsBlock) {
    const Reading r("X1\nG1 X2 Y=) F3\nX3\n");
    EXPECT_EQ(r.tree(), "0 X1\n1 m1.1 X2 unknown{)|expected a value, found ')'}\n2 X3\n");
    EXPECT_EQ(r.codes(), std::vector<std::string>{"syntax"});
}

TEST(SinumerikError, AStructureWithABadHeadIsNotRun) {
    const Reading slip("IF R1=5\nX1\nELSE\nX2\nENDIF");
    EXPECT_EQ(slip.messages(),
              "TEST.MPF:1:6: error: '=' assigns a value and cannot stand in a condition [syntax]\n  IF R1=5\n       "
              "^\n  remedy: compare with '=='\n");
    EXPECT_EQ(slip.tree(),
              "0 unknown{=|'=' assigns a value and cannot stand in a condition}\n1 +if FALSE ->4\n2 X1\n3 else ->5\n4 "
              "X2\n5 endif\n");
    EXPECT_EQ(Reading("WHILE )\nX1\nENDWHILE").tree(),
              "0 unknown{)|expected a value, found ')'}\n1 +while FALSE ->4\n2 X1\n3 endwhile ->1\n");
    EXPECT_EQ(Reading("FOR 1 TO 2\nX1\nENDFOR\nX2").tree(),
              "0 unknown{1|FOR needs a variable, found '1'}\n1 +if FALSE ->4\n2 X1\n3 endif\n4 X2\n");
}

TEST(SinumerikError, ManyErrorsInOneLineAreOneMessage) { EXPECT_EQ(Reading("X= Y= Z= #\n").codes().size(), 1u); }

}  // namespace obrys::read::sinumerik
