#include "read/sinumerik/archive.hpp"

#include <gtest/gtest.h>

#include "read/sinumerik/reading.hpp"

namespace obrys::read::sinumerik {

using testing::Reading;

TEST(SinumerikArchive, MembersWithTheirKind) {
    const std::string text = "%_N_MAIN_MPF\n;$PATH=/_N_WKS_DIR\nX1\n%_N_SUB1_SPF\r\nX2\n%_N_TO_INI\n$TC_DP1[1,1]=500\n";
    const auto members = archive_members(text);
    ASSERT_EQ(members.size(), 3u);
    EXPECT_EQ(members[0].name, "MAIN");
    EXPECT_EQ(members[0].kind, "MPF");
    EXPECT_EQ(text.substr(members[0].begin, members[0].end - members[0].begin), "\n;$PATH=/_N_WKS_DIR\nX1\n");
    EXPECT_EQ(members[2].name, "TO");
    EXPECT_EQ(members[2].kind, "INI");
    EXPECT_FALSE(members[2].is_program());
    EXPECT_EQ(members[2].end, text.size());
}

TEST(SinumerikArchive, EachProgramIsAUnit) {
    const Reading r("%_N_MAIN_MPF\nX1\nSUB1\n%_N_SUB1_SPF\nX2\nM17\n%_N_TO_TOA\n$TC_DP1[1,1]=500\n");
    ASSERT_EQ(r.units.size(), 2u);
    EXPECT_EQ(r.units[0].name, "MAIN");
    EXPECT_EQ(r.units[1].name, "SUB1");
    EXPECT_EQ(r.tree(1), "0 X2\n1 M17\n");
    EXPECT_EQ(
        r.messages(),
        "TEST.MPF:7:1: note: the archive member TO (TOA) is no program [no-effect]\n  %_N_TO_TOA\n  ^~~~~~~~~~\n");
}

TEST(SinumerikArchive, TextInFrontOfTheFirstHeaderIsAUnitToo) {
    EXPECT_EQ(Reading("X1\n%_N_A_SPF\nX2\n").units.size(), 2u);
    EXPECT_EQ(Reading("; made by hand\n%_N_A_SPF\nX2\n").units.size(), 1u);
}

TEST(SinumerikArchive, PlainNames) {
    EXPECT_EQ(plain_name("/_N_CUS_DIR/_N_L320_SPF"), "L320");
    EXPECT_EQ(plain_name("welle.spf"), "WELLE");
    EXPECT_EQ(plain_name("_N_"), "_N_");
}

TEST(SinumerikArchive, DialogsAreNoPrograms) {
    const Reading r("//M(mask)\nDEF VAR1=(R///)\n//END\n", "custom.com");
    EXPECT_EQ(r.codes(), std::vector<std::string>{"unsupported"});
    EXPECT_TRUE(r.unit().statements.empty());
}

TEST(SinumerikLikelihood, TellsControlsApart) {
    EXPECT_GT(likelihood("N10 G54 G90\nN20 X=R1+5\n", "A.MPF"), 70);
    EXPECT_GT(likelihood("%_N_A_MPF\n;$PATH=/_N_MPF_DIR\nR1=5\n", "A"), 70);
    EXPECT_GT(likelihood("PROC A\nIF R1==2\nMSG(\"x\")\nENDIF\n", "a.txt"), 30);
    EXPECT_LT(likelihood("0 BEGIN PGM A MM\n1 TOOL CALL 1 Z S1000\n2 END PGM A MM\n", "A.H"), 10);
    EXPECT_LT(likelihood("O1000\n#100=5\nG65 P9000\nM30\n", "A.NC"), 10);
}

}  // namespace obrys::read::sinumerik
