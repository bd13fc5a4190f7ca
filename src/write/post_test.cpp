#include "write/post.hpp"

#include <gtest/gtest.h>

#include "write/post_testing.hpp"
#include "write/writer_testing.hpp"

namespace obrys::write {
namespace {

TEST(Post, EveryShippedOneCanBeReadAndMovesTheTool) {
    ASSERT_GE(shipped_post_names().size(), 8U);
    for (const std::string& name : shipped_post_names()) {
        const Post post = post_of(std::string(shipped_post(name)->text));
        if (post.is_canon) continue;
        EXPECT_TRUE(post.has(Command::rapid)) << name;
        EXPECT_TRUE(post.has(Command::linear)) << name;
        EXPECT_TRUE(post.has(Command::arc_cw) || post.staircase) << name;
        EXPECT_FALSE(post.title.empty()) << name;
    }
}

TEST(Post, WhatItExtendsStaysBelow) {
    const Post post = post_of(
        "extends = \"fanuc\"\n[motion]\nrapid = \"G00 X{x}\"\n[[cycle]]\nkind = \"canned-drill\"\n"
        "call = \"G81 X{x}\"\n");
    EXPECT_EQ(post[Command::rapid].front().front().before, "G00");
    EXPECT_TRUE(post.has(Command::linear));
    EXPECT_EQ(post.cycles.at(cl::CycleKind::canned_drill).size(), 3U);  // its own, then those of fanuc
}

TEST(Post, KindsOfCyclesOfThePostBelowCanBeLeftOut) {
    const Post post = post_of(
        "extends = \"fanuc\"\n[cycles]\nwithout = [\"canned-peck\", \"canned-drill\"]\n[[cycle]]\n"
        "kind = \"canned-drill\"\ncall = \"G81 X{x}\"\n");
    EXPECT_EQ(post.cycles.count(cl::CycleKind::canned_peck), 0U);
    EXPECT_EQ(post.cycles.at(cl::CycleKind::canned_drill).size(), 1U);
    EXPECT_EQ(faults_of("[cycles]\nwithout = \"drilling\"\n"), "2: there is no kind of cycle called 'drilling'\n");
}

TEST(Post, ValuesAmongTheLettersOfAWord) {
    const Post post = post_of("extends = \"iso\"\n[tool]\ndata = \"? $P[{number},{edge}]={length} R{tool-radius}\"\n");
    const Token& word = post[Command::tool_data].front()[1];
    ASSERT_EQ(word.indices.size(), 2U);
    EXPECT_EQ(word.indices[0].before, "$P[");
    EXPECT_EQ(word.indices[1].before, ",");
    EXPECT_EQ(word.before, "]=");
    EXPECT_EQ(write(post, {cl::ToolData{3, 2, 50.5, {}}}).text, "$P[3,2]=50.5\n");
    EXPECT_EQ(write(post, {cl::ToolData{3, 2, {}, 4.0}}).text, "R4\n");
    EXPECT_EQ(faults_of("[tool]\ndata = \"$P[{name}]={length}\"\n").substr(0, 3), "2: ");
    EXPECT_EQ(faults_of("[tool]\ndata = \"$P[{nobody}]={length}\"\n"), "2: there is no value called 'nobody'\n");
}

TEST(Post, FunctionsAreRefusedByTheirNumbers) {
    const Post post = post_of("extends = \"iso\"\n[function]\nrefused = [\"M7\", \"M89-99\"]\n");
    for (const std::int64_t n : {7, 89, 99}) EXPECT_TRUE(is_among(post.functions_refused, 'M', n)) << n;
    for (const std::int64_t n : {6, 8, 88, 100}) EXPECT_FALSE(is_among(post.functions_refused, 'M', n)) << n;
    EXPECT_FALSE(is_among(post.functions_refused, 'H', 7));
    EXPECT_EQ(write(post, {cl::Auxiliary{'M', 90}, cl::Auxiliary{'M', 88}}).text, "M88\n");
    for (const std::string wrong : {"29", "m29", "M", "M9-", "M9-8", "M9-1x"})
        EXPECT_EQ(faults_of("[function]\nrefused = \"" + wrong + "\"\n"),
                  "2: '" + wrong + "' is no function of a machine\n");
}

TEST(Post, FaultsHaveTheirPlace) {
    EXPECT_EQ(faults_of("[motion]\nrapid = \"G0 X{w}\"\n"), "2: there is no value called 'w'\n");
    EXPECT_EQ(faults_of("[motion]\nrapid = \"G0 X{x:big}\"\n"), "2: there is no style of numbers called 'big'\n");
    EXPECT_EQ(faults_of("[motion]\nrapid = \"G0 X{x\"\n"), "2: a brace is not closed\n");
    EXPECT_EQ(faults_of("[motion]\nrapid = \"G0 X{x*two}\"\n"), "2: 'two' is no number to multiply with\n");
    EXPECT_NE(faults_of("[motion]\nrapit = \"G0\"\n").find("unknown key 'rapit'"), std::string::npos);
    EXPECT_EQ(faults_of("[[cycle]]\nkind = \"drilling\"\n"), "2: there is no kind of cycle called 'drilling'\n");
    EXPECT_EQ(faults_of("[[cycle]]\nkind = \"drill\"\nwhen = \"depht\"\n"), "3: there is no value called 'depht'\n");
    EXPECT_EQ(faults_of("extends = \"nobody\"\n"), "1: there is no shipped post called 'nobody'\n");
}

}  // namespace
}  // namespace obrys::write
