/// Cutter locations from text to stream; those of the corpus against what the real postprocessor made of them.

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <filesystem>
#include <iostream>

#include "base/files_testing.hpp"
#include "driver/apt_testing.hpp"

namespace obrys::driver {

namespace fs = std::filesystem;
using testing::AnyRun;
using testing::run_for;

namespace {

AnyRun ran_apt(const std::string& text) { return run_for("apt-cl", text); }

constexpr const char* apt_start = "UNITS/MM\nFEDRAT/100,MMPM\nGOTO/10,0,0\n";

}  // namespace

TEST(AptRun, ACircleRunsCounterClockwiseAboutItsAxis) {
    EXPECT_EQ(ran_apt(std::string(apt_start) + "CIRCLE/0,0,0,0,0,1,10\nGOTO/0,10,0\nFINI\n").moves,
              "linear 10 0 0\narc 0 10 0 centre 0 0 0 normal 0 0 1 sweep 1.5707963267948966\n");
    EXPECT_EQ(ran_apt(std::string(apt_start) + "CIRCLE/0,0,0,0,0,-1\nGOTO/0,10,0\nFINI\n").moves,
              "linear 10 0 0\narc 0 10 0 centre 0 0 0 normal 0 0 1 sweep -4.71238898038469\n");
}

TEST(AptRun, CirclesOfNxRunClockwise) {
    EXPECT_EQ(
        ran_apt("TOOL PATH/A,TOOL,B\n" + std::string(apt_start) + "CIRCLE/0,0,0,0,0,-1,10\nGOTO/0,10,0\nFINI\n").moves,
        "linear 10 0 0\narc 0 10 0 centre 0 0 0 normal 0 0 1 sweep 1.5707963267948966\n");
}

TEST(AptRun, AHelixOfNxTurnsTimes) {
    EXPECT_EQ(ran_apt("TOOL PATH/A,TOOL,B\n" + std::string(apt_start) +
                      "CIRCLE/0,0,0,0,0,-1,10,.002,.5,20,0,TIMES,2\nGOTO/10,0,-4\nFINI\n")
                  .moves,
              "linear 10 0 0\narc 10 0 -4 centre 0 0 0 normal 0 0 1 sweep 12.566370614359172\n");
}

TEST(AptRun, CreoGivesSeveralPointsOfAnArc) {
    const AnyRun r = ran_apt("$$-> MFGNO / A\n" + std::string(apt_start) +
                             "CIRCLE/0,0,0,0,0,1,10\nGOTO/6,8,0\nGOTO/0,10,0\nGOTO/0,20,0\nFINI\n");
    EXPECT_EQ(r.moves.substr(0, 30), "linear 10 0 0\narc 6 8 0 centre");
    EXPECT_NE(r.moves.find("arc 0 10 0"), std::string::npos);
    EXPECT_TRUE(r.moves.ends_with("linear 0 20 0\n")) << r.moves;
}

TEST(AptRun, ArcsLieInAnyPlane) {
    const AnyRun r = ran_apt(
        "UNITS/MM\nFEDRAT/1,MMPM\nGOTO/20.4,0,-30\nINDIRV/0,0,1\nTLON,GOFWD/(CIRCLE/25,0,-30,$\n4.6),ON,"
        "(LINE/25,0,-30,25,0,-25.4)\nFINI\n");
    EXPECT_EQ(r.messages, "");
    EXPECT_EQ(r.moves, "linear 20.4 0 -30\narc 25 0 -25.4 centre 25 0 -30 normal 0 1 0 sweep 1.5707963267948966\n");
}

TEST(AptRun, TheToolsAxisStaysUntilAnotherIsSaid) {
    EXPECT_EQ(
        ran_apt(
            "UNITS/MM\nMULTAX\nRAPID\nGOTO/0,0,10,0,0.6,0.8\nRAPID\nGOTO/1,0,10\nTLAXIS/0,0,1\nRAPID\nGOTO/2,0,10\n")
            .moves,
        "rapid 0 0 10 axis 0 0.6 0.8\nrapid 1 0 10 axis 0 0.6 0.8\nrapid 2 0 10\n");
}

TEST(AptRun, InchesBecomeMillimetres) {
    const AnyRun r = ran_apt("UNITS/INCHES\nFEDRAT/10,IPM\nGOTO/1,0,0\nCIRCLE/0,0,0,0,0,1\nGOTO/0,1,0\nFINI\n");
    EXPECT_NE(r.moves.find("arc 0 25.4 0 centre 0 0 0"), std::string::npos) << r.moves;
    bool found = false;
    for (const cl::Record& record : r.records)
        if (const auto* f = std::get_if<cl::Feed>(&record.step)) found = found || f->value == 254;
    EXPECT_TRUE(found);
}

TEST(AptRun, DistancesAndShifts) {
    EXPECT_EQ(ran_apt("UNITS/MM\nRAPID\nGOTO/1,2,3\nRAPID\nGODLTA/-1\nTRANS/10,0,0\nRAPID\nGOTO/0,0,0\n").moves,
              "rapid 1 2 3\nrapid 1 2 2\nrapid 10 0 0\n");
}

TEST(AptRun, HolesGoToTheClearanceAndBack) {
    const AnyRun r = ran_apt(
        "UNITS/MM\nSPINDL/500,RPM,CLW\nRAPID\nGOTO/0,0,50\nCYCLE/DRILL,FEDTO,5,MMPM,100,RAPTO,2\n"
        "GOTO/1,0,10\nGOTO/5,0,20\nCYCLE/OFF\nFINI\n");
    EXPECT_EQ(r.moves,
              "rapid 0 0 50\nrapid 1 0 50\nrapid 1 0 12\nlinear 1 0 5\nrapid 1 0 12\nrapid 1 0 22\nrapid 5 0 22\n"
              "linear 5 0 15\nrapid 5 0 22\n");
}

namespace {

const fs::path apt_corpus = fs::path(OBRYS_SOURCE_DIR) / ".." / "shared" / "corpus";

struct AptFeedMove {
    geom::Vec3 to;
    bool arc = false;
};
/// Moves at feed outside of hole cycles.
std::vector<AptFeedMove> apt_feed_moves(const AnyRun& r) {
    std::vector<AptFeedMove> out;
    int cycles = 0;
    for (const cl::Record& record : r.records) {
        cycles += std::holds_alternative<cl::CycleBegin>(record.step);
        cycles -= std::holds_alternative<cl::CycleEnd>(record.step);
        if (cycles != 0 || cl::is_rapid(record.step)) continue;
        if (const auto* line = std::get_if<cl::Linear>(&record.step)) out.push_back({line->to, false});
        if (const auto* arc = std::get_if<cl::Arc>(&record.step)) out.push_back({arc->to, true});
    }
    return out;
}

/// A text and the Klartext that its postprocessor made of its moves from `first` on, `count` of them. What else there
/// is of pairs stands in the axes of a machine whose table is turned.
struct AptPair {
    const char* text;
    const char* klartext;
    std::size_t first, count;
};
constexpr std::array apt_pairs{
    AptPair{"parts-2022/Dem-target2.apt", "parts-2022/Dem-target2/11.h", 0, 207},
    AptPair{"parts-2022/SupPetriLED.apt", "parts-2022/SupPetriLED/11.h", 0, 229},
    AptPair{"parts-2022/Top-light-cover.apt", "parts-2022/Top-light-cover/11.h", 0, 1195},
    AptPair{"parts-2022/shimemcunha.apt", "parts-2022/shimemcunha/12.h", 4, 56},
    AptPair{"parts-2021/Teste-Metrologia.apt", "parts-2021/Teste-Metrologia/11.h", 0, 98},
};

}  // namespace

TEST(AptCorpus, KlartextOfTheRealPostprocessorIsTheSamePath) {
    const fs::path apt = apt_corpus / "apt" / "aamorim1913__AptPostProcessor";
    const fs::path klartext = apt_corpus / "klartext" / "aamorim1913__AptPostProcessor" / "tests";
    if (!fs::exists(apt) || !fs::exists(klartext)) GTEST_SKIP() << "needs ../shared";
    for (const AptPair& p : apt_pairs) {
        const auto a = apt_feed_moves(ran_apt(base::testing::content(apt / p.text)));
        const auto b = apt_feed_moves(run_for("heidenhain-itnc530", base::testing::content(klartext / p.klartext)));
        ASSERT_EQ(b.size(), p.count) << p.klartext;
        ASSERT_GE(a.size(), p.first + p.count) << p.text;
        double worst = 0;
        for (std::size_t i = 0; i < b.size(); ++i) {
            worst = std::max(worst, geom::distance(a[p.first + i].to, b[i].to));
            EXPECT_EQ(a[p.first + i].arc, b[i].arc) << p.text << " move " << i;
        }
        EXPECT_LT(worst, 0.00095) << p.text;  // Klartext has three decimals
        std::cout << p.text << ": " << p.count << " moves, worst " << worst << " mm\n";
    }
}

namespace {

/// Nothing but words for the postprocessor stands there.
bool cl_words_alone(const fs::path& file) { return file.filename() == "seqNo.apt"; }

}  // namespace

TEST(AptCorpus, EveryTextIsReadAndItsStreamKeepsItsRules) {
    if (!fs::exists(apt_corpus / "apt")) GTEST_SKIP() << "needs ../shared";
    int files = 0;
    for (const fs::path& file : base::testing::files_below(apt_corpus / "apt")) {
        const AnyRun r = ran_apt(base::testing::content(file));
        ++files;
        EXPECT_EQ(r.faults, "") << file;
        const bool part_program = file.string().find("aptos-apt360") != std::string::npos;
        if (file.filename() == "demooutput1.txt") continue;  // what a postprocessor made
        const bool complains = r.messages.find("part program") != std::string::npos;
        if (!part_program) {
            EXPECT_FALSE(complains) << file << "\n" << r.messages;
        } else if (!cl_words_alone(file)) {
            EXPECT_TRUE(complains) << file;
        }
    }
    std::cout << files << " files\n";
    EXPECT_GE(files, 50);
}

}  // namespace obrys::driver
