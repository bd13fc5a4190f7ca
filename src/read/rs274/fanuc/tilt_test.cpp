#include <gtest/gtest.h>

#include <algorithm>

#include "read/rs274/fanuc/reading.hpp"

namespace obrys::read::rs274 {

using program::Datum;
using program::Special;
using program::SpecialKind;
using testing::fanuc;
using testing::haas;
using testing::program;
using testing::Reading;

namespace {

std::vector<SpecialKind> kinds(const Reading& r) {
    std::vector<SpecialKind> out;
    for (const Special& s : r.unit().specials) out.push_back(s.kind);
    return out;
}

bool says(const Special& s, Datum datum) {
    return std::any_of(s.data.begin(), s.data.end(), [&](const auto& d) { return d.datum == datum; });
}

}  // namespace

TEST(FanucTilt, APlaneItsAxesAndItsEnd) {
    const Reading r = fanuc(program("G68.2 X1. Y2. Z3. I10. J20. K30.\nG53.1\nG69\nG69"));
    EXPECT_EQ(r.messages(), "");
    EXPECT_EQ(kinds(r), (std::vector{SpecialKind::plane_euler, SpecialKind::plane_taken_up, SpecialKind::plane_reset}))
        << "G69 ends no plane where none is in force";
    const Special& plane = r.unit().specials.front();
    for (const Datum d : {Datum::origin_x, Datum::origin_y, Datum::origin_z, Datum::angle_a, Datum::angle_b,
                          Datum::angle_c, Datum::positioning})
        EXPECT_TRUE(says(plane, d));
}

/// What is not run leaves no plane that could be taken for the one that holds.
TEST(FanucTilt, FormsThatAreNotRunAreNamed) {
    for (const std::string words : {"P2 Q1 X0. Y0. Z0.", "P3 Q1 X0. Y0. Z0. I1. J0. K0.", "P4 X0. Y0. Z0. I1. J0. K0.",
                                    "P7 X0. Y0. Z0. I1. J0. K0.", "X0. Y0. Z0. I1. J0.", "Y0. Z0. I1. J0. K0.",
                                    "X0. Y0. Z0. I1. J0. K0. R5.", "P1 Q321 X0. Y0. Z0. I1. J0. K0."}) {
        const Reading r = fanuc(program("G68.2 " + words));
        EXPECT_EQ(kinds(r), std::vector{SpecialKind::plane_not_said}) << words;
        EXPECT_FALSE(r.unit().problems.empty()) << words;
    }
    for (const std::string code : {"G68.3 X0. Y0. Z0.", "G68.4 X0. Y0. Z0. I1. J0. K0.", "G53.6 H1"})
        EXPECT_FALSE(fanuc(program(code)).unit().problems.empty()) << code;
}

TEST(FanucTilt, WordsWithinAPlaneThatAreNotKnownThere) {
    const std::string plane = "G68.2 X0. Y0. Z0. I0. J30. K0.\n";
    for (const std::string block : {"G55", "G52 X1.", "G92 X0.", "G28 X0.", "G68 X0 Y0 R5.", "G0 A5.", "G0 C5.",
                                    "G68.2 X0. Y0. Z0. I0. J10. K0.", "G53.1 P1"})
        EXPECT_FALSE(fanuc(program(plane + block)).unit().problems.empty()) << block;
    for (const std::string block :
         {"G0 X1.", "G53 Z0.", "G81 X1. Y1. Z-1. R1. F50.", "G43 H1 Z5.", "G41 D1 X5.", "G53.1"})
        EXPECT_TRUE(fanuc(program(plane + block)).unit().problems.empty()) << block;
    EXPECT_TRUE(fanuc(program(plane + "G69\nG55\nG0 A5.")).unit().problems.empty()) << "behind it they are";
}

TEST(FanucTilt, HaasHasWordsOfItsOwn) {
    const Reading r = haas(program("G268 X0. Y0. Z0. I0. J30. K0. Q123\nG253\nG269\nG254\nG0 X1.\nG255\nG255"));
    EXPECT_EQ(r.messages(), "");
    EXPECT_EQ(kinds(r), (std::vector{SpecialKind::plane_spatial, SpecialKind::plane_taken_up, SpecialKind::plane_reset,
                                     SpecialKind::plane_of_axes, SpecialKind::plane_reset}));
    for (const std::string words :
         {"G268 X0. Y0. Z0. I0. J30. K0.", "G268 X0. Y0. Z0. I0. J30. K0. Q113", "G68.2 X0. Y0. Z0."})
        EXPECT_FALSE(haas(program(words)).unit().problems.empty()) << words;
}

}  // namespace obrys::read::rs274
