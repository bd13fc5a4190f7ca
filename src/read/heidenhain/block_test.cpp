#include <gtest/gtest.h>
#include <algorithm>
#include <cmath>

#include "dialect/heidenhain/m_functions.hpp"
#include "dialect/heidenhain/traits.hpp"
#include "read/heidenhain/reading.hpp"

namespace obrys::read::heidenhain {

using program::Modal;
using testing::complaint;
using testing::modal;
using testing::one;
using testing::Reading;

namespace {
const std::string straight = modal(Modal::linear);
const std::string rapid = modal(Modal::rapid);
}  // namespace

TEST(KlartextBlock, StraightLines) {
    EXPECT_EQ(one("5 L X+10 Y-2.5 Z+0"), straight + " X10 Y-2.5 Z0");
    EXPECT_EQ(one("5 L  X10   Y.5"), straight + " X10 Y0.5");
    EXPECT_EQ(one("L X+1 A-30 C+90"), straight + " X1 A-30 C90");
    EXPECT_EQ(one("5 L U+1 V+2 W+3"), straight + " U1 V2 W3");
    EXPECT_EQ(one("5 L"), straight);
}

/// The table of M functions says when each acts, the traits say it to the run: for those that are modes of the run both
/// are held to each other here. Of corners and cycle calls the end of the block is where they act anyhow.
TEST(KlartextBlock, ModesThatActAtTheEndOfTheirBlockAreToldToTheRun) {
    const auto& behind = dialect::heidenhain::traits.modes_behind_motion;
    std::size_t seen = 0;
    for (const dialect::heidenhain::MFunction& m : dialect::heidenhain::all_m()) {
        if (m.use != dialect::heidenhain::Use::run) continue;
        const std::string block = one("L X+10 M" + std::to_string(m.number));
        const std::string begin = straight + " X10 m";
        if (!block.starts_with(begin)) continue;  // no mode
        const bool corner = block == straight + " X10 " + modal(Modal::corner_crossing) ||
                            block == straight + " X10 " + modal(Modal::corner_open);
        const bool told = std::any_of(behind.begin(), behind.end(),
                                      [&](Modal mode) { return block == straight + " X10 " + modal(mode); });
        if (corner) continue;
        EXPECT_EQ(told, m.when == dialect::heidenhain::When::end) << "M" << m.number << ": " << block;
        seen += told ? 1 : 0;
    }
    EXPECT_EQ(seen, behind.size());
}

TEST(KlartextBlock, CommaAndPointAreTheSame) {
    EXPECT_EQ(one("9 L Z-2,5 F100"), one("9 L Z-2.5 F100"));
    EXPECT_EQ(one("9 L Z-,5 R0"), one("9 L Z-.5 R0"));
    EXPECT_EQ(one("CR X+1 Y+2 R7,5 DR+"), one("CR X+1 Y+2 R7.5 DR+"));
    EXPECT_EQ(one("Q1 = 2,25"), "Q1=2.25r");
}

TEST(KlartextBlock, LowerCaseIsRead) {
    EXPECT_EQ(one("5 l x+10 r0 fmax m3"), one("5 L X+10 R0 FMAX M3"));
    EXPECT_EQ(one("fn 9: if +q1 equ +q2 goto lbl 5"), one("FN 9: IF +Q1 EQU +Q2 GOTO LBL 5"));
    EXPECT_EQ(one("q1 = sqrt q2"), one("Q1 = SQRT Q2"));
}

TEST(KlartextBlock, BlockNumbersAreNoMatter) {
    for (const char* number : {"", "0 ", "5 ", "0010 ", "99999 ", "  7 "})
        EXPECT_EQ(one(std::string(number) + "L X+1"), straight + " X1") << number;
    EXPECT_EQ(one("5L X+1"), straight + " X1");
    EXPECT_EQ(one("5CC X+1 Y+2"), one("5 CC X+1 Y+2"));
}

TEST(KlartextBlock, SkippedBlocks) {
    EXPECT_EQ(one("/5 L X+1"), "/0 " + straight + " X1");
    EXPECT_EQ(one("5 /L X+1"), "/0 " + straight + " X1");
    EXPECT_EQ(one("5/ L X+1"), "/0 " + straight + " X1");
    EXPECT_EQ(Reading("/5 L X+1\n6 L X+2\n").tree(), "0 /0 " + straight + " X1\n1 " + straight + " X2\n");
}

TEST(KlartextBlock, FeedForms) {
    for (const char* f : {"F MAX", "FMAX", "f max", "F  MAX"})
        EXPECT_EQ(one(std::string("L X+1 ") + f), rapid + " X1") << f;
    EXPECT_EQ(one("L X+1 F 100"), straight + " X1 F100");
    EXPECT_EQ(one("L X+1 FQ5"), straight + " X1 F=Q5");
    EXPECT_EQ(one("L X+1 F AUTO"), straight + " X1 F-auto");
    EXPECT_EQ(one("L X+1 FAUTO"), one("L X+1 F AUTO"));
    EXPECT_EQ(one("L X+1 FZ0.1"), straight + " X1 FZ0.1");
    EXPECT_EQ(one("L X+1 FU0,2"), straight + " X1 FU0.2");
    EXPECT_EQ(one("F100"), "F100");
    EXPECT_EQ(one("L X+1 F M"), straight + " X1");  // keys pressed, nothing entered
}

TEST(KlartextBlock, IncrementalWords) {
    EXPECT_EQ(one("L IX+10 Y-2 IZQ5"), straight + " X=q1(10) Y-2 Z=q1(Q5)");
    EXPECT_EQ(one("L IX-Q5"), straight + " X=q1((neg Q5))");
    EXPECT_EQ(one("IZ-3"), straight + " " + modal(Modal::paraxial) + " Z=q1(-3)");
}

TEST(KlartextBlock, PolarWords) {  // the path function says that it takes no coordinates of the plane
    const std::string line = modal(Modal::linear, program::polar_path);
    EXPECT_EQ(one("LP PR+10 PA+30"), line + " RP10 AP30");
    EXPECT_EQ(one("LP IPA+30"), line + " AP=q1(30)");
    EXPECT_EQ(one("LP IPR-1"), line + " RP=q1(-1)");
    const std::string arc = modal(Modal::arc_same_sense, program::polar_path) + " about-pole";
    EXPECT_EQ(one("CP PA+90 DR+"), arc + " AP90 " + modal(Modal::arc_ccw));
    EXPECT_EQ(one("CP IPA-720 IZ-5 DR-"), arc + " pole-angle-720 Z=q1(-5) " + modal(Modal::arc_cw));
    EXPECT_EQ(one("CTP PR+5 PA-30"), modal(Modal::arc_tangent, program::polar_path) + " RP5 AP-30");
}

TEST(KlartextBlock, Arcs) {
    EXPECT_EQ(one("CC X+1 Y+2"), modal(Modal::pole_given) + " X1 Y2");
    EXPECT_EQ(one("CC"), modal(Modal::pole_given));
    EXPECT_EQ(one("CC IX+1"), modal(Modal::pole_given) + " X=q1(1)");
    const std::string same = modal(Modal::arc_same_sense), ccw = modal(Modal::arc_ccw), cw = modal(Modal::arc_cw);
    EXPECT_EQ(one("C X+1 Y+2 DR+"), same + " about-pole X1 Y2 " + ccw);
    EXPECT_EQ(one("C X+1 Y+2 DR- RL F100 M3"),
              same + " about-pole X1 Y2 " + cw + " " + modal(Modal::compensation_left) + " F100 M3");
    EXPECT_EQ(one("CR X+1 Y+2 R+5 DR-"), same + " X1 Y2 CR5 " + cw);
    EXPECT_EQ(one("CR X+1 Y+2 R-5 DR+ RR"), same + " X1 Y2 CR-5 " + ccw + " " + modal(Modal::compensation_right));
    EXPECT_EQ(one("CR X+1 Y+2 RQ5 DR+"), same + " X1 Y2 CR=Q5 " + ccw);
    EXPECT_EQ(one("CR X+1 Y+2 R5 R0 DR+"), same + " X1 Y2 CR5 " + modal(Modal::compensation_off) + " " + ccw);
    EXPECT_EQ(one("CT X+1 Y+2"), modal(Modal::arc_tangent) + " X1 Y2");
    EXPECT_EQ(complaint("C X+1 Y+2 DR"), "DR needs the sense of rotation");
    EXPECT_EQ(one("C+90"), straight + " " + modal(Modal::paraxial) + " C90");  // the axis C alone
}

TEST(KlartextBlock, Compensation) {
    EXPECT_EQ(one("L X+1 R0"), straight + " X1 " + modal(Modal::compensation_off));
    EXPECT_EQ(one("L X+1 RL"), straight + " X1 " + modal(Modal::compensation_left));
    EXPECT_EQ(one("L X+1 RR"), straight + " X1 " + modal(Modal::compensation_right));
    EXPECT_EQ(one("L X+1 R F MAX"), rapid + " X1");
    EXPECT_EQ(one("X+1 R+"), straight + " " + modal(Modal::paraxial) + " X1 " + modal(Modal::paraxial_longer));
    EXPECT_EQ(one("X+1 R- F100"),
              straight + " " + modal(Modal::paraxial) + " X1 " + modal(Modal::paraxial_shorter) + " F100");
    EXPECT_EQ(one("X+1 R0 FMAX"), rapid + " " + modal(Modal::paraxial) + " X1 " + modal(Modal::compensation_off));
    EXPECT_EQ(complaint("L X+1 RX"), "R0, RL, RR, R+ or R- is due here, found 'X'");
}

TEST(KlartextBlock, ChamferAndRoundingBelongToTheElementBefore) {
    EXPECT_EQ(Reading("1 L X+1\n2 RND R5 F20\n3 L Y+1\n").tree(),
              "0 " + straight + " X1 RND5 FRC20\n1 \n2 " + straight + " Y1\n");
    EXPECT_EQ(Reading("1 L X+1\n2 CHF 2,5\n").tree(), "0 " + straight + " X1 CHR2.5\n1 \n");
    EXPECT_EQ(Reading("1 L X+1\n2 RND RQ3\n").tree(), "0 " + straight + " X1 RND=Q3\n1 \n");
    EXPECT_EQ(complaint("1 Q1 = 1\n2 RND R5"), "a chamfer or rounding needs a contour element directly before it");
    EXPECT_EQ(complaint("1 L X+1\n2 RND 10"), "RND has no R before its radius");
    EXPECT_EQ(complaint("1 L X+1\n2 CHF R3"), "CHF has no R: its length stands behind it");
    EXPECT_EQ(complaint("1 L X+1\n2 RND R5 X+5"), "only a feed may follow here, found 'X+5'");
}

TEST(KlartextBlock, MFunctions) {
    EXPECT_EQ(one("L X+1 M3"), straight + " X1 M3");
    EXPECT_EQ(one("L M03"), straight + " M3");
    EXPECT_EQ(one("M5 M9"), "M5 M9");
    EXPECT_EQ(one("L X+1 M13"), straight + " X1 M3 M8");
    EXPECT_EQ(one("L X+1 M14"), straight + " X1 M4 M8");
    EXPECT_EQ(one("L Z-1 M91"), straight + " Z-1 " + modal(Modal::suppress_all));
    EXPECT_EQ(one("L X+1 M99"), straight + " X1 cycle-call");
    EXPECT_EQ(one("L X+1 MQ5"), straight + " X1 M=Q5");
    EXPECT_EQ(one("L X+1 M"), straight + " X1");
    EXPECT_EQ(complaint("L X+1 M3.5"), "M needs the whole number of a function");
}

TEST(KlartextBlock, ProgramFrame) {
    EXPECT_EQ(one("0 BEGIN PGM TEST MM\n1 END PGM TEST MM"), modal(Modal::metric_all));
    EXPECT_EQ(one("0 BEGIN PGM TEST INCH\n1 END PGM TEST INCH"), modal(Modal::inch_all));
    EXPECT_EQ(one("0 BEGIN PGM T INCH\n1 END PGM T INCH"), modal(Modal::inch_all));
    EXPECT_TRUE(Reading("0 BEGIN PGM TEST INCH\n1 END PGM TEST INCH\n").unit.inch);
    EXPECT_FALSE(Reading("0 BEGIN PGM TEST MM\n1 END PGM TEST MM\n").unit.inch);
    EXPECT_EQ(Reading("0 BEGIN PGM INCH MM\n1 END PGM INCH MM\n").unit.inch, false);
}

TEST(KlartextBlock, BlankForm) {
    const Reading r(
        "0 BEGIN PGM T MM\n1 BLK FORM 0.1 Z X+0 Y-1,5 Z-40\n2 BLK FORM 0.2 X+100 Y+50 Z+0\n3 END PGM T MM\n");
    EXPECT_EQ(r.messages(), "");
    ASSERT_TRUE(r.unit.blank);
    EXPECT_EQ(r.unit.blank->tool_axis, 2);
    EXPECT_EQ(r.unit.blank->min, (std::array<double, 3>{0, -1.5, -40}));
    EXPECT_EQ(r.unit.blank->max, (std::array<double, 3>{100, 50, 0}));
    const Reading chain(
        "0 BEGIN PGM T MM\n1 BLK FORM 0.1 Z X-5 Y+0 Z-40\n2 BLK FORM 0.2 IX+100 Y+50 IZ+40\n3 END PGM T MM\n");
    EXPECT_EQ(chain.messages(), "");
    ASSERT_TRUE(chain.unit.blank);
    EXPECT_EQ(chain.unit.blank->max, (std::array<double, 3>{95, 50, 0}));
    const Reading half("0 BEGIN PGM T MM\n1 BLK FORM 0.1 Z X-5 Y+0 Z-40\n3 END PGM T MM\n");
    ASSERT_TRUE(half.unit.blank);
    EXPECT_TRUE(std::isnan(half.unit.blank->max[0]));
    EXPECT_EQ(complaint("BLK FORM 0.1 Z X+0 Q5"), "X, Y or Z is due here, found 'Q5'");
    EXPECT_EQ(complaint("BLK FROM 0.1"), "FORM is due behind BLK, found 'FROM'");
}

TEST(KlartextBlock, StopStopsAndShowsTheCommentBehindIt) {
    EXPECT_EQ(one("STOP"), modal(Modal::program_stop));
    EXPECT_EQ(one("STOP M0"), "M0");
    EXPECT_EQ(one("STOP M30"), "M30");
    EXPECT_EQ(one("STOP M8"), "M8 " + modal(Modal::program_stop));
    EXPECT_EQ(Reading("1 STOP\n2 ; tool \xFC"
                      "ber\n3 ; not shown\n4 L X+1\n5 ; nor this\n")
                  .tree(),
              "0 " + modal(Modal::program_stop) +
                  "\n1 procedure 0(\"tool \xC3\xBC"
                  "ber\")\n2 " +
                  straight + " X1\n");
}

TEST(KlartextBlock, CommentsAndStructureBlocks) {
    EXPECT_EQ(Reading("1 ; X+5\n;\n3 * - chapter\n* another\n").tree(), "");
    EXPECT_EQ(one("L X+1 ; Y+2"), straight + " X1");
    EXPECT_EQ(one("L X+1;Y+2"), straight + " X1");
    EXPECT_EQ(Reading("1 * - chapter\n2 L X+1\n").messages(), "");
}

TEST(KlartextBlock, MisspeltWordsAreSaidWithTheirPlace) {
    EXPECT_EQ(Reading("5 L X+1\n6 LINE X+5\n").tree(),
              "0 " + straight + " X1\n1 unknown{LINE X+5|no block begins with 'LINE'}\n");
    EXPECT_EQ(Reading("5 CALLL LBL 1\n").tree(), "0 unknown{CALLL LBL 1|no block begins with 'CALLL'}\n");
    EXPECT_EQ(Reading("5 XYZ+5\n").tree(), "0 unknown{XYZ+5|no block begins with 'XYZ+5'}\n");
    EXPECT_EQ(Reading("5 FMXA\n").tree(), "0 unknown{FMXA|no block begins with 'FMXA'}\n");
    EXPECT_EQ(Reading("7 L X+1 K+5\n").messages(),
              "TEST.H:1:9: error: this is no word of a path block: 'K+5' [syntax]\n  7 L X+1 K+5\n          ^~~\n");
    EXPECT_EQ(complaint("L X"), "the word 'X' has no value: a number or a Q parameter must follow");
    EXPECT_EQ(complaint("L X+"), "the word 'X' has no value: a number or a Q parameter must follow");
    EXPECT_EQ(complaint("CALL X"), "LBL or PGM is due behind CALL, found 'X'");
    EXPECT_EQ(complaint("TOOL X"), "CALL or DEF is due behind TOOL, found 'X'");
    EXPECT_EQ(complaint("CYCL X"), "DEF or CALL is due behind CYCL, found 'X'");
}

TEST(KlartextBlock, NumbersTheControlCannotHold) {
    EXPECT_EQ(complaint("L X" + std::string(400, '9')), "this number is too large");
    EXPECT_EQ(complaint("Q1 = " + std::string(400, '9')), "this number is too large");
    EXPECT_EQ(complaint("Q1 = 1E999"), "this number is too large");
    EXPECT_EQ(one("Q1 = 1E-999"), "Q1=0r");
    EXPECT_EQ(one("Q1 = 2.5E+2"), "Q1=250r");
    EXPECT_EQ(one("Q1 = 2.5E-002"), "Q1=0.025r");
    EXPECT_EQ(one("L X+12345678901.25"), straight + " X12345678901.25");
    EXPECT_EQ(one("L X+1.12345678901"), straight + " X1.12345678901");
}

}  // namespace obrys::read::heidenhain
