#include "write/post.hpp"

#include <gtest/gtest.h>

#include "write/post_testing.hpp"

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
