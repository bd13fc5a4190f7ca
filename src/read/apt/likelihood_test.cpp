#include <gtest/gtest.h>

#include "dialect/apt/systems.hpp"
#include "read/apt/read.hpp"

namespace obrys::read::apt {

TEST(AptLikelihood, CutterLocationsAndOthers) {
    EXPECT_GE(likelihood("PARTNO A\nUNITS/MM\nFEDRAT/100,MMPM\nGOTO / 1,2,3\nFINI\n", ""), 40);
    EXPECT_EQ(likelihood("N10 G0 X0\nGOTO 100\nM30\n", "A.NGC"), 0);
    EXPECT_EQ(likelihood("0 BEGIN PGM A MM\n1 L X+0 FMAX\n2 END PGM A MM\n", "A.H"), 0);
    EXPECT_EQ(likelihood("", "A.ncl"), 30);
}

TEST(AptLikelihood, SystemsAreKnownByTheirTexts) {
    using dialect::apt::system_of;
    EXPECT_EQ(system_of("$$     CATIA APT VERSION 1.0\n").name, "CATIA");
    EXPECT_EQ(system_of("TOOL PATH/A,TOOL,B\n").name, "NX");
    EXPECT_EQ(system_of("$$-> MFGNO / A\n").name, "Creo");
    EXPECT_EQ(system_of("CSI_SET_FLUTE_LENGTH/3.\n").name, "SolidWorks CAM");
    EXPECT_EQ(system_of("PARTNO A\n").name, "APT");
    EXPECT_EQ(system_of("TOOL PATH/A\n").sense, -1);
}

}  // namespace obrys::read::apt
