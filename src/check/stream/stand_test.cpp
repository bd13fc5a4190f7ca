/// Rotary axes in the check: the same cut told in both ways, the machine's travel through its chain, and what is not
/// known said.

#include <gtest/gtest.h>

#include <cmath>

#include "base/codes.hpp"
#include "check/result_testing.hpp"
#include "check/stream/check.hpp"

namespace obrys::check {

namespace {

using geom::Vec3;
using testing::says;

shop::MachineAxis axis(const char* name, Vec3 direction, bool rotary = false, Vec3 centre = {}) {
    shop::MachineAxis a;
    a.name = name;
    a.direction = direction;
    a.rotary = rotary;
    a.centre = centre;
    return a;
}

constexpr Vec3 pivot{-200, -150, -400};  ///< of both rotary axes, machine coordinates
constexpr Vec3 zero{-230, -170, -360};   ///< of the workpiece
constexpr double length = 80;            ///< of the tool

/// C in A, as on a swivelling rotary table; no limits.
shop::Machine table() {
    shop::Machine m;
    m.kind = shop::MachineKind::mill;
    m.axes = {axis("X", {1, 0, 0}), axis("Y", {0, 1, 0}), axis("Z", {0, 0, 1}), axis("A", {1, 0, 0}, true, pivot),
              axis("C", {0, 0, 1}, true, pivot)};
    m.chain = {4, 3, 0, 1, 2};
    m.spindle.max = 10'000;
    return m;
}

Setup stand_setup(shop::Machine machine = table()) {
    Setup s;
    s.machine = std::move(machine);
    shop::Tool t;
    t.number = 1;
    t.kind = shop::ToolKind::end_mill;
    t.radius = 4;
    t.length = length;
    s.tools = {t};
    s.tools_given = true;
    s.milling.emplace();
    s.milling->stock = sim::milling::Box3{{0, 0, -20}, {60, 40, 0}};
    s.milling->tolerance = 0.02;
    s.milling->surface = true;
    return s;
}

struct StandScript {
    explicit StandScript(Setup s) : check(std::move(s), stacks) {
        take(cl::ToolChange{1, 1, ""});
        take(cl::Spindle{3000, cl::SpindleMode::rpm, 1, 0});
        take(cl::Feed{500, cl::FeedMode::per_minute});
    }
    StandScript& take(cl::Step step) {
        if (cl::AxisEnds* along = cl::ends_of(step)) *along = std::exchange(ends, {});
        check.take({std::move(step), {0, at, at + 1}, 0});
        ++at;
        return *this;
    }
    StandScript& turn(char name, double to, bool counted) { return turn({{name}, to, true, counted}); }
    /// With the next move.
    StandScript& turn(const cl::AxisEnd& axis) {
        ends.push_back(axis);
        return *this;
    }
    StandScript& go(Vec3 to, Vec3 tool = {0, 0, 1}, bool rapid = false) { return take(cl::Linear{to, tool, rapid}); }

