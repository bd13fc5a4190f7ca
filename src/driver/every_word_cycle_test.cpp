/// As every_word_test.cpp: words in cycles, calls, jumps and structure words, and on lathes.

#include "driver/every_word_testing.hpp"

namespace obrys::driver {
namespace {

using namespace testing;

constexpr std::string_view fanuc_before = "%\nO0001\nG21 G17 G90 G94\nT1 M6\nG0 G43 H1 X1. Y2. Z3.\nS100 M3\nF50.\n";
constexpr std::string_view fanuc_after =
    "N20 X9. Y8.\nG1 X20. Y21. Z1.\nX40. Y9.\nG40 G67 G69 G80\nM6\nM3\nG0 X0. Y1.\nM30\nN100 G1 Y3.\nM99\n"
    "O2000\nG91 G1 X#1 Y[3+#8+#9+#11+#19+#20]\nG90\nM99\n%\n";

/// Cycles, and codes that need what stands around them.
Way fanuc_cycles(std::string_view control) {
    return {control,
            "in.nc",
            fanuc_before,
            fanuc_after,
            {"G73 X5. Z-5. R1. Q2.",
             "G74 X5. Z-5. R1.",
             "G76 X5. Z-5. R1. Q1.",
             "G82 X5. Z-5. R1. P100",
             "G84 X5. Z-5. R1.",
             "G85 X5. Z-5. R1.",
             "G86 X5. Z-5. R1.",
             "G89 X5. Z-5. R1. P100",
             "G98 G81 X5. Z-5. R1.\nX9.\nG80",
             "G30 Z9.",
             "G31 Z1.",
             "G33 Z1. F1.",
             "G51.1 X0.\nG50.1 X0.",
             "G54.1 P1",
             "G55",
             "G95",
             "G96 S10",
             "G91 G28 Z0.",
             "M6",
             "M19",
             "M1"},
            letters,
            shop::MachineKind::mill,
            {},
            true};
}

/// Statements and calls: words that stand in their block.
Way fanuc_statements(std::string_view control) {
    return {control,
            "in.nc",
            fanuc_before,
            fanuc_after,
            {"#1=5", "GOTO20", "IF[#0 EQ #0]GOTO20", "IF[#0 EQ #0]THEN #2=5", "WHILE[#0 NE #0]DO1\nEND1", "M98 P2000",
             "G65 P2000 A1.", "G66 P2000 A1.", "DPRNT[X#1[42]]", "POPEN\nPCLOS"},
            letters,
            shop::MachineKind::mill,
            {},
            true};
}

TEST(EveryWord, OfCyclesOfFanucIsActedOnOrSaid) { EXPECT_EQ(without_effect(fanuc_cycles("fanuc")), ""); }
TEST(EveryWord, OfStatementsOfFanucIsActedOnOrSaid) { EXPECT_EQ(without_effect(fanuc_statements("fanuc")), ""); }
TEST(EveryWord, OfStatementsOfHaasIsActedOnOrSaid) { EXPECT_EQ(without_effect(fanuc_statements("haas")), ""); }

TEST(EveryWord, OfCyclesOfHaasIsActedOnOrSaid) {
    Way way = fanuc_cycles("haas");
    for (const std::string_view block :
         {"G12 I10. D1 Z-1.", "G13 I10. K20. Q2. D1 Z-1.", "G81 X5. Z-5. R1. L0\nG70 I10. J0. L4\nG80",
          "G81 X5. Z-5. R1. L0\nG71 I10. J0. K90. L4\nG80", "G154 P1", "G110", "G187 P1", "G103 P1", "M97 P100",
          "G83 X5. Z-5. R1. I2. J1. K1."})
        way.blocks.push_back(block);
    EXPECT_EQ(without_effect(way), "");
}

/// Roughing cycles stand without G70: what acts in G70 alone is said by docs/dialects/fanuc.md.
Way fanuc_lathe(std::string_view control) {
    return {control,
            "in.nc",
            "%\nO0001\nG21 G18 G40 G80 G99\nT0101\nG0 X50. Z5.\nG97 S100 M3\nF0.2\n",
            "G1 X40. Z-1.\nX45. Z-9.\nG0 X60. Z9.\nM30\n%\n",
            {"G0 X30.",
             "G1 X30. Z-5.",
             "G1 Z-5.",
             "G2 X40. Z0. R9.",
             "G3 X40. Z0. I-5. K0.",
             "G32 Z-5. F1.",
             "G90 X30. Z-5. F.2",
             "G92 X30. Z-5. F1.5",
             "G94 X30. Z-5. F.2",
             "G83 Z-5. R1. Q1000 F.1",
             "G84 Z-5. R1. F1.",
             "G85 Z-5. R1. F1.",
             "G74 R1.\nG74 X30. Z-5. P1000 Q1000 F.1",
             "G75 R1.\nG75 X30. Z-5. P1000 Q1000 F.1",
             "G76 P020060 Q50 R.05\nG76 X30. Z-5. P600 Q200 F1.",
             "G71 U2. R1.\nG71 P10 Q20 U.5 W.1 F.2\nN10 G0 X30.\nN15 G1 Z-5.\nN20 X50.",
             "G72 W2. R1.\nG72 P10 Q20 U.5 W.1 F.2\nN10 G0 Z-5.\nN15 G1 X30.\nN20 Z5.",
             "G73 U2. W1. R2\nG73 P10 Q20 U.5 W.1 F.2\nN10 G0 X30.\nN15 G1 Z-5.\nN20 X50.",
             "G4 X1.",
             "G4 P100",
             "G50 S1000",
             "G96 S100",
             "G98",
             "G99",
             "G28 U0",
             "G28 U0 W0",
             "G30 U0",
             "G40",
             "G41",
             "G42 X30.",
             "G10 L2 P1 X1.",
             "G53 X0.",
             "G54",
             "M3",
             "M8",
             "M5",
             "T0202",
             "G50 X10. Z10."},
            {"A7.", "B7.", "C7.",   "D2",  "E7.", "F.7", "H2",  "I7.", "J7.", "K7.",  "L2",   "P7",   "Q7",
             "R7.", "S7",  "T0202", "U7.", "V7.", "W7.", "X7.", "Y7.", "Z7.", ",C1.", ",R1.", ",A30."},
            shop::MachineKind::lathe,
            {},
            true};
}

TEST(EveryWord, OfLathesOfFanucIsActedOnOrSaid) { EXPECT_EQ(without_effect(fanuc_lathe("fanuc")), ""); }
TEST(EveryWord, OfLathesOfHaasIsActedOnOrSaid) { EXPECT_EQ(without_effect(fanuc_lathe("haas")), ""); }

TEST(EveryWord, OfCyclesAndCallsOfLinuxcncIsActedOnOrSaid) {
    const Way way{
        "linuxcnc",
        "in.ngc",
        "o100 sub\nG91 G1 X#1 Y3\nG90\no100 endsub\nG21 G17 G90 G94\nT1 M6\nG0 G43 H1 X1 Y2 Z3\nS100 M3\nF50\n",
        "G0 X9 Y8\nG1 X20 Y21 Z1 A1 B1 C1 F60\nG40 G80\nM6\nM3\nG43 H1\nG0 X0 Y1\nM2\n",
        {"G73 X5 Z-5 R1 Q2",
         "G82 X5 Z-5 R1 P0.5",
         "G85 X5 Z-5 R1",
         "G86 X5 Z-5 R1 P0.5",
         "G89 X5 Z-5 R1 P0.5",
         "G98 G81 X5 Z-5 R1\nX9\nG80",
         "G33.1 Z1 K1",
         "G38.2 Z1",
         "G10 L1 P1 Z5",
         "G43.1 Z5",
         "G43.2 H2",
         "G59.3",
         "G61",
         "G95",
         "G96 S10",
         "M61 Q2",
         "M64 P1",
         "M68 E0 Q1",
         "M70\nM72",
         "T2",
         "M6",
         "#5=5",
         "o100 call [1]",
         "o200 if [1 EQ 1]\no200 endif",
         "o201 while [1 EQ 2]\no201 endwhile",
         "o202 repeat [1]\no202 endrepeat"},
        letters,
        shop::MachineKind::mill,
        {},
        true};
    EXPECT_EQ(without_effect(way), "");
}

TEST(EveryWord, OfLathesOfLinuxcncIsActedOnOrSaid) {
    const Way way{
        "linuxcnc",
        "in.ngc",
        "o100 sub\nG0 X10\nG1 Z-5\nX20\no100 endsub\nG21 G18 G90 G95 G7\nT1 M6\nG0 X50 Z5\nG97 S100 M3\nF0.2\n",
        "G1 X41 Z0\nX40 Z-1\nG40 G80\nM6\nM3\nG0 X60 Z9\nM2\n",
        {"G0 X30", "G1 X30 Z-5", "G2 X40 Z0 R9", "G3 X40 Z0 I-5 K0", "G33 Z-5 K1",
         "G76 P1 Z-5 I-1 J0.5 K1 R1.5 Q29.5 H0 E0 L0", "G71 Q100 X50 Z5 D1 I1 R1", "G72 Q100 X50 Z5 D1 I1 R1",
         "G70 Q100 X50 Z5 D0 E0 P1", "G96 S100 D1000", "G7", "G8", "G41.1 D1 L2", "G42 D1", "G4 P0.5", "M3"},
        letters,
        shop::MachineKind::lathe,
        {},
        true};
    EXPECT_EQ(without_effect(way), "");
}

/// Jumps, calls and structure words need a block of their own.
TEST(EveryWord, OfStatementsOfSinumerikIsActedOnOrSaid) {
    std::vector<std::string_view> words = letters;
    for (const std::string_view w : {"X=IC(7)", "RND=1", "M5", "M17", "G1", "G91", "SPOS=7", "R2=7", "MSG(\"A\")"})
        words.push_back(w);
    const Way way{
        "sinumerik-840d",
        "in.mpf",
        "%_N_IN_MPF\nG17 G90 G94 G71\nT1 D1 M6\nG0 X1 Y2 Z3\nS100 M3\nF50\nR1=1\n",
        "AA: X19 Y9\nG1 X20 Y21 Z1\nG1 X30 Y5\nBB: M6\nM3\nG0 X0 Y1\nM30\n%_N_SUB1_SPF\nX2\nRET\n%_N_SUB2_SPF\n"
        "PROC SUB2(REAL WAY)\nX=WAY\nM17\n",
        {"GOTOF AA",
         "GOTO AA",
         "GOTOC AA",
         "IF R1==1 GOTOF AA",
         "IF R1==2 GOTOF AA",
         "CASE R1 OF 1 GOTOF AA DEFAULT GOTOF BB",
         "IF R1==1\nENDIF",
         "WHILE R1==2\nENDWHILE",
         "FOR R3=1 TO 1\nENDFOR",
         "REPEAT\nUNTIL R1==1",
         "LOOP\nGOTOF AA\nENDLOOP",
         "SUB1",
         "SUB1 P2",
         "SUB2(3)",
         "CALL \"SUB1\"",
         "MCALL SUB1\nG1 X5\nMCALL",
         "CC: R4=1\nREPEAT CC",
         "MSG(\"HERE\")",
         "STOPRE",
         "SETMS(1)",
         "EXECSTRING(\"X5\")",
         "R4=5"},
        words,
        shop::MachineKind::mill,
        {},
        true};
    EXPECT_EQ(without_effect(way), "");
}

TEST(EveryWord, OfLathesOfSinumerikIsActedOnOrSaid) {
    std::vector<std::string_view> words = letters;
    for (const std::string_view w : {"X=IC(7)", "Z=AC(7)", "CR=7", "ANG=7", "CHF=1", "CHR=1", "RND=1", "RNDM=1",
                                     "FRC=7", "SPOS=7", "LIMS=7", "S2=7", "M2=3", "SF=7", "OVR=7", "DITS=1"})
        words.push_back(w);
    const Way way{
        "sinumerik-840d",
        "in.mpf",
        "G18 G90 G95 G71 DIAMON\nT1 D1\nG0 X50 Z5\nG97 S100 M3\nF0.2\nG1 X49 Z4\n",
        "G1 X40 Z-1\nG1 X45 Z-9 RND=1\nG1 X60 Z-10\nG40\nG0 X60 Z9\nG96 S10 M3\nM30\n",
        {"G0 X30",   "G1 X30 Z-5", "G2 X40 Z0 CR=9", "G3 X49 Z4 I-5 K0", "G33 Z-5 K1", "G4 S2", "G41",      "G42 X30",
         "G96 S100", "G97",        "LIMS=1000",      "DIAMOF",           "DIAM90",     "G54",   "TRANS Z1", "ATRANS X1",
         "G25 S100", "G26 S1000",  "G74 X1=0",       "G75 Z1=0",         "M4",         "M8",    "T2 D1",    "D2"},
        words,
        shop::MachineKind::lathe,
        {},
        true};
    EXPECT_EQ(without_effect(way), "");
}

}  // namespace
}  // namespace obrys::driver
