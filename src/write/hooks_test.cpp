#include "write/hooks.hpp"

#include <gtest/gtest.h>

#include "write/post_testing.hpp"
#include "write/writer_testing.hpp"

namespace obrys::write {
namespace {

const char* const base_post =
    "[modal]\ncoordinates = [\"X\", \"Y\", \"Z\"]\nwords = [\"F\"]\ngroups = [[\"G0\", \"G1\"]]\n"
    "[motion]\nrapid = \"G0 X{x} Y{y} Z{z}\"\nlinear = \"G1 X{x} Y{y} Z{z} {feed}\"\n"
    "[feed]\nper-minute = \"F{feed}\"\n[stop]\noptional = \"M1\"\n";

std::string with_lua(const std::string& lua) { return std::string(base_post) + "[lua]\ntext = '''\n" + lua + "'''\n"; }

/// What the post writes of a line to X10 Y0 Z0 at F200, and what it loses.
Written line_by(const std::string& lua) {
    return write(post_of(with_lua(lua)), {cl::Feed{200}, cl::Linear{{10, 0, 0}}});
}

TEST(Hooks, AFunctionGetsTheValuesAndItsBlocksStandInThePlaceOfTheTemplate) {
    EXPECT_EQ(
        line_by(
            "on[\"motion.linear\"] = function(v)\n return \"G1 X{x} Y{y} Z{z} E\" .. number(v.x / 4, \"length\") .. "
            "\" {feed}\"\nend\n")
            .text,
        "G1 X10 Y0 Z0 E2.5 F200\n");
    EXPECT_EQ(line_by("on[\"motion.linear\"] = function(v) return {\"M97\", \"G1 X{x} {feed}\"} end\n").text,
              "M97\nG1 X10 F200\n");
    EXPECT_EQ(line_by("on[\"motion.linear\"] = function(v) end\n").text, "G1 X10 Y0 Z0 F200\n");
}

TEST(Hooks, AWordThatAFunctionWritesByItselfIsSaidAgain) {
    const Post post = post_of(with_lua("on[\"motion.rapid\"] = function(v) return \"G0 X99 Y{y} Z{z}\" end\n"));
    const Written w =
        write(post, {cl::Linear{{10, 0, 0}}, cl::Linear{{20, 0, 0}, {0, 0, 1}, true}, cl::Linear{{10, 0, 0}}});
    EXPECT_EQ(w.text, "G1 X10 Y0 Z0\nG0 X99\nG1 X10\n");
}

TEST(Hooks, WhatAFunctionRefusesIsLostWithItsReason) {
    const Written w = line_by("on[\"motion.linear\"] = function(v) if v.x > 5 then refuse(\"X is too far\") end end\n");
    EXPECT_EQ(w.text, "");
    ASSERT_EQ(w.lost.size(), 1U);
    EXPECT_EQ(w.lost[0], "a move: the post refuses it: X is too far");
}

TEST(Hooks, ACycleThatIsRefusedIsWrittenByItsMoves) {
    const std::vector<cl::Step> bracket{
        cl::Linear{{10, 0, 5}, {0, 0, 1}, true},
        cl::CycleBegin{cl::Cycle{cl::CycleKind::drill, {}, {{cl::CycleRole::depth, -5}}, "", {}}, {10, 0, 5}},
        cl::Linear{{10, 0, -5}}, cl::CycleEnd{}};
    const Written folded =
        write(post_of(with_lua("on[\"cycle.drill\"] = function(v) return \"G81 Z{depth}\" end\n")), bracket);
    EXPECT_EQ(folded.text, "G0 X10 Y0 Z5\nG81 Z-5\n");
    const Written moves = write(post_of(with_lua("on[\"cycle.drill\"] = function(v) refuse(\"no\") end\n")), bracket);
    EXPECT_EQ(moves.text, "G0 X10 Y0 Z5\nG1 Z-5\n");
    EXPECT_TRUE(moves.lost.empty());
    EXPECT_EQ(moves.expanded.size(), 2U);
}

TEST(Hooks, ErrorsHaveTheirPlaceInThePost) {
    EXPECT_EQ(faults_of(with_lua("on[\"motion.linear\"] = function(v)\n  return = 5\nend\n")),
              "15: unexpected symbol near '='\n");
    EXPECT_EQ(faults_of(with_lua("on[\"motion.linar\"] = function(v) end\n")),
              "14: there is no command called 'motion.linar'\n");
    EXPECT_EQ(faults_of(with_lua("on[\"cycle.dril\"] = function(v) end\n")),
              "14: there is no kind of cycle called 'dril'\n");
    EXPECT_NE(faults_of(with_lua("on[\"feed.per-rev\"] = function(v) end\n")).find("is a part of other blocks"),
              std::string::npos);
    EXPECT_NE(faults_of(with_lua("while true do end\n")).find("14: takes more than 500000 steps"), std::string::npos);
    EXPECT_NE(faults_of(std::string(base_post) + "[lua]\n"), "");
}

TEST(Hooks, AFunctionThatFailsIsSaidAndNotCalledAgain) {
    const Post post = post_of(with_lua("on[\"motion.linear\"] = function(v)\n  return v.nothing.x\nend\n"));
    const Written w = write(post, {cl::Linear{{10, 0, 0}}, cl::Linear{{20, 0, 0}}});
    EXPECT_EQ(w.text, "");
    ASSERT_EQ(w.lost.size(), 2U);
    EXPECT_NE(w.lost[0].find("attempt to index a nil value"), std::string::npos) << w.lost[0];
    EXPECT_NE(w.lost[1].find("has failed before"), std::string::npos) << w.lost[1];
    ASSERT_TRUE(w.first_in_post);
    const std::string text = with_lua("on[\"motion.linear\"] = function(v)\n  return v.nothing.x\nend\n");
    EXPECT_EQ(text.substr(w.first_in_post->begin, 8), "return v");
}

/// What a function that does this is said to do wrong.
std::string fault_of(const std::string& does) {
    const Written w = line_by("on[\"motion.linear\"] = function(v) " + does + " end\n");
    return w.lost.empty() ? "wrote " + w.text : w.lost[0];
}

TEST(Hooks, NoFileNoProcessNoCodeAndNoEndOfTime) {
    for (const char* missing :
         {"io.open('x')", "os.execute('ls')", "os.time()", "require('x')", "load('x')", "dofile('x')",
          "loadstring('x')", "debug.getinfo(1)", "setmetatable({}, {})", "string.dump(on.x)", "coroutine.create(on.x)",
          "pcall(error)", "collectgarbage()", "math.random()", "string.gsub('a', '.-', '')", "table.move({}, 1, 9, 2)",
          "package.loadlib('x', 'y')"})
        EXPECT_NE(fault_of(missing).find("attempt to"), std::string::npos) << missing << ": " << fault_of(missing);
    for (const char* endless : {"while true do end",
                                "local function f() return f() end f()",
                                "for i = 1, 1e15 do end",
                                "repeat local s = ('x'):rep(1000) until false",
                                "for i = 1, 1e9 do ('x'):rep(90000):find('y') end",
                                "local s = 'x' while true do s = s .. s end",
                                "local t = {} while true do t[#t + 1] = {} end",
                                "local function f() return 1 + f() end f()",
                                "return ('x'):rep(1e9)",
                                "return ('x'):rep(-1, 5):rep(1e15)",
                                "return table.concat({}, '', 1, 1e15)",
                                "return {table.unpack({}, 1, 1e8)}",
                                "error()",
                                "error({})",
                                "return {{}}",
                                "return 5",
                                "return \"G1 X{wide}\"",
                                "return \"G1\\nG2\"",
                                "return number(1e9, \"length\")",
                                "return number(1, \"big\")"})
        EXPECT_EQ(fault_of(endless).find("wrote"), std::string::npos) << endless << ": " << fault_of(endless);
}

TEST(Hooks, PairsGoesInOneOrder) {
    EXPECT_EQ(
        line_by(
            "on[\"motion.linear\"] = function(v) local s = \"\" for k in pairs(v) do s = s .. k end return \"(\" .. s "
            ".. \")\" end\n")
            .text,
        "(feednamexyz)\n");
}

TEST(Hooks, ATextInAFileIsLoadedAndHasItsPlaces) {
    base::Sources sources;
    base::Diagnostics diagnostics;
    const auto file = sources.add("p.toml", std::string(base_post) + "[lua]\nfile = \"f.lua\"\n");
    const LoadText load = [&](const std::string& name, const base::Span&) {
        EXPECT_EQ(name, "f.lua");
        return std::optional(sources.add("f.lua", "\n  on = 5\n"));
    };
    EXPECT_FALSE(read_post(file, sources, diagnostics, load));
    ASSERT_EQ(diagnostics.all().size(), 1U);
    EXPECT_EQ(sources[diagnostics.all()[0].where.file].name, "f.lua");
    base::Diagnostics without;
    EXPECT_FALSE(read_post(file, sources, without));
    EXPECT_EQ(without.all().front().text, "here a post can name no file");
}

}  // namespace
}  // namespace obrys::write