    const cl::CallStacks stacks;
    Check check;
    std::uint32_t at = 0;
    cl::AxisEnds ends;  ///< of the next move
};

Vec3 turned(Vec3 v, char about, double degrees) {
    const double a = geom::radians(degrees), c = std::cos(a), s = std::sin(a);
    if (about == 'A') return {v.x, c * v.y - s * v.z, s * v.y + c * v.z};
    return {c * v.x - s * v.y, s * v.x + c * v.y, v.z};
}

/// Where a place on the workpiece is in the machine's directions while the table is swivelled: by hand, the table
/// turned back about the pivot.
Vec3 in_machine(Vec3 p, double a, double c) {
    const Vec3 from_pivot = zero + p - pivot;
    return pivot + turned(turned(from_pivot, 'C', -c), 'A', -a) - zero;
}

Vec3 tool_axis(double a, double c) { return turned(turned({0, 0, 1}, 'A', a), 'C', c); }

std::vector<std::string> unchecked(const Result& r) {
    std::vector<std::string> out;
    for (const Note& n : r.unchecked) out.push_back(n.text);
    return out;
}

}  // namespace

TEST(Stand, ACutIsTheSameToldOnTheWorkpieceAndInTheMachinesDirections) {
    constexpr double a = 25, c = 40;
    const Vec3 way[]{{30, 20, 30}, {30, 20, -4}, {50, 30, -6}, {20, 35, -3}};
    StandScript planned(stand_setup()), plain(stand_setup());
    for (StandScript* s : {&planned, &plain}) s->take(cl::Datum{54, zero});
    planned.turn('A', a, true).turn('C', c, true);
    plain.turn('A', a, false).turn('C', c, false);
    for (std::size_t i = 0; i < std::size(way); ++i) {
        planned.go(way[i], tool_axis(a, c), i == 0);
        plain.go(in_machine(way[i], a, c), {0, 0, 1}, i == 0);
    }
    const Result r = planned.check.finish(), q = plain.check.finish();
    ASSERT_NE(r.milled, nullptr);
    ASSERT_NE(q.milled, nullptr);
    const double cut = r.milled->figures.before_mm3 - r.milled->figures.after_mm3;
    EXPECT_GT(cut, 500);
    EXPECT_NEAR(q.milled->figures.before_mm3 - q.milled->figures.after_mm3, cut, 1e-6 * cut);
    // Whether a piece of the way just touches is a matter of rounding.
    EXPECT_NEAR(q.milled->figures.contact_length_mm, r.milled->figures.contact_length_mm,
                r.milled->figures.contact_accuracy_mm);
    ASSERT_EQ(r.milled->moves.size(), q.milled->moves.size());
    for (std::size_t i = 0; i < r.milled->moves.size(); ++i)
        EXPECT_NEAR(geom::distance(r.milled->moves[i].to, q.milled->moves[i].to), 0, 1e-9) << i;
    EXPECT_EQ(unchecked(r), unchecked(q));
}

/// Its corners are those of the machine's axes, wherever the table has turned the workpiece.
TEST(Stand, ABentRapidIsTheSameToldOnTheWorkpieceAndInTheMachinesDirections) {
    constexpr double a = 25, c = 40;
    const Vec3 from{-20, 20, 30}, to{80, 25, -6};
    const auto volume_of = [&](shop::RapidPath path, bool counted) {
        shop::Machine m = table();
        m.rapid_path = path;
        StandScript run(stand_setup(m));
        run.take(cl::Datum{54, zero}).turn('A', a, counted).turn('C', c, counted);
        for (const Vec3& p : {from, to})
            run.go(counted ? p : in_machine(p, a, c), counted ? tool_axis(a, c) : Vec3{0, 0, 1}, true);
        const Result r = run.check.finish();
        EXPECT_EQ(r.unchecked.size(), 1U) << "no part";
        return r.milled->figures.before_mm3 - r.milled->figures.after_mm3;
    };
    const double bent = volume_of(shop::RapidPath::dog_leg, true);
    EXPECT_NEAR(volume_of(shop::RapidPath::dog_leg, false), bent, 1e-6 * bent + 1e-9);
    const double straight = volume_of(shop::RapidPath::straight, true);
    EXPECT_GT(std::abs(bent - straight), 1);
}

TEST(Stand, TravelIsJudgedThroughTheChain) {
    // By hand: A 90 turns the workpiece so that its -y side looks up; the pivot is 30, 20, -40 from the zero.
    shop::Machine m = table();
    m.axes[1].min = -260;  // Y
    m.axes[1].max = 0;
    m.axes[2].min = -400;  // Z
    m.axes[2].max = 0;
    const Vec3 tool = tool_axis(90, 0);
    EXPECT_NEAR(tool.y, -1, 1e-12);
    // 0, 50, 0 of the workpiece lies at zero + (0, 50, 0) - pivot = (-30, 30, 40) of the pivot; turned back by 90 about
    // x:
    // (-30, 40, -30). Machine: y -110, z -430; the gauge point 80 above it: z -350, 50 above the limit's end.
    for (const double y : {50.0, 120.0}) {
        check::Setup s = stand_setup(m);
        StandScript run(s);
        run.take(cl::Datum{54, zero}).turn('A', 90, true).go({0, y, 0}, tool, true);
        const Result r = run.check.finish();
        std::vector<const Finding*> found;
        for (const Finding& f : r.findings)
            if (f.code == base::codes::axis_limit) found.push_back(&f);
        EXPECT_EQ(found.size(), y > 100 ? 1U : 0U) << y;
        // z of the tip: pivot z - (y - 20) = -400 - 100, gauge -420: 20 outside.
        for (const Finding* f : found) EXPECT_TRUE(f->text.starts_with("axis Z goes 20.000 mm outside its travel"));
    }
}

TEST(Stand, TheGaugePointIsWhatTheTravelIsOf) {
    shop::Machine m = table();
    m.axes[2].min = -400;
    m.axes[2].max = 0;
    StandScript run(stand_setup(m));
    // The tip 85 above the top of travel less the tool: 5 mm too high; without the tool's length it would be inside.
    run.take(cl::Datum{54, zero}).go({0, 0, 360 - length + 5}, {0, 0, 1}, true);
    const Result r = run.check.finish();
    ASSERT_EQ(r.findings.size(), 1U);
    EXPECT_TRUE(r.findings[0].text.starts_with("axis Z goes 5.000 mm outside its travel"));
}

TEST(Stand, WhatIsNotKnownIsSaid) {
    const Vec3 in{30, 20, -4}, over{30, 20, 30};
    {
        StandScript run(stand_setup());  // no zero
        run.turn('A', 25, false).go(over, {0, 0, 1}, true).go(in);
        const Result r = run.check.finish();
        EXPECT_EQ(r.verdict, Verdict::not_fully_checked);
        EXPECT_TRUE(says(r, "depends on the zero offset, which is not known")) << unchecked(r)[0];
        EXPECT_EQ(r.milled->figures.before_mm3, r.milled->figures.after_mm3);
    }
    {
        check::Setup s = stand_setup();
        s.tools[0].length = 0;
        StandScript run(s);
        run.take(cl::Datum{54, zero}).turn('A', 25, false).go(over, {0, 0, 1}, true).go(in);
        EXPECT_TRUE(says(run.check.finish(), "the tool's length, which is not known"));
    }
    {
        StandScript run(stand_setup());
        run.take(cl::Datum{54, zero}).go(over, {0, 0, 1}, true).turn('B', 10, false).go(in);
        EXPECT_TRUE(says(run.check.finish(), "the rotary axis B turns workpiece or tool"));
    }
    {
        StandScript run(stand_setup());  // the plane asks for A 25, the axis stands at 0
        run.take(cl::Datum{54, zero}).go(over, tool_axis(25, 0), true).go(in, tool_axis(25, 0));
        EXPECT_TRUE(says(run.check.finish(), "do not stand as the tilted plane asks"));
    }
    {
        StandScript run(stand_setup());
        run.take(cl::Datum{54, zero}).go(over, {0, 0, 1}, true).turn('C', 90, false).go(in);
        EXPECT_TRUE(says(run.check.finish(), "rotary axes turn on the way"));
    }
    {
        StandScript run(stand_setup());  // back at 0: as if it had never turned
        run.take(cl::Datum{54, zero}).turn('B', 10, false).turn('B', 0, false).go(over, {0, 0, 1}, true).go(in);
        const Result r = run.check.finish();
        EXPECT_EQ(r.unchecked.size(), 1U) << "no part";
        EXPECT_GT(r.milled->figures.before_mm3 - r.milled->figures.after_mm3, 100);
    }
}

TEST(Stand, WithoutOffsetsTheGaugePointGoesWhereTheProgramSays) {
    StandScript with(stand_setup()), without(stand_setup());
    for (StandScript* s : {&with, &without}) s->take(cl::Datum{54, zero});
    without.take(cl::ToolChange{1, 0, ""});
    const Vec3 way[]{{30, 20, 30}, {30, 20, -4}, {50, 20, -4}};
    for (std::size_t i = 0; i < std::size(way); ++i) {
        with.go(way[i], {0, 0, 1}, i == 0);
        without.go(way[i] + Vec3{0, 0, length}, {0, 0, 1}, i == 0);
    }
    const Result r = with.check.finish(), q = without.check.finish();
    EXPECT_GT(r.milled->figures.before_mm3 - r.milled->figures.after_mm3, 300);
    EXPECT_EQ(r.milled->figures.after_mm3, q.milled->figures.after_mm3);
}

TEST(Stand, ARapidSwingIsFollowed) {
    // The stock's corners pass where the tool stands: 36 mm from the pivot line, corners up to 36.1 mm from it; beside
    // the stock before and after the turn.
    for (const bool low : {true, false}) {
        StandScript run(stand_setup());
        run.take(cl::Datum{54, zero});
        const Vec3 at{30, 20 + 28, low ? -10.0 : 30.0};  // the workpiece's y ends at 40, the tool's radius is 4
        run.turn('A', 0, false).turn('C', 0, false).go(at + Vec3{0, 0, 50}, {0, 0, 1}, true).go(at, {0, 0, 1}, true);
        run.turn('C', 180, false).go(at, {0, 0, 1}, true);
        const Result r = run.check.finish();
        std::size_t met = 0;
        for (const Finding& f : r.findings) met += f.code == base::codes::rapid_in_stock ? 1 : 0;
        EXPECT_EQ(met, low ? 1U : 0U) << (r.unchecked.empty() ? "" : r.unchecked[0].text);
        EXPECT_EQ(r.unchecked.size(), 1U) << "no part";
    }
}

TEST(Stand, ATurnThatIsNotKnownAnArcInAPlaneAndAParallelAxisAreNotCalledClean) {
    const Vec3 over{30, 20, 30};
    {
        StandScript run(stand_setup());  // no zero
        run.go(over, {0, 0, 1}, true).turn('C', 90, true).go(over, {0, 0, 1}, true);
        EXPECT_TRUE(says(run.check.finish(), "rotary axes turn on the way"));
    }
    {
        StandScript run(stand_setup());  // the plane is told on the spot, then only an arc runs in it
        run.take(cl::Datum{54, zero}).go(over, {0, 0, 1}, true).go(over, tool_axis(25, 0), true);
        run.take(cl::Arc{{30, 30, 30}, {30, 25, 30}, tool_axis(25, 0), geom::pi, false, tool_axis(25, 0)});
        EXPECT_TRUE(says(run.check.finish(), "do not stand as the tilted plane asks"));
    }
    {
        StandScript run(stand_setup());
        run.take(cl::Datum{54, zero}).go(over, {0, 0, 1}, true).turn({{'W'}}).go({30, 20, -2});
        EXPECT_TRUE(says(run.check.finish(), "the axis W moves tool or workpiece, too"));
    }
    {
        StandScript run(stand_setup());  // gauge point where the program says, and no length
        check::Setup s = stand_setup();
        s.tools[0].length = 0;
        StandScript unknown(s);
        unknown.take(cl::ToolChange{1, 0, ""}).take(cl::Datum{54, zero}).go(over, {0, 0, 1}, true).go({30, 20, -2});
        EXPECT_TRUE(says(unknown.check.finish(), "no offset is selected and the tool's length is not known"));
    }
}

}  // namespace obrys::check
