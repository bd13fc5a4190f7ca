#include <gtest/gtest.h>

#include <iterator>
#include <random>

#include "read/heidenhain/reading.hpp"

namespace obrys::read::heidenhain {
namespace {

using cl::CycleRole;
using program::Procedure;
using testing::Reading;

const program::ProcedureCall& only(const Reading& r) {
    EXPECT_EQ(r.messages(), "");
    EXPECT_EQ(r.unit.procedures.size(), 1U);
    return r.unit.procedures.front();
}

std::string text(const Reading& r, program::ExprId id) { return r.unit.texts[r.unit.exprs[id].a]; }

TEST(HeidenhainShopBlock, FilesLoseTheirFolders) {
    for (const char* block : {"FN 26: TABOPEN TNC:\\DIR\\LIST.TAB", "FN26: TABOPEN LIST.TAB ;comment",
                              "FN 26: TABOPEN \"TNC:\\DIR\\LIST.TAB\""}) {
        const Reading r(block);
        EXPECT_EQ(only(r).procedure, Procedure::open_table);
        EXPECT_EQ(text(r, only(r).arguments[0]), "LIST.TAB") << block;
    }
    for (const char* block : {"FN 16: F-PRINT TNC:\\A\\F.A / TNC:\\B\\O.TXT", "FN16:F-PRINT F.A/O.TXT"}) {
        const Reading r(block);
        EXPECT_EQ(text(r, only(r).arguments[0]), "F.A") << block;
        EXPECT_EQ(text(r, only(r).arguments[1]), "O.TXT") << block;
    }
    const Reading screen("FN 16: F-PRINT F.A/SCREEN:");
    EXPECT_EQ(text(screen, only(screen).arguments[1]), "SCREEN");
}

TEST(HeidenhainShopBlock, TablesAndDatums) {
    const Reading write("FN 27: TABWRITE 5/\"A,B\" = Q5");
    EXPECT_EQ(only(write).procedure, Procedure::write_table);
    EXPECT_EQ(text(write, only(write).arguments[1]), "A,B");
    const Reading read("FN 28: TABREAD Q10 = Q6/\"A\"");
    EXPECT_EQ(read.unit.exprs[only(read).arguments[0]].a, 10U);
    const Reading preset("FN 25: PRESET = Z/+50/-20");
    EXPECT_EQ(only(preset).arguments.size(), 3U);
    EXPECT_EQ(text(preset, only(preset).arguments[0]), "Z");
    const Reading values("FN 15: PRINT Q1/Q2/20");
    EXPECT_EQ(only(values).arguments.size(), 3U);
    const Reading selected("SEL TABLE \"TNC:\\ZERO.D\"");
    EXPECT_EQ(text(selected, only(selected).arguments[0]), "ZERO.D");
}

TEST(HeidenhainShopBlock, DatumShiftIsCycle7) {
    const Reading r("TRANS DATUM AXIS X+10 IY-2.5");
    ASSERT_EQ(r.messages(), "");
    ASSERT_EQ(r.unit.cycles.size(), 1U);
    const program::CycleDefinition& c = r.unit.cycles.front();
    EXPECT_EQ(c.kind, cl::CycleKind::datum_shift);
    ASSERT_EQ(c.settings.size(), 2U);
    EXPECT_EQ(c.settings[1].role, CycleRole::axis_y);
    EXPECT_TRUE(c.settings[1].incremental);
    EXPECT_TRUE(c.settings[1].scales);
    EXPECT_EQ(Reading("TRANS DATUM RESET").unit.cycles.front().settings.size(), 3U);
    const Reading row("TRANS DATUM TABLE TABLINE12");
    EXPECT_EQ(row.unit.cycles.front().settings.front().role, CycleRole::datum_number);
}

TEST(HeidenhainShopBlock, BadInputIsSaid) {
    for (const char* block : {"FN 16: F-PRINT F.A", "FN 25: PRESET = 5", "FN 25: PRESET = X/5",
                              "FN 27: TABWRITE 5 = Q1", "FN 28: TABREAD 5", "FN 26: TABOPEN", "TRANS DATUM",
                              "TRANS DATUM AXIS F5", "SEL TABLE", "FN 17: SYSWRITE", "FN 15: PRINT"})
        EXPECT_FALSE(Reading(block).diagnostics.all().empty()) << block;
}

TEST(HeidenhainShopBlock, AnyTextIsRead) {
    std::mt19937 random(11);
    constexpr std::string_view pieces[] = {"FN 15: PRINT ",
                                           "FN 16: F-PRINT ",
                                           "FN 17: SYSWRITE ",
                                           "FN 25: PRESET = ",
                                           "FN 26: TABOPEN ",
                                           "FN 27: TABWRITE ",
                                           "FN 28: TABREAD ",
                                           "SEL TABLE ",
                                           "TRANS DATUM ",
                                           "AXIS ",
                                           "TABLE ",
                                           "TABLINE",
                                           "RESET ",
                                           "ID",
                                           "NR",
                                           "IDX",
                                           "X",
                                           "IY",
                                           "C",
                                           "Q5",
                                           "QS1",
                                           "=",
                                           "/",
                                           "\"A,B\"",
                                           "\"",
                                           "5",
                                           "-2,5",
                                           "TNC:\\A\\B.TAB",
                                           "SCREEN:",
                                           ":",
                                           "~",
                                           ";",
                                           " ",
                                           "\n",
                                           "1E400"};
    for (int run = 0; run < 5000; ++run) {
        std::string text;
        for (auto n = random() % 12; n > 0; --n) text += pieces[random() % std::size(pieces)];
        const Reading r(text);
        for (const program::ProcedureCall& p : r.unit.procedures)
            for (const program::ExprId e : p.arguments)
                ASSERT_LT(e, r.unit.exprs.size()) << "seed 11, run " << run << ": " << text;
        for (const program::CycleDefinition& c : r.unit.cycles)
            for (const program::CycleSetting& s : c.settings)
                ASSERT_LT(s.value, r.unit.exprs.size()) << "seed 11, run " << run << ": " << text;
    }
}

}  // namespace
}  // namespace obrys::read::heidenhain
