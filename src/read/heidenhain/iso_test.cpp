/// DIN/ISO of the iTNC 530: what tests/heidenhain/pairs.py cannot show, i.e. complaints, places and odd texts. Trees
/// are held to those of Klartext there.

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <random>

#include "program/tree_text_testing.hpp"
#include "read/heidenhain/read.hpp"

namespace obrys::read::heidenhain {
namespace {

struct Result {
    base::Sources sources;
    program::Names names;
    base::Diagnostics diagnostics;
    program::Unit unit;

    [[nodiscard]] std::string tree() const { return program::testing::TreeText(unit, names).all(); }
    /// "3:5 text | remedy" of the first complaint, or nothing.
    [[nodiscard]] std::string complaint() const {
        if (diagnostics.all().empty()) return {};
        const base::Diagnostic& d = diagnostics.all().front();
        const auto at = sources.position(d.where);
        return std::to_string(at.line) + ":" + std::to_string(at.column) + " " + d.text + " | " + d.remedy;
    }
};

void read_into(Result& r, std::string text) {
    if (text.starts_with("%T")) text += "\nN9999 %T G71 *\n";
    const auto file = r.sources.add("TEST.I", text, base::BlockNumbers::n_word);
    r.unit = read_iso(file, r.sources, r.names, r.diagnostics);
}

std::string complaint_of(const std::string& block) {
    Result r;
    read_into(r, "%T G71 *\nN10 G01 X+0 F100 *\n" + block + "\nN99 X+1 *\n");
    EXPECT_LE(r.diagnostics.all().size(), 1U) << block;
    EXPECT_EQ(r.unit.statements.back().begin, r.sources[0].text.find("N99 X")) << "the block behind is read: " << block;
    return r.complaint();
}

TEST(Iso, ComplaintsNamePlaceAndRemedy) {
    const std::pair<const char*, const char*> cases[] = {
        {"N20 G01 X *", "3:9 the word 'X' has no value: a number or a Q parameter must follow | "},
        {"N20 G01 H+30 *",
         "3:9 the polar angle H needs a polar path function | G10 to G16 move in polar coordinates, G00 to G06 do not"},
        {"N20 G11 X+20 *",
         "3:9 a polar path function stands here without R and H | write R and H, or G00 to G06 for X and Y"},
        {"N20 G01 X+5 R+3 *",
         "3:13 R has no meaning in this block | it is the radius of G02, G03, G05, of corners (G25) and of polar "
         "coordinates (G10 to G16)"},
        {"N20 M3 *\nN30 G25 R5 *", "4:5 a chamfer or rounding needs a contour element directly before it | "},
        {"N20 X+5 G25 R5 *", "3:5 a chamfer or rounding stands in a block of its own | G24 R2 or G25 R5"},
        {"N20 X+5 G98 L1 *", "3:5 G98 stands first in its block | write the label in a block of its own"},
        {"N20 G98 *", "3:9 L and the label are due behind G98, found end of block | G98 L1; G98 L0 ends a subprogram"},
        {"N20 G98 L1 *\nN30 G98 L1 *",
         "4:10 the label 1 is there twice in this program | give one of them another number"},
        {"N20 L *", "3:7 a label is due here, found end of block | a number, a name in quotes or a QS parameter"},
        {"N20 L1, *", "3:9 a number of repeats is due behind the comma, found end of block | L1,0 calls a subprogram"},
        {"N20 D01 Q1 P01 +5 *",
         "3:19 P02 is due here, found end of block | the values of a function stand behind P01, P02, P03"},
        {"N20 D09 P01 +Q1 P02 +2 *",
         "3:24 P03 is due here, found end of block | the values of a function stand behind P01, P02, P03"},
        {"N20 D *", "3:5 D needs the whole number of a function | "},
        {"N20 G *", "3:5 G needs the whole number of a function | "},
        {"N20 G83 P01 2 P09 5 *",
         "3:15 the word P09 does not belong to CYCL DEF 1 | take it out, or write it in a block of its own"},
        {"N20 G54 X+5 Q3 *",
         "3:13 the word Q does not belong to CYCL DEF 7 | take it out, or write it in a block of its own"},
        {"N20 G99 T1 X+5 *", "3:12 L and R of the tool are due here, found 'X+5' | "},
        {"N20 G51 L1 *", "3:9 T and the tool's number are due here, found 'L1' | "},
        {"N20 G30 G17 X+0 Q5 *", "3:17 X, Y or Z is due here, found 'Q5' | "},
        {"N20 Q1 = ( 2 + 3 *", "3:10 this parenthesis is not closed | write the missing ')'"},
        {"N20 Q1 = 2 * *", "3:14 the formula ends where a number, a Q parameter or a function is due | "},
        {"N20 Q5000 = 2 *", "3:5 there is no parameter Q5000 | Q0 to Q1999, QL0 to QL499, QR0 to QR499, QS0 to QS1999"},
        {"N20 G01 X+5 E3 *",
         "3:13 this is no word of a block that moves: 'E3' | G, X Y Z A B C U V W, I J K, R, H, F, S, T, M; Q, D, L "
         "and % "
         "stand in blocks of their own"},
        {"N20 % *", "3:7 the name of a program is due behind % | "},
    };
    for (const auto& [block, text] : cases) EXPECT_EQ(complaint_of(block), text) << block;
}

TEST(Iso, WhatIsNotRunStaysInTheTree) {
    for (const char* block :
         {"G20 T1", "G33 X+5", "G440 X", "G55 P01 10 P02 Z- P03 X+5", "D17 P01 +1 P02 +2", "D99 Q1", "(WAIT)", "&"}) {
        Result r;
        read_into(r, "%T G71 *\nN10 " + std::string(block) + " *\n");
        EXPECT_EQ(r.unit.problems.size(), 1U) << block;
    }
}

TEST(Iso, StarEndsABlockAndMultiplies) {
    Result r, apart;
    read_into(r, "%T G71 *\nN10 Q1 = 2 * Q2 * 3*\nN20 Q1 = 4 * N30 X+1 F5 * N40 X+2*N50 X+3");
    EXPECT_EQ(r.complaint(), "");
    read_into(apart, "%T G71\nN10 Q1 = 2*Q2*3\nN20 Q1=4\nN30 X+1 F5\nN40 X+2\r\nN50 X+3");
    EXPECT_EQ(apart.complaint(), "");
    EXPECT_EQ(r.tree(), apart.tree());
    EXPECT_EQ(r.unit.assigns.size(), 2U);
}

TEST(Iso, LinesOfACycle) {
    Result lines, one;
    read_into(lines, "%T G71 *\nN10 G200 DRILLING\n  Q200=2 ;SET-UP\n  Q201=-20 ;DEPTH\nQ206=150 *\nN20 Q202=5 *\n");
    read_into(one, "%T G71 *\nN10 G200 Q200=2 Q201=-20 Q206=150*\nN20 Q202=5*\n");
    EXPECT_EQ(lines.complaint(), "");
    ASSERT_EQ(lines.unit.cycles.size(), 1U);
    EXPECT_EQ(lines.unit.cycles[0].settings.size(), 3U);
    EXPECT_EQ(one.unit.cycles.at(0).settings.size(), 3U);
    EXPECT_EQ(lines.unit.assigns.size(), 1U) << "a numbered block is none of the cycle's";
    Result ended;
    read_into(ended, "%T G71 *\nN10 G200 Q200=2 *\nQ201=-20 *\n");
    EXPECT_EQ(ended.unit.cycles.at(0).settings.size(), 1U) << "the star ended the cycle";
}

TEST(Iso, Blank) {
    Result r;
    read_into(r, "%T G71 *\nN10 G30 G18 X-1 Y+2 Z-40 *\nN20 G31 G91 X+100 Y+100 Z+40 *\n");
    ASSERT_TRUE(r.unit.blank);
    EXPECT_EQ(r.unit.blank->tool_axis, 1);
    EXPECT_EQ(r.unit.blank->max, (std::array<double, 3>{99, 102, 0}));
}

TEST(Iso, ProgramCutOffOrFollowedByMore) {
    Result cut, more;
    read_into(cut, "%A G71 *\nN10 G01 X+5 F100 *\n");
    EXPECT_EQ(cut.complaint(), "2:1 N99999999 %NAME is missing: the program may be cut off here | ");
    read_into(more, "%A G71 *\nN10 G01 X+5 F100 *\nN99999999 %A G71 *\nN10 X+6 *\n");
    EXPECT_EQ(more.complaint(),
              "4:1 the text behind N99999999 %NAME is no part of the program and is not run | keep it in a file of its "
              "own, or take "
              "the first N99999999 %NAME out");
    EXPECT_EQ(more.unit.statements.size(), 2U);
}

TEST(Iso, Likelihood) {
    const char* klartext = "0 BEGIN PGM A MM\n1 TOOL CALL 1 Z S100\n2 L X+0 FMAX\n3 END PGM A MM\n";
    const char* iso = "%A G71 *\nN10 G00 G40 X+0 *\nN20 M2 *\nN99999999 %A G71 *\n";
    const char* sinumerik = "%_N_A_MPF\nN10 G0 X5\nN20 G1 Z=R3 F0.2\nN30 M30\n";
    EXPECT_GT(iso_likelihood(iso, "A.TXT"), likelihood(iso, "A.TXT") + 30);
    EXPECT_GT(likelihood(klartext, "A.I"), iso_likelihood(klartext, "A.I") + 30) << "the content says it";
    EXPECT_LT(iso_likelihood(sinumerik, "A.MPF"), 3);
    EXPECT_EQ(iso_likelihood("", ""), 0);
}

TEST(Iso, ProgramsOfOtherControlsDoNotLookLikeIt) {
    const std::filesystem::path corpus = std::filesystem::path(OBRYS_SOURCE_DIR) / "../shared/corpus";
    if (!std::filesystem::exists(corpus)) GTEST_SKIP() << "needs ../shared";
    for (const char* folder : {"sinumerik", "gcode", "fanuc_macro", "rs274", "klartext", "apt"})
        for (const auto& entry : std::filesystem::recursive_directory_iterator(corpus / folder)) {
            if (!entry.is_regular_file()) continue;
            std::ifstream in(entry.path(), std::ios::binary);
            const std::string text{std::istreambuf_iterator<char>(in), {}};
            const int score = iso_likelihood(text, entry.path().filename().string());
            if (entry.path().string().find("Micron WF21D") == std::string::npos) {
                EXPECT_LT(score, 20) << entry.path();
                continue;
            }
            EXPECT_GT(score, 50) << "postprocessed for a TNC";
            Result r;
            read_into(r, text);
            EXPECT_EQ(r.complaint(), "1:1 the text in front of % is left out | ");
            EXPECT_EQ(r.diagnostics.all().size(), 1U);
            EXPECT_TRUE(r.unit.problems.empty());
            EXPECT_GT(r.unit.statements.size(), 100U);
        }
}

/// Pieces of programs thrown together: every place lies in the text, and reading ends.
TEST(Iso, AnyTextIsRead) {
    const std::vector<std::string> pieces{
        "N10 ",   "*",  "\n",   " ",    "G01 ",  "G98 L1", "L1,2", "X+5",  "G91 ", "G90 ", "I+3",  "G25 R2",
        "G26 R3", "%",  "A ",   "G71",  "Q1=",   "Q2*",    "(",    "D09 ", "P01 ", "+Q3",  "G200", "~",
        ";x",     "\"", "H+7",  "R-2",  "M99",   "T1 ",    "G83 ", "G37 ", "G54 ", "DL+1", "/",    "F",
        "MAX",    "G",  "\x1A", "\r",   ",",     "G30 ",   "G38 ", "G39 ", "L",    "-5.5", "E9",   "QS1",
        "D18 ",   ":",  "G73 ", "G80 ", "\xFC.", "G12 ",   "G07 ", "G43 "};
    for (unsigned seed = 0; seed < 3000; ++seed) {
        std::mt19937 random(seed);
        std::string text = random() % 2 != 0U ? "%T G71 *\n" : "";
        for (auto n = random() % 40; n > 0; --n) text += pieces[random() % pieces.size()];
        Result r;
        read_into(r, text);
        for (const base::Diagnostic& d : r.diagnostics.all())
            ASSERT_TRUE(d.where.begin <= d.where.end && d.where.end <= r.sources[0].text.size()) << "seed " << seed;
        for (const program::Statement& s : r.unit.statements)
            ASSERT_LE(s.begin + s.length, r.sources[0].text.size()) << "seed " << seed;
    }
}

}  // namespace
}  // namespace obrys::read::heidenhain
