/// Every word of a block is acted on or said, on every control: a word put into a block changes what comes out (stream,
/// parameters) or draws a message. What may stay without either stands in `silent`, with its reason.

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <string_view>
#include <vector>

#include "cl/text.hpp"
#include "driver/session.hpp"

namespace obrys::driver {
namespace {

/// How the programs of a control are written for this test.
struct Way {
    std::string_view control, file;
    std::string_view before, after;  ///< the blocks around; `after` lets words act that wait for a later block
    std::vector<std::string_view> blocks;
    std::vector<std::string_view> words;
};

/// A word that does nothing here and rightly so.
struct Silent {
    std::string_view control, block, word;  ///< empty: every one; `block` and `word` are the text they begin with
    std::string_view reason;
};

constexpr Silent silent[] = {
    {"fanuc", "G81", "P7", "kept for the next cycle of the series"},
    {"haas", "G81", "P7", "kept for the next cycle of the series"},
    {"", "G10 L2", "L2", "what it says already"},
    {"fanuc", "G49", "H2", "the length ends, whatever H says"},
    {"haas", "G49", "H2", "the length ends, whatever H says"},
    {"fanuc", "", "D2", "kept for the next G41 or G42"},
    {"haas", "", "D2", "kept for the next G41 or G42"},
    {"", "M98 P1000", "", "the program called is not there"},
    {"linuxcnc", "G92", "", "where these axes stand is not known before their first move"},
    {"linuxcnc", "G64", "Q7", "a path mode: the stream of moves is the programmed path"},
    {"linuxcnc", "M66", "", "what an input waits for and when; its value is unknown either way"},
    {"linuxcnc", "M19", "", "how the spindle turns to its angle"},
    {"sinumerik-840d", "", "ADIS", "acts with G641"},
    {"sinumerik-840d", "", "DISC", "acts with G450 at a corner under compensation"},
    {"sinumerik-840d", "", "FA[", "acts with POS"},
    {"sinumerik-840d", "", "FRCM", "acts at a rounding that follows"},
    {"sinumerik-840d", "SUPA", "", "the block says that where it ends is not known"},
    {"heidenhain-itnc530", "", "R0", "in force already"},
    {"heidenhain-itnc530", "", "M3", "in force already"},
    {"heidenhain-itnc530", "", "M98", "acts on a corner under compensation, where there is none"},
    {"heidenhain-itnc530", "", "G90", "in force already"},
    {"heidenhain-itnc530", "", "G01", "in force already, or the block's own"},
    {"heidenhain-itnc530", "", "I+7", "a circle centre, for arcs that follow"},
    {"heidenhain-itnc530", "", "J+7", "a circle centre, for arcs that follow"},
    {"heidenhain-itnc530", "", "K+7", "a circle centre, for arcs that follow"},
    {"heidenhain-itnc530", "L Z+50 FMAX M91", "", "the block says that where it ends is not known"},
    {"heidenhain-itnc530", "TOOL CALL", "DR", "acts with radius compensation"},
    {"heidenhain-itnc530", "L X+9 Y+9 RL", "RL", "in force already"},
};

bool begins(std::string_view text, std::string_view with) { return text.substr(0, with.size()) == with; }

bool may_be_silent(const Way& way, std::string_view block, std::string_view word) {
    return std::any_of(std::begin(silent), std::end(silent), [&](const Silent& s) {
        return (s.control.empty() || way.control == s.control) && begins(block, s.block) && begins(word, s.word);
    });
}

/// All that comes out of a program, without the places; `ends`: whether it runs to its end.
std::string outcome(const Way& way, std::string_view block, bool* ends = nullptr) {
    Session s;
    const std::string text = std::string(way.before) + std::string(block) + "\n" + std::string(way.after);
    const Control* control = find_control(std::string(way.control));
    const auto file = s.sources.add(std::string(way.file), text, language_of(*control, text, way.file).numbers);
    s.programs = std::make_unique<Programs>(*control, s.sources, s.diagnostics);
    s.job.machine.kind = shop::MachineKind::mill;
    s.main = s.programs->read(file);
    std::string out;
    if (s.main == nullptr) return out + "no program";
    for (const std::uint32_t number : {1U, 2U, 3U}) {
        shop::Tool tool;
        tool.number = number;
        tool.kind = shop::ToolKind::end_mill;
        tool.radius = number;
        tool.length = 100 + 10 * number;
        s.job.tools.push_back(tool);
    }
    const auto end = interpret(s, [&](const cl::Record& r) {
        const std::string line = cl::to_text(r);
        out += line.substr(0, line.find(" @")) + "\n";
    });
    if (ends != nullptr) *ends = end.ending == interp::Ending::regular;
    for (const auto& p : end.parameters) out += p.name + "=" + std::to_string(p.value) + "\n";
    for (const base::Diagnostic& d : s.diagnostics.all()) out += d.text + "\n";
    for (const program::Ignored& i : s.main->ignored) out += i.text + "\n";
    return out;
}

std::string without_effect(const Way& way) {
    std::string found;
    for (const std::string_view block : way.blocks) {
        bool ends = false;
        const std::string plain = outcome(way, block, &ends);
        EXPECT_TRUE(ends) << "a block that shows nothing, since it stops the run: " << block << "\n" << plain;
        for (const std::string_view word : way.words)
            if (!may_be_silent(way, block, word) && outcome(way, std::string(block) + " " + std::string(word)) == plain)
                found += std::string(block) + "   " + std::string(word) + "\n";
    }
    return found;
}

const std::vector<std::string_view> letters{"A7", "B7", "C7", "D2", "E7", "F7", "H2", "I7", "J7", "K7", "L2",
                                            "P7", "Q7", "R7", "S7", "T2", "U7", "V7", "W7", "X7", "Y7", "Z7"};

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
             "G51 X1. Y1. P2.",
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

TEST(EveryWord, OfSinumerikIsActedOnOrSaid) {
    std::vector<std::string_view> words = letters;
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
