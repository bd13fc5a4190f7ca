#include <gtest/gtest.h>

#include <fstream>
#include <iterator>

#include "dialect/rs274/acramatic.hpp"
#include "read/rs274/acramatic_read.hpp"
#include "read/rs274/reading.hpp"

namespace obrys::read::rs274 {

namespace {

testing::Reading acramatic(const std::string& text) { return testing::Reading(text, "TEST.NC", read_acramatic); }

std::string statement_of(const testing::Reading& r, std::uint32_t i) {
    return program::testing::TreeText(r.unit(), r.names).statement(i);
}

const std::string gage = "[ $CYCLE_PARAMS(2)GAGE_HT_MM ] = 5.0\n";

}  // namespace

TEST(Acramatic, TheTableFillsTheWordsOfACycle) {
    const auto r = acramatic(gage + "[$CYCLE_PARAMS(2)G83_RELIEF]=1\nG83 X1 Y2 Z-30 R5 W9 J3 K4 F100\nX7\nG80\nM2\n");
    EXPECT_EQ(r.messages(), "");
    const std::string cycle =
        testing::m(program::Modal::canned, static_cast<int>(dialect::rs274::AcramaticCycle::peck));
    EXPECT_EQ(statement_of(r, 0), "F100 X1 Y2 Z-30 CR5 K4 Q5 I12 J8 D-offset1 E9 " + cycle);
    EXPECT_EQ(statement_of(r, 1), "X7 Q5 D-offset1");
}

TEST(Acramatic, WhatTheProgramDoesNotSayIsNotGuessed) {
    EXPECT_NE(acramatic("G81 X1 Y2 Z3 R4 F1\nM2\n").units.front().statements.size(), 0u);
    EXPECT_EQ(acramatic(gage + "G81 X1 Y2 Z3 F1\nM2\n").first_message(), "2:1 G81 needs R, the top of the hole");
    EXPECT_EQ(acramatic(gage + "G83 X1 Y2 Z3 R4 J5 K1 F1\nM2\n").first_message(),
              "2:17 J of G83 is 1, 2, 3, 11, 12 or 13");
    EXPECT_EQ(acramatic("X1\nM2\n").first_message(),
              "1:1 no motion is in force here, neither said before nor left by G80");
    EXPECT_EQ(acramatic("G0 X1 Q2\nM2\n").first_message(),
              "1:7 Q is none of the letters that are known of a straight move");
    EXPECT_EQ(acramatic("G5 X1\nM2\n").first_message(),
              "1:1 G5 is not among the G codes that are known of Acramatic 2100");
}

TEST(Acramatic, EveryLineIsReadWithoutHarm) {
    for (const char* text : {":",
                             "[",
                             "[$",
                             "[$CYCLE_PARAMS(2)",
                             "[$CYCLE_PARAMS(2)GAGE_HT_MM",
                             "(",
                             "(PGM",
                             "G",
                             "N",
                             ":N10",
                             "G84.1",
                             "G83 K",
                             "G4 F",
                             "H",
                             "X",
                             "G81 X1 Z1 R1 H1",
                             "M",
                             ";",
                             "%",
                             "G2 P",
                             "\x80\xff"})
        for (const std::string& before : {std::string(), gage + "G81 X1 Z1 R1 F1\n"}) {
            const auto r = acramatic(before + text + "\n");
            EXPECT_EQ(r.units.size(), 1u) << text;
        }
}

TEST(Acramatic, IsKnownByItsLines) {
    std::vector<std::string> signs;
    EXPECT_GE(acramatic_likelihood(gage + "N10 G0 X1.\n", "a.nc", &signs), 70);
    EXPECT_EQ(signs.front(), "[$CYCLE_PARAMS(");
    EXPECT_GE(acramatic_likelihood(":G90 G40 G94\n:T1 M06\nG0 X1\n", "a.nc"), 55);
    EXPECT_EQ(acramatic_likelihood("%\nO1\nG84.1 X1. Y1.\nM30\n%\n", "a.nc"), 0);
    EXPECT_EQ(acramatic_likelihood("; : comment\nG0 X1\n", "a.nc"), 0);
}

/// The page lists every code and every parameter of the tables.
TEST(AcramaticDocs, ThePageHasWhatTheTablesHave) {
    std::ifstream in(std::string(OBRYS_SOURCE_DIR) + "/docs/dialects/acramatic.md");
    const std::string page{std::istreambuf_iterator<char>(in), {}};
    for (const auto& g : dialect::rs274::acramatic.g) {
        const std::string name =
            "G" + std::to_string(g.number / 10) + (g.number % 10 != 0 ? "." + std::to_string(g.number % 10) : "");
        EXPECT_NE(page.find("`" + name + "`"), std::string::npos) << name;
    }
    for (const auto& m : dialect::rs274::acramatic.m)
        for (int n = m.first; n <= m.last; ++n)
            EXPECT_NE(page.find("`M" + std::to_string(n) + "`"), std::string::npos) << n;
    for (const auto& p : dialect::rs274::acramatic_parameters())
        EXPECT_NE(page.find("`" + std::string(p.name) + "`"), std::string::npos) << p.name;
}

}  // namespace obrys::read::rs274
