/// What another program worked out in closed form, by linear programs and by convolution
/// (../shared/spec/oracle/physics): moves from rest to rest, corners, arcs, a path of 1000 lines.

#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "base/oracle_testing.hpp"
#include "geom/vec.hpp"
#include "sim/time/corner.hpp"
#include "sim/time/profile.hpp"

namespace obrys::sim::time {
namespace {

using nlohmann::json;

constexpr double without_end = 1e18;  ///< mm/s3: acceleration alone counts

std::optional<json> oracle(const std::string& name) { return base::testing::oracle("physics/" + name); }
#define ORACLE(name, file)                         \
    const std::optional<json> name = oracle(file); \
    if (!name) GTEST_SKIP() << "needs ../shared/spec/oracle/physics/" << file

Limits limits_of(const json& c) { return {c.at("a"), c.value("j", without_end)}; }

void expect_near(double value, double expected, double relative, const json& c) {
    EXPECT_NEAR(value, expected, relative * std::abs(expected)) << c.dump();
}

TEST(TimeOracle, moves_from_rest_to_rest_and_between_speeds) {
    ORACLE(moves, "moves.json");
    for (const json& c : moves->at("rest_to_rest")) {
        const auto span = plan_span(c.at("L"), {}, {}, c.at("v"), limits_of(c));
        ASSERT_TRUE(span) << c.dump();
        expect_near(span->seconds, c.at("T"), 1e-9, c);
        expect_near(span->peak, c.at("vp"), 1e-9, c);
    }
    for (const json& c : moves->at("ramps")) {
        expect_near(ramp_seconds(c.at("v0"), c.at("v1"), limits_of(c)), c.at("t"), 1e-9, c);
        expect_near(ramp_length(c.at("v0"), c.at("v1"), limits_of(c)), c.at("s"), 1e-9, c);
    }
    for (const json& c : moves->at("spans")) {
        const auto span = plan_span(c.at("L"), {c.at("v0"), 0}, {c.at("v1"), 0}, c.at("vmax"), limits_of(c));
        ASSERT_TRUE(span) << c.dump();
        expect_near(span->seconds, c.at("T"), 1e-9, c);
        expect_near(span->peak, c.at("v_peak"), 1e-9, c);
    }
    for (const json& c : moves->at("reachable"))
        expect_near(reachable(c.at("v0"), c.at("L"), {1000, 20000}), c.at("v1"), 1e-9, c);
}

TEST(TimeOracle, corners) {
    ORACLE(corners, "corners.json");
    for (const json& c : corners->at("corner_speed")) {
        const double turn = geom::radians(c.at("turn_deg").get<double>()), tolerance = c.at("tol");
        const CornerSpeed filtered = filtered_corner(turn, tolerance, c.at("F"), limits_of(c));
        expect_near(filtered.speed, c.at("v_corner"), 1e-9, c);
        EXPECT_EQ(filtered.by == CornerLimit::none, c.at("limited_by") == "feed") << c.dump();
        EXPECT_EQ(filtered.by == CornerLimit::jerk, c.at("limited_by") == "corner-jerk") << c.dump();
        const Limits acceleration{c.at("a"), without_end};
        expect_near(filtered_corner(turn, tolerance, c.at("F"), acceleration).speed, c.at("v_acc_only_triangle"), 1e-9,
                    c);
    }
    for (const json& c : corners->at("two_segments")) {
        const double v = c.at("v_corner"), f = c.at("F");
        const auto seconds = [&](const Limits& l, double corner) {
            const std::array<Block, 2> blocks{{{c.at("L1"), f, l, corner}, {c.at("L2"), f, l, 0}}};
            return plan(blocks, 0, 0).seconds();
        };
        expect_near(seconds(limits_of(c), v), c.at("T_jerk"), 1e-9, c);
        expect_near(seconds(limits_of(c), 0), c.at("T_exact_stop_jerk"), 1e-9, c);
        const Limits acceleration{c.at("a"), without_end};
        const double turn = geom::radians(c.at("turn_deg").get<double>());
        expect_near(seconds(acceleration, filtered_corner(turn, c.at("tol"), f, acceleration).speed), c.at("T_acc"),
                    1e-8, c);
    }
}

TEST(TimeOracle, arcs_between_lines) {
    ORACLE(arcs, "arcs.json");
    for (const json& c : arcs->at("cases")) {
        const double radius = c.at("R"), lead = c.at("lead_in_out"), f = c.at("F");
        const double length = radius * geom::radians(c.at("sweep_deg").get<double>());
        const auto seconds = [&](const Limits& l) {
            const double v = curve_speed(1 / radius, f, l).speed;
            const std::array<Block, 3> blocks{{{lead, f, l, f}, {length, v, l, v}, {lead, f, l, 0}}};
            return plan(blocks, 0, 0).seconds();
        };
        expect_near(curve_speed(1 / radius, f, limits_of(c)).speed, c.at("v_arc"), 1e-9, c);
        expect_near(seconds(limits_of(c)), c.at("T_total_jerk"), 1e-9, c);
        expect_near(seconds({c.at("a"), without_end}), c.at("T_total_acc"), 1e-8, c);
    }
}

/// Its definition stands in the file: 1000 lines between points of a curve.
std::vector<Block> polyline(const json& c, bool with_jerk) {
    constexpr int n = 1000;
    std::vector<geom::Vec3> points;
    for (int i = 0; i <= n; ++i) {
        const double t = 2 * geom::pi * i / n;
        points.push_back(
            {40 * std::cos(t) + 6 * std::cos(7 * t), 25 * std::sin(2 * t) + 5 * std::sin(9 * t), 3 * std::sin(5 * t)});
    }
    const Limits limits{c.at("a"), with_jerk ? c.at("j").get<double>() : without_end};
    std::vector<Block> blocks;
    for (std::size_t i = 0; i < n; ++i) {
        const geom::Vec3 way = points[i + 1] - points[i];
        Block block{length(way), c.at("F"), limits, c.at("F")};
        if (i + 1 < n) {
            const geom::Vec3 next = points[i + 2] - points[i + 1];
            const double turn = std::atan2(length(cross(way, next)), dot(way, next));
            block.end_speed = filtered_corner(turn, c.at("tol"), c.at("F"), limits).speed;
        }
        blocks.push_back(block);
    }
    return blocks;
}

TEST(TimeOracle, a_thousand_lines_by_acceleration_with_any_look_ahead) {
    ORACLE(lines, "polyline1000.json");
    for (const json& c : lines->at("cases")) {
        const std::vector<Block> blocks = polyline(c, false);
        expect_near(plan(blocks, 0, 0).seconds(), c.at("T_lookahead_acc"), 1e-9, c.at("F"));
        for (const auto& [depth, seconds] : c.at("T_by_lookahead_depth").items()) {
            std::vector<Block> known = blocks;
            limit_to_known(known, std::stoul(depth), [](std::size_t) {});
            expect_near(plan(known, 0, 0).seconds(), seconds, 1e-9, depth);
        }
    }
}

TEST(TimeOracle, a_thousand_lines_by_jerk_are_near_the_best_there_is) {
    ORACLE(lines, "polyline1000.json");
    for (const json& c : lines->at("cases")) {
        const std::vector<Block> blocks = polyline(c, true);
        const json& moving = c.at("moving_ends");
        const double best = moving.at("T_SLP_reference");
        const double seconds = plan(blocks, moving.at("v_end"), moving.at("v_end")).seconds();
        EXPECT_GE(seconds, best * 0.995) << c.at("F");
        EXPECT_LE(seconds, best * 1.03) << c.at("F");
        EXPECT_LE(plan(blocks, 0, 0).seconds(), c.at("T_jerk_span_planner_rest_to_rest").get<double>() * (1 + 1e-6));
        std::vector<Block> stopped = blocks;
        for (Block& b : stopped) b.end_speed = 0;
        expect_near(plan(stopped, 0, 0).seconds(), c.at("T_exact_stop_every_block_jerk"), 1e-6, c.at("F"));
    }
}

}  // namespace
}  // namespace obrys::sim::time
