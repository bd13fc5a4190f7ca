#include <gtest/gtest.h>

#include "dialect/apt/cycles.hpp"
#include "read/apt/reading.hpp"

namespace obrys::read::apt {

using program::Code;
using program::Modal;
using testing::has_modal;
using testing::Reading;
using testing::value;

TEST(AptCycle, SizesCountFromThePoint) {
    const Reading r("UNITS/MM\nCYCLE/DRILL,FEDTO,-5,MMPM,120,RAPTO,3,RTRCTO,20,DWELL,0.5\nGOTO/1,2,10\n");
    EXPECT_EQ(value(r, Code::x), 1);
    EXPECT_EQ(value(r, Code::z), 5);
    EXPECT_EQ(value(r, Code::radius), 13);
    EXPECT_EQ(value(r, Code::e), 30);
    EXPECT_EQ(value(r, Code::p), 0.5);
    EXPECT_EQ(value(r, Code::feed), 120);
}

TEST(AptCycle, CreoCountsRaptoFromTheClearance) {
    const Reading r("$$-> MFGNO / A\nUNITS/MM\nCYCLE/DRILL,DEPTH,8,MMPM,100,CLEAR,5,RAPTO,2\nGOTO/0,0,0\n");
    EXPECT_EQ(value(r, Code::radius), 3);
    EXPECT_EQ(value(r, Code::e), 5);
}

TEST(AptCycle, PecksBehindTheFirstMayBeSmaller) {
    const Reading r("UNITS/MM\nCYCLE/DEEP2,FEDTO,9,1STPECK,5,SUBPECK,2,MMPM,100,RAPTO,3\nGOTO/0,0,0\n");
    EXPECT_EQ(value(r, Code::q), 5);
    EXPECT_EQ(value(r, Code::j), 3);
    EXPECT_EQ(value(r, Code::k), 2);
}

TEST(AptCycle, AFeedPerTurnIsTheThread) {
    const Reading r("UNITS/MM\nCYCLE/TAP,DEPTH,9,MMPR,1.25,CLEAR,3\nGOTO/0,0,0\n");
    EXPECT_EQ(value(r, Code::i), 1.25);
    const Reading inches("UNITS/MM\nCYCLE/TAP,DEPTH,9,TPI,20,CLEAR,3\nGOTO/0,0,0\n");
    EXPECT_DOUBLE_EQ(value(inches, Code::i), 1.27);
}

TEST(AptCycle, NumbersWithoutWordsAreRefused) {
    const Reading r("UNITS/MM\nCYCLE/TAP,50,1\nGOTO/0,0,0\nCYCLE/OFF\n");
    EXPECT_NE(r.problems().find("each shop's own"), std::string::npos);
    EXPECT_FALSE(has_modal(r, Modal::canned));
}

TEST(AptCycle, WhatIsMissingOrUnknownIsSaid) {
    const auto problem = [](const char* words) { return Reading(std::string("UNITS/MM\n") + words + "\n").problems(); };
    EXPECT_NE(problem("CYCLE/DRILL,RAPTO,3").find("it says no depth"), std::string::npos);
    EXPECT_NE(problem("CYCLE/DRILL,FEDTO,3").find("it says no clearance"), std::string::npos);
    EXPECT_NE(problem("CYCLE/WEAVE,FEDTO,3").find("what CYCLE/WEAVE does is not known here"), std::string::npos);
    EXPECT_NE(problem("CYCLE/DRILL,FEDTO,3,RAPTO,1,CAMX,2").find("what CAMX says"), std::string::npos);
    EXPECT_NE(problem("CYCLE/DEEP,FEDTO,3,RAPTO,1").find("it says no step"), std::string::npos);
    EXPECT_NE(problem("CYCLE/BORE,FEDTO,3,RAPTO,1,STEP,1").find("steps of this cycle"), std::string::npos);
}

/// A real file of SolidWorks CAM has no CYCLE/OFF before the next tool mills circles.
TEST(AptCycle, AnArcAmongHolesIsNotRun) {
    const std::string drill = "UNITS/MM\nCYCLE/DRILL,FEDTO,9,MMPM,100,RAPTO,3\nGOTO/0,0,0\n";
    const std::string circle = "GOTO/5,0,0\nCIRCLE/0,0,0,0,0,1\nGOTO/5,0,0\n";
    EXPECT_NE(Reading(drill + circle).problems().find("an arc while a hole cycle is in force"), std::string::npos);
    EXPECT_EQ(Reading(drill + "CYCLE/OFF\nFEDRAT/100,MMPM\n" + circle).problems(), "");
}

TEST(AptCycle, TheFeedOfThePathComesBackBehindIt) {
    const Reading r(
        "UNITS/MM\nFEDRAT/500,MMPM\nGOTO/0,0,9\nCYCLE/DRILL,FEDTO,3,MMPM,100,RAPTO,1\nGOTO/0,0,0\nCYCLE/OFF\nGOTO/"
        "1,0,9\n");
    EXPECT_EQ(value(r, Code::feed), 500);
}

TEST(AptCycle, AToolBesideZIsRefused) {
    const Reading r("UNITS/MM\nTLAXIS/1,0,0\nCYCLE/DRILL,FEDTO,3,MMPM,100,RAPTO,1\nGOTO/0,0,0\n");
    EXPECT_NE(r.problems().find("does not stand along Z"), std::string::npos);
}

TEST(AptCycle, OfPowerMillThePointIsTheTopOfTheWork) {
    const std::string holes = "UNITS/MM\nCYCLE/DEEP,FEDTO,9,STEP,2,BACK,1,MMPM,100,RAPTO,3\nGOTO/0,0,10\n";
    EXPECT_EQ(value(Reading("$$ PowerMill\n" + holes), Code::i1), 10);
    EXPECT_TRUE(std::isnan(value(Reading(holes), Code::i1)));
}

TEST(AptCycle, ARigidTapBreaksChipsByTurns) {
    const Reading r("UNITS/MM\nCYCLE/TAP,FEDTO,9,PITCH,0.5,STEP,3,BACK,1,RAPTO,3\nGOTO/0,0,0\n");
    EXPECT_EQ(value(r, Code::q), 3);
    EXPECT_EQ(value(r, Code::k1), 2);
    EXPECT_EQ(value(r, Code::i), 0.5);
    const Reading plain("UNITS/MM\nCYCLE/TAP,FEDTO,9,PITCH,0.5,STEP,3,RAPTO,3\nGOTO/0,0,0\n");
    EXPECT_EQ(value(plain, Code::k1), 1);
    EXPECT_NE(plain.messages().find("one turn is taken"), std::string::npos);
}

TEST(AptCycle, AFeedThatIsTheThreadByTheSpeedCounts) {
    const Reading r("UNITS/MM\nSPINDL/200,RPM,CLW\nCYCLE/TAP,FEDTO,9,PITCH,0.5,MMPM,100,RAPTO,3\nGOTO/0,0,0\n");
    EXPECT_EQ(value(r, Code::feed), 100);
    EXPECT_TRUE(std::isnan(value(r, Code::i)));
    const Reading other("UNITS/MM\nSPINDL/200,RPM,CLW\nCYCLE/TAP,FEDTO,9,PITCH,0.5,MMPM,90,RAPTO,3\nGOTO/0,0,0\n");
    EXPECT_EQ(value(other, Code::i), 0.5);
}

TEST(AptCycle, TheThreadIsThatOfTheCycleBeforeAnyFeed) {
    const std::string start = "UNITS/MM\nFEDRAT/0.2,MMPR\nGOTO/0,0,9\n";
    const auto pitch = [&](const char* words) {
        return value(Reading(start + "CYCLE/TAP,DEPTH,9,CLEAR,3" + words + "\nGOTO/0,0,0\n"), Code::i);
    };
    EXPECT_EQ(pitch(",PITCH,1.5"), 1.5);
    EXPECT_DOUBLE_EQ(pitch(",TPI,20"), 1.27);
    EXPECT_EQ(pitch(",MMPR,0.3"), 0.3);
    EXPECT_EQ(pitch(",MMPR,0.3,PITCH,1.5"), 1.5);
    EXPECT_EQ(pitch(""), 0.2);
}

TEST(AptCycle, WhatContradictsTheThreadIsSaid) {
    const auto said = [](const char* words) {
        return Reading(std::string("UNITS/MM\nSPINDL/200,RPM\nCYCLE/TAP,DEPTH,9,CLEAR,3,") + words + "\nGOTO/0,0,0\n")
            .messages();
    };
    EXPECT_NE(said("PITCH,1.5,MMPR,0.3").find("a tap's feed per turn is not its thread"), std::string::npos);
    EXPECT_NE(said("PITCH,0.5,MMPM,90").find("a tap's feed per minute is not its thread"), std::string::npos);
    EXPECT_EQ(said("PITCH,1.5,MMPR,1.5"), "");
    const auto refused = [](const char* words) {
        return Reading(std::string("UNITS/MM\nCYCLE/") + words + "\nGOTO/0,0,0\n").problems();
    };
    EXPECT_NE(refused("TAP,DEPTH,9,CLEAR,3,PITCH,1,TPI,20").find("TPI contradicts"), std::string::npos);
    EXPECT_NE(refused("DRILL,DEPTH,9,FEDTO,8,CLEAR,3").find("FEDTO contradicts"), std::string::npos);
    EXPECT_NE(refused("DRILL,DEPTH,9,CLEAR,3,MMPM,100,MMPR,0.1").find("MMPR contradicts"), std::string::npos);
    EXPECT_NE(refused("DRILL,DEPTH,9,CLEAR,3,PITCH,1").find("PITCH and TPI say nothing"), std::string::npos);
    EXPECT_NE(refused("DRILL,DEPTH,9,CLEAR,3,BACK,1").find("BACK says nothing"), std::string::npos);
    EXPECT_EQ(refused("DRILL,DEPTH,9,CLEAR,3,RETURN,20,RTRCTO,20"), "");
}

TEST(AptCycle, AToolThatAHoleSetsUprightTurnsOnItsWay) {
    const Reading r("UNITS/MM\nRAPID\nGOTO/0,0,10,1,0,0\nCYCLE/DRILL,DEPTH,10,CLEAR,2,MMPM,90\nGOTO/5,0,0,0,0,1\n");
    EXPECT_NE(r.messages().find("sets upright"), std::string::npos);
    EXPECT_EQ(r.problems(), "");
    const std::string along = "m" + std::to_string(static_cast<int>(Modal::tool_along));
    EXPECT_NE(r.tree().find(along), r.tree().rfind(along)) << r.tree();
}

TEST(AptCycle, APointAtRapidAmongHolesIsNotRun) {
    const Reading r("UNITS/MM\nCYCLE/DRILL,FEDTO,9,MMPM,100,RAPTO,3\nRAPID\nGOTO/0,0,0\n");
    EXPECT_NE(r.problems().find("a point at rapid while a hole cycle is in force"), std::string::npos);
    EXPECT_FALSE(has_modal(r, Modal::canned));
}

TEST(AptCycle, NxNamesTheKindBehindDrillAndGoesOutToWhereItStood) {
    const Reading r(
        "UNITS/MM\nRAPID\nGOTO/0,0,50\nCYCLE/DRILL,DEEP,STEP,4,RAPTO,3,FEDTO,-9,RTRCTO,AUTO,MMPM,250\nGOTO/0,0,10\n");
    EXPECT_EQ(value(r, Code::e), 50);
    EXPECT_EQ(value(r, Code::q), 4);
    EXPECT_EQ(r.problems(), "");
    EXPECT_NE(r.messages().find("RTRCTO,AUTO is taken"), std::string::npos);
}

TEST(AptCycle, OnCallsTheCycleAgainWithOtherSizes) {
    const Reading r("UNITS/MM\nCYCLE/DRILL,FEDTO,9,MMPM,100,RAPTO,3\nGOTO/0,0,0\nCYCLE/ON,FEDTO,-12\nGOTO/5,0,0\n");
    EXPECT_EQ(value(r, Code::z), -12);
    EXPECT_EQ(value(r, Code::radius), 3);
    EXPECT_NE(Reading("UNITS/MM\nCYCLE/ON\n").messages().find("there is none"), std::string::npos);
}

}  // namespace obrys::read::apt
