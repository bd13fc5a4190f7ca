#include "format/heidenhain/format.hpp"

#include <gtest/gtest.h>

namespace obrys::format::heidenhain {
namespace {

/// One block between BEGIN and END, as block 7 of a numbered program.
std::string block(const std::string& text, const Options& options = {}) {
    const Formatted f = formatted("0 BEGIN PGM P MM\n7 " + text + "\n8 END PGM P MM\n", Language::klartext, options);
    const std::string head = "0 BEGIN PGM P MM\n1 ";
    EXPECT_EQ(f.text.substr(0, head.size()), head);
    const std::size_t end = f.text.find("\n2 END PGM P MM\n");
    EXPECT_NE(end, std::string::npos) << f.text;
    return f.text.substr(head.size(), end - head.size());
}

std::string klartext(const std::string& text, const Options& options = {}) {
    const std::string once = formatted(text, Language::klartext, options).text;
    EXPECT_EQ(formatted(once, Language::klartext, options).text, once);
    return once;
}

std::string iso(const std::string& text) {
    const std::string once = formatted(text, Language::iso).text;
    EXPECT_EQ(formatted(once, Language::iso).text, once);
    return once;
}

TEST(Format, path_words) {
    EXPECT_EQ(block("l x10y-5.5   r0 F MAX m3"), "L X+10 Y-5.5 R0 FMAX M3");
    EXPECT_EQ(block("L Z 25.000 F 500"), "L Z+25.000 F500");
    EXPECT_EQ(block("L IX10 IY-Q5 F AUTO"), "L IX+10 IY-Q5 FAUTO");
    EXPECT_EQ(block("X10 R+ F100"), "X+10 R+ F100");
    EXPECT_EQ(block("CR X1 Y+2 R20 DR-"), "CR X+1 Y+2 R+20 DR-");
    EXPECT_EQ(block("CP IPA30 IZ-1 DR+"), "CP IPA+30 IZ-1 DR+");
    EXPECT_EQ(block("rnd  r5 F100"), "RND R5 F100");
    EXPECT_EQ(block("L X1. R F MAX M13"), "L X+1. R FMAX M13");
    EXPECT_EQ(block("L X+1 M"), "L X+1 M");
    EXPECT_EQ(block("C+90 FMAX"), "C+90 FMAX");
    EXPECT_EQ(block("L X+1 M120 LA10"), "L X+1 M120 LA10");
    EXPECT_EQ(block("appr lt X10 LEN 15 RL F  MAX"), "APPR LT X+10 LEN 15 RL FMAX");
    EXPECT_EQ(block("FC DR- R18 CLSD+ CCX+20 x5"), "FC DR- R18 CLSD+ CCX+20 X+5");
}

TEST(Format, TheNameOfTheProgramIsKept) {
    EXPECT_EQ(klartext("0 begin pgm c mm\n1 l x1\n2 end pgm c mm\n"), "0 BEGIN PGM c MM\n1 L X+1\n2 END PGM c MM\n");
    EXPECT_EQ(klartext("0 begin pgm mm inch\n1 end pgm mm inch\n"), "0 BEGIN PGM mm INCH\n1 END PGM mm INCH\n");
    EXPECT_EQ(klartext("0 begin pgm mm\n1 end pgm mm\n"), "0 BEGIN PGM mm\n1 END PGM mm\n");
}

TEST(Format, tools_blanks_and_calls) {
    EXPECT_EQ(block("tool call 5.1 zS800 F 200 dl0.1 DR2 0,5"), "TOOL CALL 5.1 Z S800 F200 DL+0.1 DR2+0,5");
    EXPECT_EQ(block("TOOL CALL \"Mill a\"  Z"), "TOOL CALL \"Mill a\" Z");
    EXPECT_EQ(block("TOOL DEF  1 L0 R5"), "TOOL DEF 1 L+0 R+5");
    EXPECT_EQ(block("blk form 0,1 z X0 Y0 Z-40"), "BLK FORM 0.1 Z X+0 Y+0 Z-40");
    EXPECT_EQ(block("lbl5"), "LBL 5");
    EXPECT_EQ(block("call lbl \"Ab c\"  rep 2"), "CALL LBL \"Ab c\" REP 2");
    EXPECT_EQ(block("call pgm  TNC:\\sub\\Part.h"), "CALL PGM TNC:\\sub\\Part.h");
    EXPECT_EQ(block("CYCL CALL  pos X1 F MAX"), "CYCL CALL POS X+1 FMAX");
}

TEST(Format, formulas_and_functions) {
    EXPECT_EQ(block("q1=-(Q2+5,5)*sin Q3^2"), "Q1 = - ( Q2 + 5,5 ) * SIN Q3 ^ 2");
    EXPECT_EQ(block("QS1=\"a  b\"||qs2"), "QS1 = \"a  b\" || QS2");
    EXPECT_EQ(block("fn 9:if +q1 equ +0 goto lbl1"), "FN 9: IF +Q1 EQU +0 GOTO LBL 1");
    EXPECT_EQ(block("FN0: Q3=1.995"), "FN 0: Q3 = 1.995");
    EXPECT_EQ(block("FN 14: ERROR= 1005"), "FN 14: ERROR = 1005");
    EXPECT_EQ(block("FN 16: F-PRINT TNC:\\m.a/rs232:"), "FN 16: F-PRINT TNC:\\m.a/rs232:");
}

TEST(Format, cycles_and_continuation) {
    EXPECT_EQ(block("cycl def 200 Bohren  tief~\nQ200 = 2;ABSTAND~\n     Q201=-20   ;TIEFE"),
              "CYCL DEF 200 Bohren  tief ~\n  Q200=2 ;ABSTAND~\n  Q201=-20 ;TIEFE");
    EXPECT_EQ(block("CYCL DEF 7.1   X10"), "CYCL DEF 7.1 X+10");
    EXPECT_EQ(block("CYCL DEF 19.0 PLAN D'USINAGE"), "CYCL DEF 19.0 PLAN D'USINAGE");
    EXPECT_EQ(block("CYCL DEF 26.1 X1.5  Y2"), "CYCL DEF 26.1 X1.5 Y2");
    // Without `~` the lines carry no number; an assignment behind another block does.
    EXPECT_EQ(klartext("0 BEGIN PGM P MM\n1 CYCL DEF 200 X\nQ200=2\n;c\nQ201=3\n4 L M3\nQ5=1\n"),
              "0 BEGIN PGM P MM\n1 CYCL DEF 200 X\n  Q200=2\n2 ;c\n  Q201=3\n3 L M3\n4 Q5 = 1\n");
}

TEST(Format, comments_texts_and_layout_stay) {
    EXPECT_EQ(block("L X1;Two  Blanks, lower"), "L X+1 ;Two  Blanks, lower");
    EXPECT_EQ(block(";  l x10  "), ";  l x10");
    EXPECT_EQ(block("* -  structure x1"), "* -  structure x1");
    EXPECT_EQ(block(";long ~\n    goes on x1"), ";long ~\n    goes on x1");
    EXPECT_EQ(klartext("Heading of an editor\n5 BEGIN PGM P MM\r\n\r\n9L X1\n/ 3 M30  "),
              "Heading of an editor\n0 BEGIN PGM P MM\r\n\r\n1 L X+1\n/2 M30");
    EXPECT_EQ(klartext("0 BEGIN PGM P MM\n1 L X1\r\n", {Decimal::keep, LineEnds::crlf}),
              "0 BEGIN PGM P MM\r\n1 L X+1\r\n");
    // A line of blanks ends a block in spite of `~`; an empty one does not.
    EXPECT_EQ(klartext("1 ;a ~\n  \n2 L X1"), "0 ;a ~\n  \n1 L X+1");
}

TEST(Format, decimal_sign_of_values_only) {
    const Options comma{Decimal::comma, LineEnds::keep};
    EXPECT_EQ(block("L X10.5 Y-.5", comma), "L X+10,5 Y-,5");
    EXPECT_EQ(block("BLK FORM 0.1 Z X+0.5", comma), "BLK FORM 0.1 Z X+0,5");
    EXPECT_EQ(block("TOOL CALL 5.1 Z S1.5", comma), "TOOL CALL 5.1 Z S1,5");
    EXPECT_EQ(block("CYCL DEF 7.1 X+1.5", comma), "CYCL DEF 7.1 X+1,5");
    EXPECT_EQ(block("Q1 = 1.5 ; 1.5", comma), "Q1 = 1,5 ; 1.5");
    EXPECT_EQ(block("CYCL DEF 12.1 PGM A.H", comma), "CYCL DEF 12.1 PGM A.H");
    EXPECT_EQ(block("L X10,5", {Decimal::point, LineEnds::keep}), "L X+10.5");
}

TEST(Format, what_is_not_understood_stays_and_is_named) {
    const Formatted f =
        formatted("0 BEGIN PGM P MM\n3 l x 10   +5 ;c\n4 FOO  bar\n5 L X+1 M ~\n  99\n", Language::klartext);
    EXPECT_EQ(f.text, "0 BEGIN PGM P MM\n1 l x 10   +5 ;c\n2 FOO  bar\n3 L X+1 M ~\n  99\n");
    ASSERT_EQ(f.left.size(), 3u);
    EXPECT_EQ(f.left[0].line, 2u);
    EXPECT_EQ(f.left[1].text, "4 FOO  bar");
    EXPECT_EQ(block("L X+1 R5"), "L X+1 R5");
    EXPECT_EQ(block("LBL \"open"), "LBL \"open");
}

TEST(Format, what_stays_is_no_other_block_than_before) {  // numbers would make Q202 a word of the cycle
    const std::string text =
        "BEGIN PGM P MM\nl x1\nCYCL DEF 200 X ~\n  Q200=2 ~\n  Q2X\x01=5 ~\x1a  Q338=0\nQ202=5 ~\n  Q206=1\nL Y2\n";
    EXPECT_EQ(klartext(text),
              "BEGIN PGM P MM\nL X+1\nCYCL DEF 200 X ~\n  Q200=2 ~\n  Q2X\x01=5 ~\x1a  Q338=0\nQ202=5 ~\n"
              "  Q206=1\nL Y+2\n");
    EXPECT_EQ(iso("%P G71 *\nG01 x1 *\nG01 FOO *\nG01 y2 *\nN99999999 %P G71 *\n"),
              "%P G71 *\nG01 X+1 *\nG01 FOO *\nG01 Y+2 *\nN99999999 %P G71 *\n");
}

TEST(Format, iso_blocks) {
    EXPECT_EQ(iso("%P G71 *\nN5 G30 g17 X0 Y+0 Z-40*\n"
                  "N6 G200 Drilling\nQ200 = 2 ;abc\nQ201=-5*\nN7 g98 L1 *\nN8 D09 P01 +Q1 P02  +0 P03 5*\n"
                  "N9 Q5=Q1*2*\nN10 L1,5*;call\nN11 G54 X10 FOO*\n;c\nN12 %SUB*\nN99999999 %P G71 *\n"),
              "%P G71 *\nN10 G30 G17 X+0 Y+0 Z-40 *\n"
              "N20 G200 Drilling\n  Q200=2 ;abc\n  Q201=-5 *\nN30 G98 L1 *\nN40 D09 P01 +Q1 P02 +0 P03 5 *\n"
              "N50 Q5 = Q1 * 2 *\nN60 L1,5 * ;call\nN70 G54 X10 FOO*\n;c\nN80 %SUB *\nN99999999 %P G71 *\n");
}

TEST(Format, iso_letter_away_from_its_number_stays_there) {  // `M 3` is no M3: written so the spindle would start
    EXPECT_EQ(iso("%P G71 *\nN5 G0 g40 x1 M 3*\nN6 M 3 *\nN7 T 5 G17 *\n"),
              "%P G71 *\nN10 G0 g40 x1 M 3*\nN20 M 3 *\nN30 T 5 G17 *\n");
}

TEST(Format, iso_beginning_without_its_unit_is_no_block) {  // numbered it would be a call of a program
    EXPECT_EQ(iso("%P Q201=-5 *  \n%P G71 *\nN7 G0 x1 *\n"), "%P Q201=-5 *\n%P G71 *\nN10 G0 X+1 *\n");
    EXPECT_EQ(iso("sent by  DNC \n %P\nG0 x1 *\n"), "sent by  DNC\n %P\nN10 G0 X+1 *\n");
    EXPECT_EQ(iso("N7 G0 x1 *\n%P *\n"), "N10 G0 X+1 *\n%P *\n");
}

TEST(Format, iso_lines_behind_a_tilde) {
    EXPECT_EQ(iso("%P G71 *\nN5 G200 Drilling~\nQ200 = 2 ;abc ~\n Q201=-5 *\nN7 G01 X1 ~\n  Y2 *\nN8 ;a ~\n N9 x\nN9 "
                  "G0 X1*\n"),
              "%P G71 *\nN10 G200 Drilling ~\n  Q200=2 ;abc ~\n  Q201=-5 *\nN20 G01 X1 ~\n  Y2 *\nN30 ;a ~\n N9 x\n"
              "N40 G0 X+1 *\n");
}

TEST(Format, language_by_content_and_suffix) {
    EXPECT_EQ(language_of("0 BEGIN  PGM P MM\n", "P.H"), Language::klartext);
    EXPECT_EQ(language_of("; x\n%P G71 *\nN10 G0 *\n", "P.I"), Language::iso);
    EXPECT_EQ(language_of("N10 G00 X+1 *\n", "P"), Language::iso);
    EXPECT_FALSE(language_of("#include <vector>\nint x;\n", "x.h"));
    EXPECT_FALSE(language_of("N10 G0 X10\n", "P.MPF"));
}

}  // namespace
}  // namespace obrys::format::heidenhain
