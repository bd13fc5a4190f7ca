#include <gtest/gtest.h>

#include "read/heidenhain/reading.hpp"

namespace obrys::read::heidenhain {

using program::ContourOperator;
using program::ContourStatement;
using program::FigureKind;
using program::FigureRole;
using testing::complaint;
using testing::Reading;

namespace {

program::Pattern pattern(const std::string& text) {
    const Reading r(text);
    EXPECT_EQ(r.messages(), "");
    return r.unit.patterns.size() == 1 ? r.unit.patterns[0] : program::Pattern{};
}

std::vector<FigureRole> roles(const program::PatternFigure& f) {
    std::vector<FigureRole> out;
    for (const auto& s : f.settings) out.push_back(s.role);
    return out;
}

/// What a formula computes, written with all parentheses.
std::string formula(const std::string& text) {
    const Reading r(text);
    return r.messages() + r.tree();
}

}  // namespace

TEST(KlartextPattern, EveryFigureHasItsWords) {
    const auto p = pattern(
        "1 PATTERN DEF POS1 (X+25 Y+33,5 Z+0) POS2( IX+50 IY-3.5 ) ROW1 (X+0 Y+0 D+8 NUM5 ROT+0 Z+0) ~\n"
        " PAT1 (X+0 Y+0 DX+8 DY+10 NUMX5 NUMY4 ROT+0 ROTX+1 ROTY+2 Z+0) FRAME1 (X+0 Y+0 DX+8 DY+10 NUMX5 NUMY4) ~\n"
        " CIRC1 (X+0 Y+0 D80 START+45 NUM8) PITCHCIRC1 (X+0 Y+0 D80 START+45 STEP30 NUM8 Z+0)\n");
    ASSERT_EQ(p.figures.size(), 7u);
    const FigureKind kinds[] = {FigureKind::position, FigureKind::position, FigureKind::row, FigureKind::grid,
                                FigureKind::frame,    FigureKind::circle,   FigureKind::arc};
    for (std::size_t i = 0; i < 7; ++i) EXPECT_EQ(p.figures[i].kind, kinds[i]) << i;
    EXPECT_FALSE(p.figures[0].settings[0].incremental);
    EXPECT_TRUE(p.figures[1].settings[1].incremental);
    using R = FigureRole;
    EXPECT_EQ(roles(p.figures[2]), (std::vector{R::x, R::y, R::spacing, R::count, R::rotation, R::z}));
    EXPECT_EQ(roles(p.figures[3]), (std::vector{R::x, R::y, R::spacing_x, R::spacing_y, R::columns, R::rows,
                                                R::rotation, R::rotation_x, R::rotation_y, R::z}));
    EXPECT_EQ(roles(p.figures[6]),
              (std::vector{R::x, R::y, R::diameter, R::start_angle, R::angle_step, R::count, R::z}));
}

TEST(KlartextPattern, ATableByItsName) {
    for (const char* name : {"\"TNC:\\DIR\\HOLES.PNT\"", "TNC:\\DIR\\HOLES.PNT"}) {
        const Reading r("1 SEL PATTERN " + std::string(name) + "\n");
        EXPECT_EQ(r.messages(), "");
        ASSERT_EQ(r.unit.patterns.size(), 1u);
        EXPECT_EQ(r.unit.texts[r.unit.exprs[r.unit.patterns[0].table].a], "TNC:\\DIR\\HOLES.PNT");
    }
}

TEST(KlartextPattern, Mistakes) {
    EXPECT_EQ(complaint("PATTERN DEF"), "a pattern needs a figure: POS, ROW, PAT, FRAME, CIRC or PITCHCIRC");
    EXPECT_EQ(complaint("PATTERN POS1 (X+0 Y+0)"), "DEF is due behind PATTERN, found 'POS1'");
    EXPECT_EQ(complaint("PATTERN DEF POS1 X+0"), "'(' is due here, found 'X+0'");
    EXPECT_EQ(complaint("PATTERN DEF POS1 (X+0)"), "this figure of the pattern needs Y");
    EXPECT_EQ(complaint("PATTERN DEF POS1 (X+0 Y+0 D+8)"), "this is no word of POS: 'D+8)'");
    EXPECT_EQ(complaint("PATTERN DEF POS1 (X+0 Y+0 X+1)"), "X is given twice");
    EXPECT_EQ(complaint("PATTERN DEF POS1 (X+0 Y+0) POS2 (X+0 Y+0 IZ+1)"),
              "only X and Y may be incremental in a pattern");
    EXPECT_EQ(complaint("SEL PATTERN"), "the name of a point table is due behind SEL PATTERN, found end of block");
    EXPECT_TRUE(Reading("PATTERN DEF POS1 (X+0 Y+0) POS2 (X+0)").unit.patterns[0].figures.empty());
}

TEST(KlartextContour, PartsOfADefinition) {
    const Reading r("1 CONTOUR DEF P1 = LBL 1 I2 = LBL \"ISLE\" DEPTH5 I3 \"TNC:\\A\\B.H\" DEPTH7,5 P4 = QS3\n");
    EXPECT_EQ(r.messages(), "");
    ASSERT_EQ(r.unit.contours.size(), 1u);
    const auto& parts = r.unit.contours[0].parts;
    ASSERT_EQ(parts.size(), 4u);
    EXPECT_FALSE(parts[0].island);
    EXPECT_TRUE(parts[1].island);
    EXPECT_NE(parts[1].label, program::no_expr);
    EXPECT_NE(parts[1].depth, program::no_expr);
    EXPECT_NE(parts[2].program, program::no_expr);
    EXPECT_EQ(parts[3].depth, program::no_expr);
}

TEST(KlartextContour, FormulasFromLeftToRight) {
    EXPECT_NE(formula("1 QC10 = QC1 | QC2 | QC3\n").find("QC10=((QC1 | QC2) | QC3)\n"), std::string::npos);
    EXPECT_NE(
        formula("1 QC10 = ( QC1 | QC2 ) \\ QC3 & QC4 ^ QC5\n").find("QC10=((((QC1 | QC2) \\ QC3) & QC4) ^ QC5) mixed"),
        std::string::npos);
    EXPECT_NE(formula("1 QC10 = QC1 \\ (QC2 & (QC3))\n").find("QC10=(QC1 \\ (QC2 & QC3))\n"), std::string::npos);
    EXPECT_NE(formula("1 QC10=QC1\n").find("QC10=QC1\n"), std::string::npos);
}

TEST(KlartextContour, DeclarationAndSelection) {
    const Reading r(
        "1 DECLARE CONTOUR QC3 = \"SQUARE.H\" DEPTH10\n2 SEL CONTOUR \"MODEL\"\n3 DECLARE STRING QS1 = \"A\"\n");
    EXPECT_EQ(r.messages(), "");
    ASSERT_EQ(r.unit.contours.size(), 2u);
    EXPECT_EQ(r.unit.contours[0].kind, ContourStatement::Kind::declaration);
    EXPECT_EQ(r.unit.contours[0].number, 3u);
    EXPECT_EQ(r.unit.contours[1].kind, ContourStatement::Kind::selection);
}

TEST(KlartextContour, Mistakes) {
    EXPECT_EQ(complaint("CONTOUR DEF I1 = LBL 1"), "the first contour must be a pocket");
    EXPECT_EQ(complaint("CONTOUR DEF V1 = LBL 1"),
              "P with a number (pocket) or I with a number (island) is due here, found 'V1'");
    EXPECT_EQ(complaint("QC10 = ( QC1 | QC2"), "this parenthesis is not closed");
    EXPECT_EQ(complaint("QC10 = QC1 # QC2"), "this does not belong to a contour: '#'");
    EXPECT_EQ(complaint("QC10 = QC1 |"), "a contour (QC with a number) is due here, found end of block");
    const std::string deep = "QC1 = " + std::string(5000, '(') + "QC2" + std::string(5000, ')');
    EXPECT_EQ(complaint(deep), "the parentheses of this formula are nested too deep");
}

TEST(KlartextCycle, CallsAtPlaces) {
    using program::Modal;
    EXPECT_NE(formula("1 CYCL CALL PAT FMAX M8\n").find(testing::modal(Modal::cycle_pattern)), std::string::npos);
    EXPECT_NE(formula("1 CYCL CALL PAT FMAX M8\n").find(testing::modal(Modal::rapid)), std::string::npos);
    EXPECT_EQ(formula("1 CYCL CALL PAT F200\n").find(testing::modal(Modal::rapid) + " "), std::string::npos);
    EXPECT_NE(formula("1 CYCL CALL POS X+1 Y+2 Z+3 FMAX\n").find(testing::modal(Modal::cycle_position)),
              std::string::npos);
}

}  // namespace obrys::read::heidenhain
