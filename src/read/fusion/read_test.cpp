#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "read/fusion/fusion_testing.hpp"

namespace obrys::read::fusion {

using testing::Bytes;
using testing::Reading;

namespace {

bool says(const std::string& text, std::string_view part) { return text.find(part) != std::string::npos; }

Bytes cycle(std::string_view name) {
    Bytes b =
        Bytes().operation().rapid(1, 2, 15).whole(300).text("http://www.example.com/nc/cycle/" + std::string(name));
    return b.parameter("clearance", 5)
        .parameter("retract", 4)
        .parameter("stock", -1)
        .parameter("depth", 9)
        .parameter("feedrate", 400);
}

}  // namespace

TEST(FusionRead, EveryPartOfAnOperation) {
    const Reading r(Bytes().operation().rapid(1, 2, 3).linear(4, 5, 6, 100).end_operation());
    EXPECT_EQ(r.messages(), "");
    EXPECT_EQ(r.problems(), "");
    EXPECT_TRUE(r.unit.unended.empty());
    EXPECT_EQ(r.unit.tool_definitions.size(), 1);
}

TEST(FusionRead, WhatIsNotWholeIsSaid) {
    EXPECT_TRUE(says(Reading(Bytes().operation().rapid(1, 2, 3)).unit.unended, "within an operation"));
    EXPECT_TRUE(says(Reading(Bytes().rapid(1, 2, 3)).messages(), "outside of a section"));
    const Reading cut(*listing_of(Bytes().operation().rapid(1, 2, 3).get() + "abc", 1 << 20));
    EXPECT_TRUE(says(cut.problems(), "the file ends within this record"));
    EXPECT_FALSE(cut.unit.unended.empty());
    EXPECT_TRUE(
        says(Reading(Bytes().operation().end_operation().whole(4711)).problems(), "nothing is known of this kind"));
}

TEST(FusionRead, NumbersThatAreNoneAreComplaints) {
    const float none = NAN;
    EXPECT_TRUE(says(Reading(Bytes().operation().whole(101).single(none).single(0).single(0).whole(0)).messages(),
                     "a coordinate of this move is no number"));
    EXPECT_TRUE(says(Reading(Bytes().operation().linear(0, 0, 0, -5)).messages(), "no number that a feed can have"));
    EXPECT_TRUE(
        says(Reading(Bytes().operation().linear(0, 0, 0, 5, 0x21000)).problems(), "nothing is known of these flags"));
}

TEST(FusionRead, ATextThatIsNoListingIsAComplaint) {
    const Reading r(
        "0 compact-nci \"x\"\nG0 X0\n\"\n7 rapid\n8 cycle\n9 parameter\n10 context\n11 tool\n12 command\n13 arc-cw "
        "\"\n");
    EXPECT_GE(r.diagnostics.all().size(), 9);
}

TEST(FusionRead, ACycleThatIsNotRunIsNamed) {
    for (const std::string_view name :
         {"back-boring", "thread-milling", "circular-pocket-milling", "probing-x", "inspect", "new"}) {
        const Reading r(cycle(name).linear(1, 2, -10, 0).whole(301).end_operation());
        EXPECT_TRUE(says(r.problems(), name)) << r.problems();
        EXPECT_EQ(r.unit.problems.size(), 1) << name;
    }
}

TEST(FusionRead, ACycleThatSaysTooLittleOrSomethingUnknownIsNotRun) {
    EXPECT_TRUE(says(Reading(cycle("deep-drilling").linear(1, 2, -10, 0)).problems(), "no depth of its pecks"));
    EXPECT_TRUE(says(Reading(cycle("drilling").parameter("newAngle", 3).linear(1, 2, -10, 0)).problems(),
                     "nothing is known of its newAngle"));
    Bytes none = Bytes().operation().whole(300).text("drilling");
    EXPECT_TRUE(says(Reading(none.linear(1, 2, -10, 0)).problems(), "it does not say clearance"));
}

TEST(FusionRead, CyclesAreCannedCyclesOfTheirKind) {
    struct Case {
        std::string_view name, kind;
    };
    for (const Case& c :
         std::array{Case{"drilling", "drilling"}, Case{"stop-boring", "stop-boring"}, Case{"reaming", "boring"}}) {
        const Reading r(cycle(c.name).linear(1, 2, -10, 0).whole(301).end_operation());
        EXPECT_EQ(r.problems(), "");
        int canned = -1;
        for (const program::Word& w : r.unit.words)
            if (program::code_of(w) == program::Code::modal && program::modal_of(w) == program::Modal::canned)
                canned = program::modal_number(w);
        ASSERT_GE(canned, 0) << c.name;
        EXPECT_EQ(r.unit.traits->canned[static_cast<std::size_t>(canned)].name, c.kind);
    }
}

TEST(FusionRead, ParametersOutsideOfCyclesAreKnown) {
    EXPECT_EQ(Reading(Bytes().parameter("operation:anything", 1).operation().end_operation()).problems(), "");
    EXPECT_TRUE(says(Reading(Bytes().parameter("passThrough", 1)).problems(), "nothing is known of this parameter"));
}

TEST(FusionRead, CommandsAreNamed) {
    EXPECT_TRUE(says(Reading(Bytes().whole(130).whole(38)).problems(), "probe on"));
    EXPECT_TRUE(says(Reading(Bytes().whole(130).whole(99)).problems(), "nothing is known of this command"));
}

TEST(FusionRead, TheWayToAnotherToolIsSaidToBeAssumed) {
    const Reading same(Bytes().operation().rapid(1, 2, 3).end_operation().operation().rapid(4, 5, 6).end_operation());
    EXPECT_EQ(same.messages(), "");
    const Reading tilted(
        Bytes().operation().rapid(1, 2, 3).end_operation().operation(0.6, 0.8).rapid(4, 5, 6).end_operation());
    EXPECT_TRUE(says(tilted.messages(), "between operations"));
}

TEST(FusionRead, AHoleWithItsBottomAboveIsRefused) {
    EXPECT_TRUE(says(Reading(cycle("gun-drilling").linear(1, 2, 10, 0)).problems(), "above its retract plane"));
}

}  // namespace obrys::read::fusion
