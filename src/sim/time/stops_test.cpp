/// Times that are not motion along the path: lag at exact stops, rapids that bend, spindles that start and stand with
/// an axis or follow a radius, M functions.

#include <gtest/gtest.h>

#include <cmath>

#include "sim/time/timer.hpp"

namespace obrys::sim::time::stops {
namespace {

Dynamics dynamics() {
    shop::Machine machine;
    machine.motion.acceleration = 1000, machine.motion.jerk = 40'000, machine.motion.tolerance = 0.01;
    machine.motion.spindle_time = 0.5, machine.motion.servo_gain = 0, machine.motion.strobe_time = 0.2;
    machine.motion.corner = shop::CornerPassing::filter;
    for (const char* name : {"X", "Y", "Z"}) {
        shop::MachineAxis axis;
        axis.name = name;
        axis.rapid = name[0] == 'Z' ? 6000 : 12'000;
        machine.axes.push_back(axis);
    }
    return dynamics_of(machine);
}

cl::Linear line_to(geom::Vec3 to) { return {to}; }
cl::Linear rapid_to(geom::Vec3 to) { return {to, {0, 0, 1}, true}; }
double of(const Times& t, Cause c) { return t.all[static_cast<std::size_t>(c)]; }

Times timed(const std::vector<cl::Step>& steps, const Dynamics& d, const geom::Vec3& begin = {0, 0, 0}) {
    Timer timer({}, d);
    timer.take({rapid_to(begin), {0, 0, 1}, 0});
    std::uint32_t at = 0;
    for (const cl::Step& s : steps) timer.take({s, {0, ++at, at + 1}, 0});
    return timer.finish();
}

TEST(Stops, an_axis_that_lags_takes_its_time_to_its_window) {
    // Shared spec physics.md (a) 6: 1 m/min/mm, 10 um: 0.226 s at F432, 0.138 s at F100.
    EXPECT_NEAR(settling_time(432.0 / 60, 1000.0 / 60, 0.01), 0.226, 5e-4);
    EXPECT_NEAR(settling_time(100.0 / 60, 1000.0 / 60, 0.01), 0.138, 5e-4);
    EXPECT_EQ(settling_time(1e-6, 1000.0 / 60, 0.01), 0);
    const std::vector<cl::Step> path{cl::Feed{432}, line_to({20, 0, 0}), line_to({20, 20, 0}), line_to({0, 20, 0})};
    Dynamics d = dynamics();
    d.corner = CornerMode::exact_stop;
    const Times stiff = timed(path, d);
    d.servo_gain = 1000.0 / 60, d.window = 0.01;
    const Times soft = timed(path, d);
    EXPECT_NEAR(sum(soft.all) - sum(stiff.all), 3 * settling_time(432.0 / 60, d.servo_gain, 0.01), 1e-9);
    EXPECT_NEAR(of(soft, Cause::exact_stop) - of(stiff, Cause::exact_stop), sum(soft.all) - sum(stiff.all), 1e-9);
    EXPECT_NEAR(stiff.may_settle, sum(soft.all) - sum(stiff.all), 1e-9);
}

TEST(Stops, exact_stops_end_where_the_program_asks_for_a_tolerance) {
    std::vector<cl::Step> path{cl::Feed{3000}};
    for (int i = 1; i <= 200; ++i) {
        const double t = i * 0.01;  // short lines of a circle: chord error 0.0006 mm
        path.emplace_back(line_to({50 * std::sin(t), 50 - 50 * std::cos(t), 0}));
    }
    Dynamics d = dynamics();
    const double filtered = sum(timed(path, d).all);
    d.corner = CornerMode::exact_stop;
    const double stopped = sum(timed(path, d).all);
    EXPECT_GT(stopped, 3 * filtered);
    path.insert(path.begin(), cl::Tolerance{0.01});
    EXPECT_NEAR(sum(timed(path, d).all), filtered, 1e-9);
}

TEST(Stops, each_axis_of_a_bent_rapid_takes_its_own_curve) {
    Dynamics d = dynamics();
    const std::vector<cl::Step> path{rapid_to({300, 40, 100})};
    const double straight = sum(timed(path, d).all);
    d.dog_leg = true;
    const double bent = sum(timed(path, d).all);
    const auto x = plan_span(300, {}, {}, 200, {1000, 40'000}), z = plan_span(100, {}, {}, 100, {1000, 40'000});
    EXPECT_NEAR(bent, std::max(x->seconds, z->seconds), 1e-9);
    EXPECT_LT(bent, straight);
}

TEST(Stops, a_rigid_tap_reverses_with_its_spindle) {
    const double pitch = 1.5, speed = 1200;
    std::vector<cl::Step> path{cl::Spindle{speed, cl::SpindleMode::rpm, 1}};
    cl::Thread in;
    in.to = {0, 0, -30}, in.pitch = pitch, in.rigid_tap = true;
    cl::Thread out = in;
    out.to = {0, 0, 0};
    path.emplace_back(in);
    path.emplace_back(out);
    const Times t = timed(path, dynamics());
    // Both ways from rest to rest, as quick as the spindle gets faster: 0.5 s for 1000 1/min.
    const double v = pitch * speed / 60, a = pitch * 1000 / 60 / 0.5;
    const auto one = plan_span(30, {}, {}, v, {a, 40'000});
    EXPECT_NEAR(sum(t.all), 2 * one->seconds + 0.6, 1e-9);
    EXPECT_NEAR(of(t, Cause::feed), 2 * 30 / v, 1e-9);
    EXPECT_NEAR(of(t, Cause::spindle), sum(t.all) - of(t, Cause::feed), 1e-9);
}

TEST(Stops, a_cut_waits_for_the_spindle_of_a_held_cutting_speed) {
    const cl::Spindle held{180, cl::SpindleMode::surface, 1, 3000};
    const auto at = [](double radius) { return 180'000 / (2 * geom::pi * radius); };
    std::vector<cl::Step> path{held, cl::Feed{100}, line_to({50, 0, -1}), rapid_to({20, 0, -1}), line_to({20, 0, -2})};
    const Times t = timed(path, dynamics(), {50, 0, 0});
    const auto rapid = plan_span(30, {}, {}, 200, {1000, 40'000});
    const double change = (at(20) - at(50)) / 1000 * 0.5;
    ASSERT_GT(change, rapid->seconds);
    EXPECT_NEAR(of(t, Cause::spindle), at(50) / 1000 * 0.5 + change - rapid->seconds, 1e-6);
}

TEST(Stops, m_functions_of_a_block_are_strobed_once) {
    Timer timer({}, dynamics());
    timer.take({cl::Coolant{true, false}, {0, 5, 6}, 0});
    timer.take({cl::Auxiliary{'M', 88}, {0, 5, 6}, 0});
    timer.take({cl::Auxiliary{'M', 89}, {0, 9, 10}, 0});
    EXPECT_NEAR(of(timer.finish(), Cause::m_function), 0.4, 1e-12);
}

TEST(Stops, probing_moves_are_counted_and_end_in_a_stop) {
    cl::Linear probe = line_to({10, 0, 0});
    probe.seek = cl::Seek::contact;
    const Times t = timed({cl::Feed{600}, line_to({5, 0, 0}), probe, line_to({20, 0, 0})}, dynamics());
    EXPECT_EQ(t.probings, 1U);
    const auto s = [](double way) { return plan_span(way, {}, {}, 10, {1000, 40'000})->seconds; };
    EXPECT_NEAR(sum(t.all), s(5) + s(5) + s(10), 1e-9);
}

}  // namespace
}  // namespace obrys::sim::time::stops
