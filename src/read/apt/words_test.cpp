/// Words behind a known command: understood, or said.

#include <gtest/gtest.h>

#include "read/apt/reading.hpp"

namespace obrys::read::apt {

using program::Code;
using program::Modal;
using testing::has_modal;
using testing::Reading;
using testing::value;

namespace {

/// All that is said of one statement behind a start that complains of nothing.
std::string said_of(const std::string& statement) {
    const Reading r("UNITS/MM\nFEDRAT/100,MMPM\nRAPID\nGOTO/0,0,0\n" + statement + "\n");
    return r.problems() + r.messages();
}

}  // namespace

TEST(AptWords, NoneIsPassedOverInSilence) {
    for (const char* statement : {"RAPID/MODAL",
                                  "RAPID/1000",
                                  "FEDRAT/5,MMPM,MMPR",
                                  "FEDRAT/5,MMPM,6",
                                  "SPINDL/100,RPM,SFM",
                                  "SPINDL/100,CLW,CCLW",
                                  "SPINDL/OFF,CLW",
                                  "SPINDL/ON,OFF",
                                  "SPINDL/100,FAST",
                                  "LOADTL/1 2",
                                  "LOADTL/1,FOO",
                                  "CUTTER/10,FOO",
                                  "CUTTER/FOO,1",
                                  "TLDATA/TCUTTER,1,2",
                                  "COOLNT/ON,FOO",
                                  "CUTCOM/LEFT,FOO",
                                  "CUTCOM/OFF,FOO",
                                  "CYCLE/OFF,FOO",
                                  "CYCLE/INIT,FOO",
                                  "MULTAX/ON,5",
                                  "TLAXIS/0,0,1,FOO",
                                  "DELAY/1,FOO",
                                  "STOP/5",
                                  "STOP 5",
                                  "OPSTOP/5",
                                  "END/5",
                                  "UNITS/MM,FOO",
                                  "TRNTYP/WORLD,1,0,0",
                                  "SETUP/ROTATE,90",
                                  "SETUP/END,1,2",
                                  "TOOL/5",
                                  "GOTO,FOO/1,2,3",
                                  "GOTO/1,2,3/4",
                                  "TLLFT,GOTO/1,2,3",
                                  "COOLNT/,ON",
                                  "SPINDL/100,,CLW",
                                  "CIRCLE/0,0,0,0,0,1,5,6\nGOTO/1,2,3",
                                  "CIRCLE/0,0,0,0,0,1\nFINI",
                                  "CIRCLE/0,0,0,0,0,1\nEND-OF-PATH",
                                  "CIRCLE/0,0,0,0,0,1\nCYCLE/OFF"})
        EXPECT_NE(said_of(statement), "") << statement;
}

TEST(AptWords, WhatIsUnderstoodIsNotSaid) {
    for (const char* statement : {"RAPID/",
                                  "RAPID",
                                  "FEDRAT/MMPM,5",
                                  "SPINDL/ON,RPM,100,CCLW",
                                  "SPINDL/100,RPM,RANGE,2,CLW",
                                  "LOADTL/1,ADJUST,1",
                                  "TLDATA/DRILL,MILL,8.0,0.0,80.0,118.0,35.0",
                                  "TLDATA/MILL,8,0",
                                  "CUTCOM/OFF",
                                  "CYCLE/OFF",
                                  "MULTAX/ON",
                                  "MULTAX",
                                  "STOP",
                                  "OPSTOP",
                                  "END",
                                  "TRNTYP/WORLD,0,0,0",
                                  "SETUP/START,1",
                                  "SETUP/END,1",
                                  "DELAY/3,REV",
                                  "TOOL PATH/A,TOOL,B",
                                  "RAPID,GOTO/1,2,3"})
        EXPECT_EQ(said_of(statement), "") << statement;
}

TEST(AptWords, TheSenseOfTheSpindleMayStandBeforeOn) {
    EXPECT_EQ(value(Reading("SPINDL/1000,RPM,CCLW,ON\n"), Code::m), 4);
    EXPECT_EQ(value(Reading("SPINDL/ON,CCLW\n"), Code::m), 4);
    EXPECT_EQ(value(Reading("SPINDL/1000,CCLW\nSPINDL/OFF\nSPINDL/ON\n"), Code::m), 4);
    EXPECT_EQ(value(Reading("SPINDL/OFF\n"), Code::m), 5);
}

TEST(AptWords, AUnitThatIsNotSaidIsTheOneBefore) {
    const Reading r("UNITS/MM\nFEDRAT/0.2,MMPR\nGOTO/0,0,0\nFEDRAT/500\nGOTO/1,0,0\n");
    EXPECT_TRUE(has_modal(r, Modal::feed_per_rev));
    EXPECT_FALSE(has_modal(r, Modal::feed_per_minute));
    EXPECT_NE(r.messages().find("FEDRAT without a unit keeps the one before it"), std::string::npos);
    const Reading inches("UNITS/MM\nFEDRAT/10,IPM\nFEDRAT/20\nGOTO/1,0,0\n");
    EXPECT_EQ(value(inches, Code::feed), 508);
    EXPECT_NE(inches.messages().find("not that of the points"), std::string::npos);
    EXPECT_NE(Reading("UNITS/MM\nFEDRAT/20\nGOTO/1,0,0\n").messages().find("is taken per minute"), std::string::npos);
    EXPECT_EQ(Reading("UNITS/MM\nFEDRAT/10,MMPM\nFEDRAT/20\nGOTO/1,0,0\n").messages(), "");
    const Reading feet("UNITS/MM\nSPINDL/100,SFM\nSPINDL/200\n");
    EXPECT_DOUBLE_EQ(value(feet, Code::spindle), 60.96);
    EXPECT_NE(feet.messages().find("keeps the one before it, which is a cutting speed"), std::string::npos);
}

TEST(AptWords, AnArcBehindRapidIsRunAtRapid) {
    const std::string start = "UNITS/MM\nRAPID\nGOTO/0,0,5\n";
    for (const char* arc :
         {"RAPID\nCIRCLE/10,0,5,0,0,1,10\nGOTO/20,0,5\n", "CIRCLE/10,0,5,0,0,1,10\nRAPID\nGOTO/20,0,5\n"}) {
        const Reading r(start + arc);
        EXPECT_TRUE(has_modal(r, Modal::rapid_block)) << arc;
        EXPECT_TRUE(has_modal(r, Modal::arc_about)) << arc;
        EXPECT_NE(r.messages().find("an arc behind RAPID is run at rapid"), std::string::npos);
    }
}

TEST(AptWords, ARapidBeforeAPointMayStandInItsStatement) {
    const Reading r("UNITS/MM\nRAPID,GOTO/1,2,3\nRAPID,GODLTA/0,0,5\n");
    EXPECT_EQ(value(r, Code::z), 8);
    EXPECT_FALSE(has_modal(r, Modal::linear));
    EXPECT_EQ(r.messages(), "");
}

TEST(AptWords, CreosSystemGoesOnInTheNextLines) {
    const std::string rest = "  0.0, 1.0, 0.0, 0.0, $\n  0.0, 0.0, 1.0, 0.0\n";
    const std::string system = "$$-> CSYS / 1.0, 0.0, 0.0, 0.0, $\n" + rest;
    EXPECT_EQ(Reading("UNITS/MM\n" + system + "RAPID\nGOTO/1,2,3\n" + system + "RAPID\nGOTO/1,2,4\n").messages(), "");
    const Reading other("UNITS/MM\n" + system + "$$-> CSYS / 1.0, 0.0, 0.0, 5.0, $\n" + rest + "RAPID\nGOTO/1,2,3\n");
    EXPECT_NE(other.problems().find("lies elsewhere from here on"), std::string::npos);
    EXPECT_NE(Reading("UNITS/MM\n$$-> CSYS / 1.0, $\nRAPID\nGOTO/1,2,3\n").problems().find("twelve numbers"),
              std::string::npos);
    EXPECT_EQ(value(Reading("UNITS/MM\n$$ a note $\nGOTO/1,2,3\n"), Code::z), 3);
}

TEST(AptWords, ATextOfToolPathsEndsWithTheLastOne) {
    EXPECT_EQ(Reading("TOOL PATH/A,TOOL,B\nUNITS/MM\nEND-OF-PATH\n$$ end\n").unit.unended, "");
    EXPECT_NE(Reading("TOOL PATH/A,TOOL,B\nUNITS/MM\nEND-OF-PATH\nTOOL PATH/C,TOOL,D\n").unit.unended, "");
}

}  // namespace obrys::read::apt
