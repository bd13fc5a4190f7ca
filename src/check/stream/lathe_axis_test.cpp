/// Tools on a lathe's axis and beside it: what holds them, how they are used, and the ways of rapids.

#include <gtest/gtest.h>

#include <algorithm>

#include "base/codes.hpp"
#include "check/stream/bench_part.hpp"

namespace obrys::check {
namespace {

using namespace bench_part;
using Codes = std::vector<std::string>;

shop::Tool on_axis(std::uint32_t number, shop::ToolKind kind, double diameter) {
    shop::Tool t;
    t.number = number;
    t.kind = kind;
    t.radius = diameter / 2;
    return t;
}

/// A bar of radius 20 from Z 0 to Z 100; the tools come from the right.
Setup bar() {
    check::Setup s = setup();
    s.part.reset();
    s.allowance.reset();
    s.scope = shop::Scope::collisions;
    shop::Tool held = on_axis(1, shop::ToolKind::drill, 10);
    held.cutting_length = 15;
    held.shank = {{10, 10, 15}};
    held.holder = {{30, 30, 40}};
    shop::Tool bare = on_axis(2, shop::ToolKind::drill, 10);
    bare.cutting_length = 15;
    shop::Tool tap = on_axis(3, shop::ToolKind::tap, 10);
    tap.pitch = 1.5;
    shop::Tool blunt = on_axis(4, shop::ToolKind::end_mill, 12);
    blunt.plunges = false;
    shop::Tool left = on_axis(6, shop::ToolKind::drill, 8);
    left.left_hand = true;
    shop::Tool core = on_axis(7, shop::ToolKind::drill, 8.5);
    s.tools = {held, bare, tap, blunt, s.tools.front(), left, core};
    return s;
}

struct Turning : Script {
    explicit Turning(Setup s) : Script(std::move(s)) { turn(1).step(cl::Feed{0.1, cl::FeedMode::per_rev}); }
    Turning& turn(int sense) {
        step(cl::Spindle{1000, cl::SpindleMode::rpm, static_cast<std::int8_t>(sense), 0});
        return *this;
    }
    Turning& take(std::uint32_t number) {
        step(cl::ToolChange{number, 1, ""});
        rapid(105, 0);
        return *this;
    }
    Turning& thread(double z, double pitch) {
        step(cl::Thread{{0, 0, z}, pitch, true});
        return *this;
    }
};

bool assumes(const Result& r, std::string_view words) {
    return std::any_of(r.assumptions.begin(), r.assumptions.end(),
                       [words](const Note& n) { return n.text.find(words) != std::string::npos; });
}

TEST(LatheAxis, TheHolderMayNotEnterTheBar) {
    Turning in(bar());
    in.take(1).feed(65, 0).rapid(105, 0);
    const Result r = in.finish();
    ASSERT_FALSE(r.findings.empty());
    EXPECT_EQ(r.findings[0].code, base::codes::holder_in_stock);
    EXPECT_NEAR(r.findings[0].at->x, 95, 5 + 1e-6);
    Turning out(bar());
    out.take(1).feed(71, 0).rapid(105, 0);
    EXPECT_EQ(codes(out.finish()), Codes{});
}

TEST(LatheAxis, EdgesReachToTheirEnd) {
    Turning deep(bar());
    deep.take(2).feed(80, 0).rapid(105, 0);
    EXPECT_EQ(codes(deep.finish()), Codes{"edges-too-short@1"});
    Turning flush(bar());
    flush.take(2).feed(85, 0).rapid(105, 0);
    EXPECT_EQ(codes(flush.finish()), Codes{});
}

TEST(LatheAxis, ALengthSaysWhereTheSeatIs) {
    check::Setup s = bar();
    s.tools[6].length = 40;
    Turning run(s);
    run.take(7).feed(55, 0);
    const Result r = run.finish();
    ASSERT_EQ(codes(r), Codes{"holder-in-stock@1"});
    EXPECT_NEAR(r.findings[0].at->x, 97.5, 2.5 + 1e-6);
}

TEST(LatheAxis, WhatDoesNotCutAtItsCentreMayNotPlunge) {
    Turning full(bar());
    full.take(4).feed(90, 0);
    EXPECT_EQ(codes(full.finish()), Codes{"plunging-cut@1"});
    Turning drilled(bar());
    drilled.take(7).feed(80, 0).rapid(105, 0);
    drilled.take(4).feed(90, 0);
    EXPECT_EQ(codes(drilled.finish()), Codes{});
}

TEST(LatheAxis, ARightHandDrillThatStandsCutsWithM3) {
    Turning wrong(bar());
    wrong.turn(-1).take(7).feed(90, 0);
    EXPECT_EQ(codes(wrong.finish()), Codes{"wrong-rotation@1"});
    Turning left(bar());
    left.turn(-1).take(6).feed(90, 0);
    EXPECT_EQ(codes(left.finish()), Codes{});
    Turning left_wrong(bar());
    left_wrong.take(6).feed(90, 0);
    EXPECT_EQ(codes(left_wrong.finish()), Codes{"wrong-rotation@1"});
}

TEST(LatheAxis, ATapGoesByItsPitchAndComesOutAsItWentIn) {
    const auto tapped = [](double in, double out) {
        Turning run(bar());
        run.take(7).feed(70, 0).rapid(105, 0);
        run.take(3).thread(80, in).thread(105, out);
        return codes(run.finish());
    };
    EXPECT_EQ(tapped(1.5, 1.5), Codes{});
    EXPECT_EQ(tapped(1.25, 1.25), Codes{"tap-pitch@4"});
    EXPECT_EQ(tapped(1.5, 1.25), Codes{"tap-pitch@5"});
    EXPECT_EQ(tapped(-1.5, -1.5), Codes{"wrong-rotation@4"});
    Turning drawn(bar());
    drawn.take(7).feed(70, 0).rapid(105, 0);
    drawn.take(3).thread(80, 1.5).rapid(105, 0);
    EXPECT_EQ(codes(drawn.finish()), Codes{"wrong-rotation@5"});
    Turning full(bar());
    full.take(3).thread(90, 1.5).thread(105, 1.5);
    EXPECT_EQ(codes(full.finish()), Codes{"plunging-cut@1"});
}

TEST(LatheAxis, BesideTheAxisATouchIsSaidAndAWayInTheAirIsNot) {
    Turning air(bar());
    air.take(7).feed(90, 0).rapid(105, 0).rapid(105, 60).rapid(60, 60).rapid(140, 0);
    EXPECT_TRUE(air.finish().unchecked.empty());
    Turning touch(bar());
    touch.take(7).feed(90, 0).rapid(105, 0).rapid(105, 40).rapid(60, 40).rapid(60, 22);
    EXPECT_FALSE(touch.finish().unchecked.empty());
}

Setup with_jaws() {
    check::Setup s = bar();
    s.turned_clamps = {{"jaws", polygon({{0, 20}, {50, 20}, {50, 50}, {0, 50}})}};
    return s;
}

TEST(LatheAxis, BesideTheAxisItMayNotMeetAClamp) {
    Turning run(with_jaws());
    run.take(7).feed(90, 0).rapid(105, 0).rapid(105, 40).rapid(40, 40);
    const Result r = run.finish();
    EXPECT_EQ(codes(r), Codes{"clamp-collision@4"});
}

TEST(LatheAxis, AnInsertOfDefaultSizeMeetsTheClampAndThatIsListed) {
    check::Setup s = with_jaws();
    shop::Tool insert;
    insert.number = 9;
    insert.kind = shop::ToolKind::turning;
    insert.nose_radius = 0.8;
    s.tools.push_back(insert);
    for (const bool given : {false, true}) {
        s.tools.back().reach_given = given;
        Turning run(s);
        run.step(cl::ToolChange{9, 1, ""}).rapid(105, 18).feed(45, 18);
        const Result r = run.finish();
        EXPECT_EQ(codes(r), Codes{"clamp-collision@1"});
        const bool listed = assumes(r, "12.000 mm long");
        EXPECT_EQ(listed, !given);
    }
}

TEST(LatheAxis, ARapidGoesAsTheMachineLetsItsAxesGo) {
    check::Setup s = with_jaws();
    for (const char* name : {"X", "Z"}) {
        shop::MachineAxis axis;
        axis.name = name;
        s.machine.axes.push_back(axis);
    }
    const auto checked = [&](shop::RapidPath path) {
        s.machine.rapid_path = path;
        Turning run(s);
        run.step(cl::ToolChange{5, 1, ""}).rapid(105, 60).rapid(70, 22).rapid(40, 110);
        return run.finish();
    };
    EXPECT_EQ(codes(checked(shop::RapidPath::straight)), Codes{});
    EXPECT_EQ(codes(checked(shop::RapidPath::dog_leg)), Codes{"clamp-collision@2"});
}

TEST(LatheAxis, FromInFrontOfTheBarAnUprightInsertGoesHome) {
    check::Setup s = bar();
    shop::Tool insert;
    insert.number = 9;
    insert.kind = shop::ToolKind::turning;
    insert.nose_radius = 0.1;
    insert.orientation = 8;
    insert.tip_angle = 60;
    s.tools.push_back(insert);
    for (const double z : {104.0, 98.0}) {
        Turning run(s);
        run.step(cl::ToolChange{9, 1, ""}).rapid(104, 30).rapid(z, 19);
        run.step(cl::Linear{{NAN, 0, NAN}, {0, 0, 1}, true});
        EXPECT_EQ(run.finish().unchecked.empty(), z > 100) << z;
    }
}

}  // namespace
}  // namespace obrys::check
