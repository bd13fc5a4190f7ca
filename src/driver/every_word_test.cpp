/// Every word of a block is acted on or said, on every control: a word put into a block changes what comes out (stream,
/// parameters) or draws a message.

#include "driver/every_word_testing.hpp"

namespace obrys::driver {
namespace {

using namespace testing;

Way fanuc(std::string_view control) {
    return {control,
            "in.nc",
            "%\nO0001\nG21 G17 G90 G94\nT1 M6\nG0 G43 H1 X1. Y2. Z3.\nS100 M3\nF50.\n",
            "G1 X20. Y21. Z1.\nM6\nG0 X0. Y1.\nM30\n%\n",
            {"G0 X5.",
             "G1 Y6.",
             "G2 X5. Y6. R20.",
             "G3 X3. Y2. I1. J0.",
             "G4 P500",
             "G28 Z9.",
             "G81 X5. Z-5. R1.",
             "G83 X5. Z-5. R1. Q2.",
             "G80",
             "G90",
             "G91",
             "G92 X0.",
             "G10 L2 P1 X1.",
             "G52 X1.",
             "G40",
             "G41 D1",
             "G41 X9. D1",
             "G43 H1",
             "G49",
             "G54",
             "G17",
             "G18",
             control == "haas" ? "G51 X1. Y1. P2." : "G51 X1. Y1. P2000",  // alarm 7: a point behind P
             "G68 X0. Y0. R30.",
             "G69",
             "G53 Z0.",
             "M3",
             "M8",
             "M98 P1000",
             "M0",
             "G53 G0 X0."},
            letters};
}

/// Blocks of a contour that a turning cycle cuts down to, and that nothing else runs.
Way turned_contour(std::string_view control) {
    return {control,
            "in.nc",
            "%\nO0001\nG21 G18 G40 G80 G99\nT0101\nG97 S1000 M3\nG0 X52. Z2.\nG71 U2. R1.\nG71 P10 Q20 U.5 W.1 F.2\n"
            "N10 G0 X30.\nG1 Z-10.\n",
            "G1 X48.\nN20 Z-40.\nG0 X100. Z50.\nM30\n%\n",
            {"G1 X40.", "G1 Z-20.", "G1 X40. Z-25.", "G2 X40. Z-15. R5."},
            letters,
            shop::MachineKind::lathe,
            {"F7", "S7"}};  // they act where the contour is finished
}

TEST(EveryWord, OfATurnedContourIsActedOnOrSaid) {
    EXPECT_EQ(without_effect(turned_contour("fanuc")), "");
    EXPECT_EQ(without_effect(turned_contour("haas")), "");
}

/// Blocks of a contour that a milling cycle clears.
Way milled_contour() {
    return {"heidenhain-itnc530",
            "in.h",
            "0 BEGIN PGM P MM\n1 TOOL CALL 1 Z S2000\n2 L X-20 Y+20 Z+50 R0 FMAX M3\n3 CYCL DEF 14.0 CONTOUR\n"
            "4 CYCL DEF 14.1 CONTOUR LABEL1\n"
            "5 CYCL DEF 20 CONTOUR DATA Q1=-5 Q2=+1 Q3=+0 Q4=+0 Q5=+0 Q6=+2 Q7=+50 Q8=+0 Q9=+1\n"
            "6 CYCL DEF 22 ROUGH-OUT Q10=-2.5 Q11=+150 Q12=+750 Q18=+0 Q19=+150 Q208=+99999\n"
            "7 L X+20 Y+20 FMAX M99\n8 L Z+50 FMAX M30\n9 LBL 1\nL X+5 Y+5 RL\n",
            "L X+35\nL Y+35\nL X+5\nL Y+5\nLBL 0\nEND PGM P MM\n",
            {"L X+10", "L IX+10 IY+3", "RND R2", "L X+20 R0", "CC X+20 Y+5"},
            {"A+7",  "B+7",   "C+7", "X+9", "Y+9", "Z+9", "IX+2", "IZ+2", "DR+", "DL+1", "R5",   "RL",  "RR",  "F100",
             "FMAX", "FAUTO", "M3",  "M8",  "M91", "M99", "M30",  "M97",  "M98", "M120", "M140", "U+3", "P+4", "S500"},
            shop::MachineKind::mill,
            {"RL", "F100", "FMAX", "FAUTO"}};
}

TEST(EveryWord, OfAMilledContourIsActedOnOrSaid) { EXPECT_EQ(without_effect(milled_contour()), ""); }

TEST(EveryWord, OfFanucIsActedOnOrSaid) { EXPECT_EQ(without_effect(fanuc("fanuc")), ""); }
TEST(EveryWord, OfHaasIsActedOnOrSaid) { EXPECT_EQ(without_effect(fanuc("haas")), ""); }

TEST(EveryWord, OfLinuxcncIsActedOnOrSaid) {
    const Way way{"linuxcnc",
                  "in.ngc",
                  "G21 G17 G90 G94\nT1 M6\nG0 G43 H1 X1 Y2 Z3\nS100 M3\nF50\n",
                  "G1 X20 Y21 Z1 A1 B1 C1\nG40\nM6\nG0 X0 Y1\nM2\n",
                  {"G0 X5",
                   "G1 Y6",
                   "G2 X5 Y6 R20",
                   "G3 X3 Y2 I1 J0",
                   "G4 P0.5",
                   "G28 Z9",
                   "G81 X5 Z-5 R1",
                   "G83 X5 Z-5 R1 Q2",
                   "G80",
                   "G90",
                   "G92 X0",
                   "G10 L2 P1 X1",
                   "G52 X1",
                   "G40",
                   "G41 D1",
                   "G43 H1",
                   "G49",
                   "G54",
                   "G18",
                   "G53 G0 Z0",
                   "G33 Z1 K1",
                   "G5 X5 Y5 P1 Q1 I1 J1",
                   "G64 P0.1",
                   "M3",
                   "M8",
                   "M66 P1 L0",
                   "M19 R5",
                   "M0"},
                  letters};
    EXPECT_EQ(without_effect(way), "");
}

/// Every address with a value behind =, and with the extension of the first spindle and of another one.
std::vector<std::string> extended_words() {
    std::vector<std::string> words;
    std::vector<std::string> names{"SPOS", "SPOSA", "LIMS"};
    for (char c = 'A'; c <= 'Z'; ++c) names.emplace_back(1, c);
    for (const std::string& name : names) {
        words.push_back(name + "=7");
        for (const char* extension : {"1=", "[1]=", "2=", "[2]="}) words.push_back(name + extension + "7");
    }
    words.insert(words.end(), {"M1=3", "M[1]=4", "M2=3", "M[2]=5", "T1=2", "T[1]=2", "D1=2"});
    return words;
}

TEST(EveryWord, OfSinumerikIsActedOnOrSaid) {
    std::vector<std::string_view> words = letters;
    const std::vector<std::string> extended = extended_words();
    words.insert(words.end(), extended.begin(), extended.end());
    for (const std::string_view w :
         {"X=IC(7)", "I=AC(7)", "AP=7",   "RP=7",  "CR=7",   "AR=7",   "TURN=2",  "I1=7",   "ANG=7", "CHF=1",
          "CHR=1",   "RND=1",   "RNDM=1", "FRC=7", "FRCM=7", "SPOS=7", "LIMS=7",  "S2=7",   "M2=3",  "H2=7",
          "RPL=7",   "ADIS=1",  "DISC=1", "SF=7",  "FB=7",   "OVR=7",  "FA[X]=7", "DITS=1", "X1=7",  "AX[X]=7"})
        words.push_back(w);
    const Way way{"sinumerik-840d",
                  "in.mpf",
                  "G17 G90 G94 G71\nT1 D1 M6\nG0 X1 Y2 Z3\nS100 M3\nF50\nG1 X2 Y3\n",
                  "G1 X20 Y21 Z1\nG1 X30 Y5 RND=1\nG1 X40 Y9\nG1 AP=20 RP=9\nM6\nG0 X0 Y1\nG96 S10 M3\nM30\n",
                  {"G0 X5",
                   "G1 Y6",
                   "G2 X5 Y6 CR=20",
                   "G3 X3 Y2 I1 J0",
                   "G4 F1",
                   "G74 Z1=0",
                   "G75 Z1=0",
                   "G90",
                   "G91",
                   "G40",
                   "G41",
                   "G54",
                   "G500",
                   "G17",
                   "G18",
                   "SUPA G0 Z1",
                   "G33 Z1 K1",
                   "TRANS X1",
                   "ROT Z5",
                   "MIRROR X0",
                   "SCALE X2 Y2",
                   "G110 X1",
                   "G96 S10",
                   "G64",
                   "DIAMON",
                   "CIP X5 Y5 I1=3 J1=4",
                   "CT X5 Y9",
                   "M3",
                   "M8",
                   "M0"},
                  words};
    EXPECT_EQ(without_effect(way), "");
}

TEST(EveryWord, OfKlartextIsActedOnOrSaid) {
    const Way way{
        "heidenhain-itnc530",
        "in.H",
        "0 BEGIN PGM IN MM\n1 TOOL CALL 1 Z S100\n2 L X+1 Y+2 Z+3 R0 F50 M3\n3 CC X+0 Y+0\n4 L X+3 Y+4\n5 ",
        "6 L X+20 Y+21 Z+1\n7 L X+30 Y+5\n8 CP IPA+10 DR+\n9 END PGM IN MM\n",
        {"L X+5", "L Y+6 R0 F200", "C X-3 Y-4 DR+", "CR X+5 Y+6 R+20 DR-", "CT X+5 Y+9", "LP PR+9 PA+30",
         "CP IPA+30 DR+", "L X+9 Y+9\n5 CHF 1", "L X+9 Y+9\n5 RND R1", "TOOL CALL 2 Z S200", "CC X+5",
         "L Z+50 FMAX M91", "APPR LN X+5 Y+5 LEN5 RL F100", "L X+9 Y+9 RL\n5 L X+9 Y+30\n5 DEP LN LEN5", "STOP",
         "L X+5 RL"},
        {"X+7",   "Y+7",   "Z+7",  "A+7",  "B+7", "C+7",    "U+7",  "V+7",  "W+7", "IX+7", "IZ+7", "PR+7", "PA+7",
         "IPA+7", "IPR+7", "R7",   "RL",   "RR",  "R0",     "F7",   "FMAX", "FU7", "FZ7",  "M8",   "M3",   "M91",
         "M98",   "S7",    "DL+7", "DR+7", "DR-", "DR2:+7", "CCA7", "LEN7", "Q7",  "T7",   "K7",   "H7",   "P7"}};
    EXPECT_EQ(without_effect(way), "");
}

TEST(EveryWord, OfDinIsoIsActedOnOrSaid) {
    const Way way{
        "heidenhain-itnc530",
        "in.I",
        "%IN G71 *\nN10 T1 G17 S100 *\nN20 G00 G90 G40 X+1 Y+2 Z+3 M3 *\nN30 I+0 J+0 *\nN35 G01 X+3 Y+4 F50 *\nN40 ",
        "*\nN50 G01 X+20 Y+21 Z+1 *\nN60 G01 X+30 Y+5 *\nN99999999 %IN G71 *\n",
        {"G00 X+5", "G01 Y+6", "G02 X-3 Y-4", "G03 X+5 Y+6 R+20", "G06 X+5 Y+9", "G10 R+9 H+30", "G04 F1",
         "G01 X+9 Y+9 *\nN45 G24 R1", "G01 X+9 Y+9 *\nN45 G25 R1", "G40", "G41 X+9", "G90", "G91", "G70", "T2 G17 S200",
         "G38"},
        {"A+7", "B+7", "C+7", "D7",  "E7",  "F7",  "H7",  "I+7", "J+7", "K+7", "L7",  "P07 +7", "Q7",  "R7",
         "S7",  "T2",  "U+7", "V+7", "W+7", "X+7", "Y+7", "Z+7", "M8",  "M98", "G41", "G42",    "G90", "G01"}};
    EXPECT_EQ(without_effect(way), "");
}

}  // namespace
}  // namespace obrys::driver
