/// Curves as straight lines: none farther from its curve than was asked, and nothing else touched.

#include "motion/chords.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "cl/spline.hpp"
#include "motion/cursor.hpp"

namespace obrys::motion {

namespace {

cl::Arc half_circle(double radius) {
    cl::Arc arc;
    arc.centre = {radius, 0, 0}, arc.to = {2 * radius, 0, 8};
    arc.sweep = -geom::pi;  // a helix, above the line between its ends
    return arc;
}

std::vector<cl::Step> after(const std::vector<cl::Step>& steps, double tolerance, std::size_t& curves) {
    cl::Recording in, out;
    for (std::uint32_t i = 0; i < steps.size(); ++i) in.take({steps[i], {0, i, i + 1}, 0});
    curves = take_chords(
        in, tolerance, [](const cl::Record&) { return true; }, out);
    std::vector<cl::Step> all;
    cl::Recording::Playback playback(out);
    while (playback.step([&](const cl::Record& record) { all.push_back(record.step); })) {
    }
    return all;
}

cl::Linear to(geom::Vec3 place) { return {place, {0, 0, 1}, true, cl::Seek::nothing, {}}; }

}  // namespace

TEST(Chords, LieWithinTheToleranceOfAHelix) {
    for (const double tolerance : {0.5, 0.01, 0.001}) {
        constexpr double radius = 20;
        std::size_t curves = 0;
        const auto lines = after({to({0, 0, 0}), half_circle(radius)}, tolerance, curves);
        EXPECT_EQ(curves, 1U);
        geom::Vec3 at{0, 0, 0};
        double farthest = 0;
        for (std::size_t i = 1; i < lines.size(); ++i) {
            const auto& line = std::get<cl::Linear>(lines[i]);
            EXPECT_FALSE(line.rapid);
            for (double part = 0; part <= 1; part += 0.05) {
                const geom::Vec3 p = at + part * (line.to - at);
                farthest = std::max(farthest, std::abs(std::hypot(p.x - radius, p.y) - radius));
                EXPECT_NEAR(std::atan2(p.y, radius - p.x) / geom::pi * 8, p.z, tolerance);
                EXPECT_GE(p.y, -1e-9);
            }
            at = line.to;
        }
        EXPECT_LE(farthest, tolerance);
        EXPECT_GT(farthest, tolerance / 4) << "no more lines than it takes";
        EXPECT_EQ(at, half_circle(radius).to);
    }
}

TEST(Chords, WhatLinesCannotSayStaysACurve) {
    const auto kept = [](std::vector<cl::Step> before, const cl::Arc& arc) {
        before.insert(before.begin(), to({0, 0, 0}));
        before.emplace_back(arc);
        std::size_t curves = 0;
        return after(before, 0.01, curves).size() == before.size() && curves == 0;
    };
    EXPECT_FALSE(kept({cl::Feed{100}}, half_circle(5)));
    EXPECT_TRUE(kept({cl::Feed{100, cl::FeedMode::inverse_time}}, half_circle(5)));
    EXPECT_TRUE(kept({cl::PathMode{cl::PathKind::exact_stop}}, half_circle(5)));
    EXPECT_TRUE(kept({cl::CompensationBegin{}}, half_circle(5)));
    cl::Arc rapid = half_circle(5), turns = half_circle(5), along = half_circle(5), nowhere = half_circle(5);
    rapid.rapid = true, turns.axis = {0, 0.6, 0.8}, nowhere.to.x = NAN;
    along.ends.push_back({{'C'}, 90});
    for (const cl::Arc& arc : {rapid, turns, along, nowhere}) EXPECT_TRUE(kept({}, arc));
}

}  // namespace obrys::motion
