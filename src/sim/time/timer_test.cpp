/// The stream's seconds: each has one cause, and they add up.

#include "sim/time/timer.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "geom/random_cases_testing.hpp"

namespace obrys::sim::time {
namespace {

using geom::testing::Random;

Dynamics dynamics() {
    shop::Machine machine;
    machine.motion.acceleration = 1000, machine.motion.jerk = 20'000, machine.motion.tolerance = 0.01;
    machine.motion.block_time = 0, machine.motion.look_ahead = 0, machine.motion.spindle_time = 0.5;
    machine.motion.corner = shop::CornerPassing::filter;
    machine.motion.servo_gain = 0, machine.motion.strobe_time = 0;
    machine.tool_change_time = 4;
    for (const char* name : {"X", "Y", "Z"}) {
        shop::MachineAxis axis;
        axis.name = name;
        axis.rapid = 6000;
        machine.axes.push_back(axis);
    }
    shop::MachineAxis table;
    table.name = "C";
    table.rotary = true;
    table.rapid = 3600;
    machine.axes.push_back(table);
    return dynamics_of(machine);
}

cl::Record rec(cl::Step step, std::uint32_t line = 0) { return {std::move(step), {0, line, line + 1}, 0}; }
cl::Linear line_to(geom::Vec3 to) { return {to}; }
cl::Linear rapid_to(geom::Vec3 to) { return {to, {0, 0, 1}, true}; }
double of(const Times& t, Cause c) { return t.all[static_cast<std::size_t>(c)]; }

Times timed(const std::vector<cl::Record>& records, const Dynamics& d) {
    Timer timer({}, d);
    for (const cl::Record& r : records) timer.take(r);
    return timer.finish();
}
/// Behind a start at zero.
Times timed(std::vector<cl::Step> steps, const Dynamics& d = dynamics()) {
    std::vector<cl::Record> records{rec(rapid_to({0, 0, 0}))};
    for (cl::Step& s : steps) records.push_back(rec(std::move(s), static_cast<std::uint32_t>(records.size())));
    return timed(records, d);
}

TEST(Timed, a_line_takes_its_way_by_the_feed_and_its_ramps) {
    const Times t = timed({cl::Feed{6000}, line_to({100, 0, 0})});
    EXPECT_NEAR(sum(t.all), plan_span(100, {}, {}, 100, {1000, 20'000})->seconds, 1e-9);
    EXPECT_NEAR(of(t, Cause::feed), 1, 1e-9);
    EXPECT_NEAR(of(t, Cause::exact_stop), 0.15, 1e-9);  // 2 ramps of 0.15 s in which it goes half as fast
    EXPECT_EQ(t.from_nowhere, 1U);                      // it is not known where the start was come from
}

TEST(Timed, a_corner_costs_what_its_tolerance_asks_for) {
    const std::vector<cl::Step> path{cl::Feed{6000}, line_to({50, 0, 0}), line_to({50, 50, 0})};
    const Times t = timed(path);
    const double corner = filtered_corner(geom::pi / 2, 0.01, 100, {1000, 20'000}).speed;
    EXPECT_NEAR(sum(t.all), 2 * plan_span(50, {}, {corner, 0}, 100, {1000, 20'000})->seconds, 1e-9);
    EXPECT_GT(of(t, Cause::corner), 0.1);
    cl::Tolerance wide;
    wide.contour = 0.1;
    std::vector<cl::Step> wider = path;
    wider.insert(wider.begin(), wide);
    EXPECT_LT(sum(timed(wider).all), sum(t.all));
    std::vector<cl::Step> exact = path;
    exact.insert(exact.begin(), cl::PathMode{cl::PathKind::exact_stop});
    EXPECT_GT(sum(timed(exact).all), sum(t.all));
    EXPECT_EQ(of(timed(exact), Cause::corner), 0);
}

TEST(Timed, short_lines_along_a_curve_are_no_corners) {
    constexpr double radius = 5;
    const std::vector<cl::Step> there{rapid_to({radius, 0, 0}), cl::Feed{6000}};
    std::vector<cl::Step> steps = there;
    for (int i = 1; i <= 360; ++i) {
        const double a = geom::radians(static_cast<double>(i));
        steps.emplace_back(line_to({radius * std::cos(a), radius * std::sin(a), 0}));
    }
    const Times t = timed(steps);
    EXPECT_GT(of(t, Cause::curvature), 0.05);
    EXPECT_EQ(of(t, Cause::corner), 0);
    const double speed = curve_speed(1 / radius, 100, {1000, 20'000}).speed;
    const double round = plan_span(2 * geom::pi * radius, {}, {}, speed, {1000, 20'000})->seconds;
    EXPECT_NEAR(sum(t.all) - sum(timed(there).all), round, 0.01 * round);
}

TEST(Timed, dwells_spindles_and_tools_take_their_time) {
    cl::ToolChange change;
    change.number = 3;
    const Times t = timed({change, cl::Spindle{4000, cl::SpindleMode::rpm, 1}, cl::Dwell{2.5}, cl::Spindle{}});
    EXPECT_NEAR(of(t, Cause::tool_change), 4, 1e-12);
    EXPECT_NEAR(of(t, Cause::spindle), 4, 1e-12);
    EXPECT_NEAR(of(t, Cause::dwell), 2.5, 1e-12);
    EXPECT_NEAR(sum(t.tools.at(3)), 10.5, 1e-12);
}

TEST(Timed, what_nobody_knows_is_in_no_sum) {
    const Times t = timed({line_to({10, 0, 0}), cl::Dwell{0, 3}});
    EXPECT_EQ(sum(t.all), 0);
    EXPECT_EQ(t.untimed, 1U);
    EXPECT_EQ(t.from_nowhere, 1U);
    EXPECT_EQ(t.untimed_dwells, 1U);
}

TEST(Timed, a_rotary_axis_holds_the_path_up_and_moves_alone) {
    cl::AxisEnd half_turn{{'C'}, 180, true, false};
    cl::AxisEnd level = half_turn;
    level.to = 0;
    cl::Linear first = rapid_to({0, 0, 0});
    first.ends = {level};
    cl::Linear together = line_to({1, 0, 0});
    together.ends = {half_turn};
    const Times t = timed({first, cl::Feed{6000}, together});
    EXPECT_GT(of(t, Cause::axis_speed), 2.9);  // 180 degrees at 60 degrees/s
    cl::Linear alone = rapid_to({0, 0, 0});
    alone.ends = {half_turn};
    EXPECT_GT(of(timed({first, alone}), Cause::rapid), 3);
    EXPECT_EQ(timed({alone}).from_nowhere, 2U);  // where the axis stood nobody knows
    EXPECT_EQ(timed({cl::Feed{6000}, together}).untimed, 1U);
}

TEST(Timed, axes_that_the_machine_does_not_have_or_that_go_nobody_knows_where_are_not_timed) {
    for (const cl::AxisEnd& end : {cl::AxisEnd{{'B'}, 30, true, false}, cl::AxisEnd{{'C'}, NAN, true, false}}) {
        cl::AxisEnd level = end;
        level.to = 0;
        cl::Linear first = rapid_to({0, 0, 0}), next = first;
        first.ends = {level};
        next.ends = {end};
        const Times t = timed({first, next});
        EXPECT_EQ(t.untimed, 1U);
        EXPECT_FALSE(t.is_understood());
    }
}

TEST(Timed, speeds_by_an_unknown_radius_and_stops_are_said_and_not_taken_as_nothing) {
    const cl::Spindle held{150, cl::SpindleMode::surface, 1};
    const std::vector<cl::Record> unknown{rec(held), rec(cl::Stop{cl::StopKind::program})};
    const Times t = timed(unknown, dynamics());
    EXPECT_EQ(t.untimed_speeds, 1U);
    EXPECT_EQ(t.stops, 1U);
    EXPECT_TRUE(t.is_understood());
    EXPECT_FALSE(t.is_whole());
    const Times there = timed({rapid_to({25, 0, 0}), held});
    EXPECT_NEAR(of(there, Cause::spindle), 150'000 / (50 * geom::pi) / 1000 * 0.5, 1e-9);
}

/// An arc is held to every axis that moves in its plane, and to no other.
TEST(Timed, arcs_go_as_fast_as_the_axes_of_their_plane) {
    Dynamics d = dynamics();
    d.axes[2].speed = 1;  // mm/s: Z is slow
    cl::Arc flat{{0, 0, 0}, {20, 0, 0}, {0, 0, 1}, 2 * geom::pi}, standing = flat;
    standing.normal = {0, 1, 0};
    const double free = sum(timed({cl::Feed{3000}, flat}, d).all), slow = sum(timed({cl::Feed{3000}, standing}, d).all);
    EXPECT_LT(free, 4);
    EXPECT_GT(slow, 100);
}

TEST(Timed, slow_blocks_and_short_sight_are_named) {
    std::vector<cl::Step> steps{cl::Feed{6000}};
    for (int i = 1; i <= 500; ++i) steps.emplace_back(line_to({0.1 * i, 0, 0}));
    Dynamics d = dynamics();
    d.block_time = 0.01;
    EXPECT_NEAR(sum(timed(steps, d).all), 5, 0.1);
    EXPECT_GT(of(timed(steps, d), Cause::block_rate), 4.4);
    Dynamics short_sighted = dynamics();
    short_sighted.look_ahead = 3;
    const Times t = timed(steps, short_sighted);
    EXPECT_GT(of(t, Cause::look_ahead), 1);
    EXPECT_GT(sum(t.all), 2 * sum(timed(steps).all));
}

TEST(Timed, causes_tools_and_places_add_up_to_the_same_for_any_path) {
    for (unsigned seed = 1; seed <= 60; ++seed) {
        Random random(seed);
        std::vector<cl::Step> steps{cl::Feed{random.between(100, 6000)}};
        geom::Vec3 at;
        const double reach = std::pow(10, random.between(-1, 1.5));
        for (int i = 0; i < 200; ++i) {
            at = at + geom::Vec3{random.between(-reach, reach), random.between(-reach, reach), random.between(-1, 1)};
            switch (random.below(12)) {
                case 0: steps.emplace_back(rapid_to(at)); break;
                case 1: steps.emplace_back(cl::Feed{random.between(50, 9000)}); break;
                case 2: steps.emplace_back(cl::Dwell{random.between(0, 1)}); break;
                default: steps.emplace_back(line_to(at));
            }
        }
        Dynamics d = dynamics();
        d.look_ahead = static_cast<std::size_t>(random.below(20));
        d.corner = static_cast<CornerMode>(random.below(3));
        const Times t = timed(steps, d);
        double tools = 0, places = 0;
        for (const auto& [number, spent] : t.tools) tools += sum(spent);
        for (const Spent& s : t.places) places += s.seconds;
        EXPECT_NEAR(tools, sum(t.all), 1e-9) << "seed " << seed;
        EXPECT_NEAR(places, sum(t.all), 1e-9) << "seed " << seed;
        for (const double part : t.all) EXPECT_GE(part, -1e-9) << "seed " << seed;
    }
}

/// A path that is planned in pieces takes as long as the whole of it at once.
TEST(Timed, long_paths_are_planned_in_pieces) {
    std::vector<cl::Step> steps{cl::Feed{3000}};
    std::vector<Block> blocks;
    const Limits limits{1000, 20'000};
    Random random(1);
    double x = 0;
    for (int i = 0; i < 60'000; ++i) {
        const double length = random.between(0.05, 0.4);
        x += length;
        steps.emplace_back(line_to({x, 0, 0}));
        blocks.push_back({length, 50, limits, 50});
    }
    EXPECT_NEAR(sum(timed(steps).all), plan(blocks, 0, 0).seconds(), 1e-6);
}

}  // namespace
}  // namespace obrys::sim::time
