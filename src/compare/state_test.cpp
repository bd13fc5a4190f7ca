#include <algorithm>

#include "compare/streams_testing.hpp"

namespace obrys::compare {
namespace {

/// A chuck that opens under a turning spindle is another machine's day than one that opens when it stands.
TEST(CompareState, WhatHoldsAtAFunctionOfTheMachine) {
    const cl::Spindle turns{1000, cl::SpindleMode::rpm, 1}, slower{900, cl::SpindleMode::rpm, 1},
        stands{1000, cl::SpindleMode::rpm, 0};
    cl::Spindle held = stands, aside = stands;
    held.held = 90, aside.held = 91;
    const auto does = [](const cl::Step& function, const cl::Spindle& before, const cl::Spindle& behind) {
        return Steps{line(10), before, function, behind, line(20)};
    };
    for (const cl::Step& function : {cl::Step(cl::Auxiliary{'M', 69, 0}), cl::Step(cl::Output{1, false, 1, false})}) {
        EXPECT_EQ(differences(does(function, turns, stands), does(function, stands, stands)), "spindle");
        EXPECT_EQ(differences(does(function, turns, stands), does(function, slower, stands)), "spindle");
        EXPECT_EQ(differences(does(function, held, stands), does(function, aside, stands)), "spindle");
        EXPECT_EQ(differences(does(function, turns, stands), does(function, turns, stands)), "");
        const Steps flows{line(10), cl::Coolant{true, false}, function, cl::Coolant{}, line(20)};
        EXPECT_EQ(differences(flows, {line(10), function, line(20)}), "coolant");
    }
}

TEST(CompareState, WhatABlockOfAFunctionDoesHoldsThere) {
    const cl::Spindle turns{1000, cl::SpindleMode::rpm, 1};
    const auto path = [](const Steps& steps) {
        Path out(1e-4);
        for (const cl::Step& s : steps) out.take({s, {0, 1, 2}, 0});  // all of one block
        return out;
    };
    const cl::Auxiliary function{'M', 69, 0};
    EXPECT_TRUE(compare(path({turns, function}), path({function, turns}), {}).first.empty());
}

TEST(CompareState, WhatTurnsWhereAProgramIsOverCounts) {
    const cl::Spindle turns{1000, cl::SpindleMode::rpm, 1}, stands{1000, cl::SpindleMode::rpm, 0};
    const cl::Stop end{cl::StopKind::end};
    const Steps runs_on{turns, line(10)}, stopped{turns, line(10), stands}, ended{turns, line(10), stands, end};
    const auto done = [](const Steps& a, const Steps& b) {
        const Result r = compare(path_of(a), path_of(b), {});
        return std::any_of(r.first.begin(), r.first.end(), [](const Difference& d) { return d.is_done; });
    };
    EXPECT_TRUE(done(ended, runs_on));
    EXPECT_TRUE(done(runs_on, ended));
    EXPECT_TRUE(done(stopped, runs_on));
    EXPECT_FALSE(done(ended, stopped));
    EXPECT_FALSE(done(stopped, ended));
    EXPECT_FALSE(done(runs_on, runs_on));
}

TEST(CompareState, ATapOfAHeldSpindleTurnsAsFastAsItsWordSays) {
    const auto tap = [](double speed) {
        cl::Spindle held{speed, cl::SpindleMode::rpm, 0};
        held.held = 0;
        cl::Thread thread;
        thread.to = {0, 0, -20}, thread.pitch = 1.5, thread.rigid_tap = true, thread.axis = {0, 0, 1};
        return Steps{line(10), held, thread};
    };
    EXPECT_EQ(differences(tap(500), tap(600)), "spindle");
    EXPECT_EQ(differences(tap(500), tap(500)), "");
}

TEST(CompareState, ACallOfTheToolInTheSpindleCountsOnOneControl) {
    const cl::ToolChange tool{1, 1, ""};
    const Steps once{tool, line(10), line(20)}, twice{tool, line(10), tool, line(20)};
    constexpr Tolerance same{.same_control = true};
    for (const Result& r : {compared(once, twice, same), compared(twice, once, same)}) {
        ASSERT_NE(r.of(Aspect::events), nullptr);
        EXPECT_FALSE(r.of(Aspect::events)->is_done);
    }
    constexpr Tolerance written{.is_written_from_a = true};
    ASSERT_NE(compared(once, twice, written).of(Aspect::events), nullptr);
    EXPECT_TRUE(compared(once, twice, written).of(Aspect::events)->is_done);
    EXPECT_EQ(compared(twice, once, written).of(Aspect::events), nullptr);
    EXPECT_EQ(compared(twice, twice, same).of(Aspect::events), nullptr);
    EXPECT_EQ(compared(once, twice, {}).of(Aspect::events), nullptr);
}

}  // namespace
}  // namespace obrys::compare
