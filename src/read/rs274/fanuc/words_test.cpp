#include <gtest/gtest.h>

#include "read/rs274/fanuc/reading.hpp"

namespace obrys::read::rs274 {

using program::Modal;
using testing::fanuc;
using testing::m;
using testing::on_haas;
using testing::on_mill;
using testing::program;
using testing::Reading;

namespace {

/// The first statement behind the units' one, whatever is assumed.
std::string first(const Reading& r, std::uint32_t statement = 1) {
    return program::testing::TreeText(r.unit(), r.names).statement(statement);
}

Reading with(const std::string& text, const FanucOptions& options) {
    static FanucOptions said;
    said = options;
    return Reading(text, "TEST.NC",
                   [](std::uint32_t file, const base::Sources& s, program::Names& n, base::Diagnostics& d) {
                       return read_fanuc(file, s, n, d, said);
                   });
}

}  // namespace

TEST(FanucWords, NumbersWithoutPointAreIncrements) {
    EXPECT_EQ(first(fanuc(program("G0 X1000 Y-5 Z2. B90000"))), "X1 Y-0.005 Z2 B90 " + m(Modal::rapid));
    EXPECT_EQ(first(fanuc("%\nO1\nG20\nG0 X1000 B1000\nM30\n%\n")), "X0.1 B1 " + m(Modal::rapid));
    EXPECT_EQ(first(fanuc(program("G2 X1. I500 J-500"))), "X1 I0.5 J-0.5 " + m(Modal::arc_cw));
    EXPECT_EQ(first(fanuc(program("G0 X[1000] Y#1"))), "X=1000 Y=#1 " + m(Modal::rapid))
        << "values are never increments";
    EXPECT_EQ(first(fanuc(program("G1 X1. F100"))), "F100 X1 " + m(Modal::linear));
    EXPECT_EQ(first(fanuc("%\nO1\nG20\nG1 X1. F100\nM30\n%\n")), "F1 X1 " + m(Modal::linear));
}

TEST(FanucWords, WithoutG20AndG21TheUnitIsAskedForWhenTheBlockIsRun) {
    EXPECT_EQ(first(fanuc("%\nO1\nG0 X1000\nM99\n%\n"), 0),
              "X=(1000 * (0.001r + (-0.0009r * G20#" +
                  std::to_string(static_cast<int>(program::SystemVariable::state)) + "[7]))) " + m(Modal::rapid));
}

TEST(FanucWords, TheReadingIsSaidOnceAndCanBeChosen) {
    const Reading r = fanuc(program("G0 X1000\nX2000 Y3000\n"));
    ASSERT_EQ(r.diagnostics.all().size(), 1U);
    EXPECT_EQ(r.diagnostics.all()[0].severity, base::Severity::warning);
    EXPECT_EQ(r.diagnostics.all()[0].code, "assumption");
    EXPECT_NE(r.diagnostics.all()[0].remedy.find("3401"), std::string::npos);
    EXPECT_EQ(fanuc(program("G0 X0 Y5.\nG4 P500\nS1000 M3\nG43 H1 Z5.")).messages(), "");
    const Reading units = with(program("G0 X10\n"), {.whole_numbers = dialect::rs274::WholeNumbers::units});
    EXPECT_EQ(first(units), "X10 " + m(Modal::rapid));
    EXPECT_EQ(units.diagnostics.all().size(), 1U);
    EXPECT_NE(testing::haas(program("G0 X10")).diagnostics.all()[0].remedy.find("162"), std::string::npos);
}

TEST(FanucWords, Dwells) {
    EXPECT_EQ(on_mill("G4 P500"), "P0.5 " + m(Modal::dwell));
    EXPECT_EQ(on_mill("G4 X1.5"), "P1.5 " + m(Modal::dwell));
    EXPECT_EQ(on_haas("G4 P2."), "P2 " + m(Modal::dwell));
    EXPECT_EQ(on_mill("G4 P#1"), "P=(#1 / 1000) " + m(Modal::dwell));
}

TEST(FanucWords, WordsComeInTheOrderOfExecution) {
    EXPECT_EQ(on_mill("X1. G43 H1 G0 G54 M6 T1"),
              "T1 M6 X1 H-offset1 act " + m(Modal::tool_length) + " " + m(Modal::datum, 54) + " " + m(Modal::rapid));
    EXPECT_EQ(on_mill("G91 G28 Z0"), "Z0 " + m(Modal::incremental) + " " + m(Modal::home, 1));
    EXPECT_EQ(on_mill("G30 P3 Z0"), "Z0 " + m(Modal::home, 3));
    EXPECT_EQ(on_mill("G92 S3000"), "LIMS3000");
    EXPECT_EQ(on_mill("G92 X0 Y0"), "X0 Y0 " + m(Modal::position_becomes));
    EXPECT_EQ(on_mill("G1 X1. ,C2. ,R3. F100\nX5."),
              "F100 X1 CHR2 unsupported{,R3.|the block has two corners (alarm 53)} " + m(Modal::linear) + "\nX5");
}

TEST(FanucWords, WorkOffsets) {
    EXPECT_EQ(on_mill("G54.1 P2 X1."), "X1 " + m(Modal::datum, 5402));
    EXPECT_EQ(on_mill("G54 P48"), m(Modal::datum, 5448));
    EXPECT_EQ(on_haas("G154 P7"), m(Modal::datum, 5407));
    EXPECT_EQ(on_haas("G110"), m(Modal::datum, 5401));
    EXPECT_EQ(on_mill("G54.1 P#1"), "unsupported{G54.1|a work offset by a number that is not written}");
    using program::DataTable;
    const auto writes = [](DataTable t) { return m(Modal::set_data, static_cast<int>(t)); };
    EXPECT_EQ(on_mill("G10 L2 P1 X1."), "P1 X1 " + writes(DataTable::datum));
    EXPECT_EQ(on_mill("G10 L2 P0 X1."), "P0 X1 " + writes(DataTable::external_datum));
    EXPECT_EQ(on_mill("G10 L20 P1 X1."), "P1 X1 " + writes(DataTable::extended_datum));
    EXPECT_EQ(on_mill("G10 L12 P1 R5."), "P1 CR5 " + writes(DataTable::tool_radius));
    EXPECT_EQ(on_haas("G10 L12 P1 R5."), "P1 CR5 " + writes(DataTable::tool_diameter));
    EXPECT_EQ(on_mill("G10 L50"), "unsupported{G10 L50|sets parameters of the control}");
}

TEST(FanucWords, MachineCoordinatesAreReachedInRapidTraverse) {
    EXPECT_EQ(on_mill("G1 X1. F100\nG53 Z0\nX2."), "F100 X1 " + m(Modal::linear) + "\nZ0 " + m(Modal::suppress_all) +
                                                       " " + m(Modal::rapid) + "\n+" + m(Modal::linear) + "\nX2");
    EXPECT_EQ(on_mill("G0 G53 Z0"), "Z0 " + m(Modal::suppress_all) + " " + m(Modal::rapid));
}

TEST(FanucWords, HoleCycles) {
    // The index of the cycle in the traits; K repeats, P is milliseconds, Q increments.
    EXPECT_EQ(on_mill("G99 G82 X1. Y2. Z-3. R1. P250 K2 F50"),
              "F50 X1 Y2 Z-3 CR1 P0.25 L2 act " + m(Modal::retract_clearance) + " " + m(Modal::canned, 4));
    EXPECT_EQ(on_mill("G87 X1. Z-3. R-10. Q1. F50"), "F50 X1 E-3 Z-10 Q1 " + m(Modal::canned, 9));
    EXPECT_EQ(on_mill("G81 Z-1. R1. F50\nX5. K3\nG80 X6. K3."),
              "F50 Z-1 CR1 " + m(Modal::canned, 3) + "\nX5 L3\nX6 K3 " + m(Modal::canned_off));
    EXPECT_EQ(on_haas("G83 Z-1. R1. I.5 J.1 K.2 F50."), "F50 Z-1 CR1 I0.5 J0.1 K0.2 " + m(Modal::canned, 5));
}

TEST(FanucWords, HaasPatternsOfHoles) {
    const std::string tree = on_haas("G81 Z-1. R1. F50. L0\nG70 I5. J90. L2");
    EXPECT_NE(tree.find("X=q1(0"), std::string::npos) << tree;
    EXPECT_NE(tree.find("Y=q1(5"), std::string::npos) << tree;
    EXPECT_NE(tree.find("Y=q1(-10"), std::string::npos) << tree;
    EXPECT_EQ(on_haas("G70 I5. J90. L2"), "unsupported{G70|the hole pattern needs a hole cycle before it}");
    EXPECT_EQ(on_haas("G81 Z-1. R1. F50. L0\nG72 I5. J90. L2").find("holes along a line") == std::string::npos, false);
}

TEST(FanucWords, WhatIsNotRunIsNamed) {
    EXPECT_EQ(on_mill("G43.4 H1 Z5."), "unsupported{G43.4|tool centre point control} H-offset1 Z5");
    EXPECT_EQ(on_haas("G150 X1. Y1."),
              "unsupported{G150|general purpose pocket milling: the manual does not have the order of its rows}");
    EXPECT_EQ(on_haas("G12 I1. D1 F10."), "F10 I1 D-offset1 act " + m(Modal::circle_pocket));
    EXPECT_EQ(on_mill("G777 X1."), "unknown{G777|}");
    EXPECT_EQ(on_mill("G#1 X1."), "unsupported{G#1|a G code that is computed}");
    EXPECT_EQ(on_mill("M250"), "M250");
    const Reading r = testing::haas(program("G187 P2 E0.01\nM31"));
    EXPECT_EQ(r.messages(), "");
    ASSERT_EQ(r.unit().ignored.size(), 1U);
    EXPECT_EQ(r.unit().ignored[0].text, "M31");
}

TEST(FanucWords, Transformations) {
    EXPECT_EQ(on_mill("G68 X1. Y2. R30.\nG69"),
              "X=1r Y=2r RPL=30r " + m(Modal::rotation_on) + "\n" + m(Modal::rotation_off));
    EXPECT_EQ(on_mill("G51 X0 Y0 Z0 P2000"), "X=0 Y=0 Z=0 P=2r " + m(Modal::scaling_on));
    EXPECT_EQ(on_mill("G51.1 X5.\nG50.1 X0"), "X=5r " + m(Modal::mirror_on) + "\nX=0 " + m(Modal::mirror_off));
    EXPECT_EQ(on_mill("G16\nG1 X10. Y45. F5\nG15\nX1."),
              "X0 Y0 " + m(Modal::pole_from_zero) + "\nF5 RP10 AP45 " + m(Modal::linear) + "\n\nX1");
}

TEST(FanucWords, ErrorsMarkTheWord) {
    EXPECT_EQ(on_mill("G0 X"), "4:4 X has no value");
    EXPECT_EQ(on_mill("G0 X1. ["), "4:8 '[' cannot stand here");
    EXPECT_EQ(on_mill("(open"), "4:1 the comment is not closed");
    EXPECT_EQ(on_mill("G0 X1. Z[#1"), "4:9 this bracket is not closed");
    EXPECT_EQ(on_mill("G68 X0 Y0"), "4:1 the angle of the rotation is missing");
    EXPECT_EQ(on_mill("(a (b) c)\n((x)\nX1."), "X1");
}

}  // namespace obrys::read::rs274
