#include "geom/interpolation.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include <vector>

namespace obrys::geom {
namespace {

const double half_diagonal = std::sqrt(0.5);

double any_number(int thousandths) { return *rc::gen::inRange(-thousandths, thousandths) / 1000.0; }
Vec3 any_vec(int thousandths) {
    const double x = any_number(thousandths), y = any_number(thousandths), z = any_number(thousandths);
    return {x, y, z};
}

PathElement any_element(std::size_t kind) {
    if (kind == 0) return Straight{any_vec(3000), any_vec(3000)};
    if (kind == 1) return Cubic{any_vec(1000), any_vec(2000), any_vec(2000), any_vec(2000)};
    Vec3 normal = any_vec(1000);
    if (length(normal) < 1e-3) normal = {0, 0, 1};
    normal = (1 / length(normal)) * normal;
    const Vec3 centre = any_vec(1000), from = any_vec(1500);
    const double sweep = any_number(15'000);
    const Vec3 spoke = from - centre, radius = spoke - dot(spoke, normal) * normal;
    const Vec3 end = from - radius + std::cos(sweep) * radius + std::sin(sweep) * cross(normal, radius);
    return Circular{from, end + any_number(500) * normal + any_vec(2), centre, normal, sweep};
}

/// Distance of a point from the element by many points and chords, near a parameter.
double distance_by_samples(const PathElement& e, Vec3 q, double u) {
    double best = INFINITY;
    Vec3 last{};
    const double low = std::max(0.0, u - 0.1), high = std::min(1.0, u + 0.1);
    constexpr int count = 1000;
    for (int i = 0; i <= count; ++i) {
        const Vec3 p = point_at(e, low + (high - low) * i / count);
        if (i > 0) {
            const Vec3 d = p - last;
            const double along = dot(d, d) > 0 ? std::min(1.0, std::max(0.0, dot(q - last, d) / dot(d, d))) : 0;
            best = std::min(best, distance(q, last + along * d));
        }
        last = p;
    }
    return best;
}

Vec3 on_grid(Vec3 p, double unit) {
    const auto whole = [unit](double v) { return std::floor(v / unit + 0.5) * unit; };
    return {whole(p.x), whole(p.y), whole(p.z)};
}

TEST(Staircase, StepsOfALineByHand) {
    std::vector<std::pair<int, double>> made;
    const Staircase r = staircase(Straight{{0, 0, 7}, {5, -2, 7}}, 1, [&made](const GridStep& s) {
        made.emplace_back(s.axis, std::round(s.u * 1e4) / 1e4);
        EXPECT_EQ(s.direction, s.axis == 0 ? 1 : -1);
    });
    const std::vector<std::pair<int, double>> expected{{0, 0.1}, {1, 0.25}, {0, 0.3}, {0, 0.5},
                                                       {0, 0.7}, {1, 0.75}, {0, 0.9}};
    EXPECT_EQ(made, expected);
    EXPECT_EQ(r.end, (Vec3{5, -2, 7}));
    EXPECT_EQ(r.steps, 7u);
    EXPECT_EQ(r.steps_of_axis, (std::array<std::uint64_t, 3>{5, 2, 0}));
    // (1, 0), (1, -1), (2, -1), (3, -1), (4, -1), (4, -2), (5, -2) and the start, off the line 2 x + 5 y = 0.
    EXPECT_NEAR(r.largest, 3 / std::sqrt(29), 1e-12);
    EXPECT_NEAR(r.mean, (2 + 3 + 1 + 1 + 3 + 2) / std::sqrt(29) / 8, 1e-12);
}

TEST(Staircase, LinesAlongAnAxisAreExactAndDiagonalOnesWorst) {
    const Staircase along = staircase(Straight{{0, 3, 0}, {100, 3, 0}}, 0.01);
    EXPECT_EQ(along.steps, 10'000u);
    EXPECT_LE(along.largest, 1e-12);
    EXPECT_NEAR(staircase(Straight{{0, 3.003, 0}, {100, 3.003, 0}}, 0.01).largest, 0.003, 1e-9);  // beside the grid
    const Staircase diagonal = staircase(Straight{{0, 0, 0}, {1, 1, 0}}, 0.1);
    EXPECT_EQ(diagonal.steps, 20u);
    EXPECT_NEAR(diagonal.largest, 0.1 * half_diagonal, 1e-9);
    EXPECT_NEAR(diagonal.mean, 10 * 0.1 * half_diagonal / 21, 1e-9);  // every second point lies on the line
    // Away from the origin, where the halves are no exact doubles, x goes first all the same.
    double side = 0;
    static_cast<void>(staircase(Straight{{43, 63, 0}, {50, 70, 0}}, 0.001,
                                [&side](const GridStep& s) { side = std::max(side, (s.at.y - 63) - (s.at.x - 43)); }));
    EXPECT_LE(side, 1e-9);
    const Staircase in_space = staircase(Straight{{0, 0, 0}, {1, 1, 1}}, 0.1);
    EXPECT_NEAR(in_space.largest, 0.1 * std::sqrt(2.0 / 3.0), 1e-9);  // after one axis, or two, of three
}

TEST(Staircase, SmallCirclesStayWithinTheBoundOfThePlane) {
    for (const double radius : {1.0, 2.0, 10.0, 10.3, 57.7, 1000.0}) {
        const Circular circle{{radius, 0, 0}, {radius, 0, 0}, {0, 0, 0}, {0, 0, 1}, 2 * pi};
        double worst = 0;
        const Staircase r = staircase(circle, 1, [&](const GridStep& s) {
            const double off = std::abs(std::hypot(s.at.x, s.at.y) - radius);
            EXPECT_NEAR(s.deviation, off, 1e-9);
            worst = std::max(worst, off);
        });
        EXPECT_EQ(r.end, r.start);
        EXPECT_NEAR(r.largest, std::max(worst, std::abs(r.start.x - radius)), 1e-9);
        EXPECT_LE(r.largest, half_diagonal + 5e-6);
        EXPECT_GE(r.largest, 0.3);
        EXPECT_EQ(r.steps_of_axis[0], 4 * static_cast<std::uint64_t>(std::floor(radius + 0.5)));
        EXPECT_EQ(r.steps_of_axis[1], r.steps_of_axis[0]);
    }
}

TEST(Staircase, AnArcWithoutSweepIsALine) {
    const Vec3 from{1, 2, 3}, to{4, -2, 3.5};
    const Staircase line = staircase(Straight{from, to}, 0.1);
    const Staircase arc = staircase(Circular{from, to, {0, 7, 0}, {0, 0, 1}, 0}, 0.1);
    EXPECT_EQ(line.steps, arc.steps);
    EXPECT_NEAR(line.largest, arc.largest, 1e-12);
}

TEST(Staircase, AParabolaThroughThreePointsIsLessThanAUnitOff) {
    const Staircase r = staircase(parabola({0, 0, 0}, {10, 8, 0}, {20, 3, 0}), 0.001);
    EXPECT_EQ(r.end_reason, StaircaseEnd::reached);
    EXPECT_LE(r.largest, 0.001 * half_diagonal + 5e-9);
    EXPECT_GT(r.largest, 0.0005);
    EXPECT_LE(distance(r.end, {20, 3, 0}), 1e-12);
}

RC_GTEST_PROP(Staircase, EndsOnTheGridWithinTheBound, ()) {
    const double unit = *rc::gen::element(0.01, 0.1, 0.037);
    for (std::size_t kind = 0; kind < 3; ++kind) {
        const PathElement e = any_element(kind);
        Vec3 at = on_grid(point_at(e, 0), unit);
        double u = 0, sum = 0, largest = 0;
        bool grid = true, ordered = true;
        std::uint64_t count = 0;
        const Staircase r = staircase(e, unit, [&](const GridStep& s) {
            grid = grid && std::abs(length(s.at - at) - unit) <= 1e-9 && distance(s.at, on_grid(s.at, unit)) <= 1e-9;
            ordered = ordered && s.u >= u && distance(s.at, s.ideal) <= s.deviation + 1e-12;
            at = s.at;
            u = s.u;
            ++count;
            largest = std::max(largest, s.deviation);
            sum += s.deviation;
        });
        RC_ASSERT(r.end_reason == StaircaseEnd::reached);
        RC_ASSERT(grid && ordered);
        RC_ASSERT(count == r.steps);
        RC_ASSERT(distance(r.start, on_grid(point_at(e, 0), unit)) <= 1e-12);
        RC_ASSERT(distance(r.end, on_grid(point_at(e, 1), unit)) <= 1e-12);
        RC_ASSERT(r.end == (count == 0 ? r.start : at));
        RC_ASSERT(r.largest <= unit * (std::sqrt(0.75) + 5e-6));
        RC_ASSERT(r.largest >= largest && r.mean <= r.largest + 1e-15);
        const double of_start = r.mean * static_cast<double>(count + 1) - sum;
        RC_ASSERT(of_start >= -1e-9 && of_start <= unit);
    }
}

RC_GTEST_PROP(Staircase, DeviationsAreThoseOfTheNearestPoint, ()) {
    constexpr double unit = 0.1;
    for (std::size_t kind = 0; kind < 3; ++kind) {
        const PathElement e = any_element(kind);
        double worst = 0;
        static_cast<void>(staircase(e, unit, [&](const GridStep& s) {
            // The samples reach 0.1 to either side; that must be more than the unit.
            if (length(derivative_at(e, s.u)) < 2) return;
            worst = std::max(worst, std::abs(s.deviation - distance_by_samples(e, s.at, s.u)));
        }));
        RC_ASSERT(worst <= 0.01 * unit);
    }
}

TEST(Staircase, BackwardsItVisitsAsManyPoints) {
    const Cubic c{{0.1, 0.2, 0}, {3, 1, 0}, {-4, 2, 0}, {5, -2.2, 0}};
    const Staircase there = staircase(c, 0.001), back = staircase(reversed(c), 0.001);
    EXPECT_EQ(there.steps, back.steps);
    EXPECT_NEAR(there.largest, back.largest, 2e-6);
    EXPECT_NEAR(there.mean, back.mean, 2e-6);
}

TEST(Staircase, WhatCannotBeRunIsSaid) {
    const Straight line{{0, 0, 0}, {10, 7, 0}};
    EXPECT_EQ(staircase(line, 0).end_reason, StaircaseEnd::not_known);
    EXPECT_EQ(staircase(line, -1).end_reason, StaircaseEnd::not_known);
    EXPECT_EQ(staircase(line, NAN).end_reason, StaircaseEnd::not_known);
    EXPECT_EQ(staircase(line, INFINITY).end_reason, StaircaseEnd::not_known);
    EXPECT_EQ(staircase(line, 1e-300).end_reason, StaircaseEnd::not_known);
    EXPECT_EQ(staircase(Straight{{0, NAN, 0}, {10, NAN, 0}}, 1).end_reason, StaircaseEnd::not_known);
    EXPECT_EQ(staircase(Cubic{{}, {INFINITY, 0, 0}, {}, {}}, 1).end_reason, StaircaseEnd::not_known);
    EXPECT_EQ(staircase(Circular{{1, 0, 0}, {1, 0, 0}, {}, {0, 0, 1}, 1e9}, 1).end_reason, StaircaseEnd::not_known);
    const Staircase cut = staircase(
        line, 0.01, [](const GridStep&) {}, 100);
    EXPECT_EQ(cut.end_reason, StaircaseEnd::too_long);
    EXPECT_EQ(cut.steps, 100u);
    const Staircase none = staircase(Straight{{1, 2, 3}, {1, 2, 3}}, 0.5);
    EXPECT_EQ(none.end_reason, StaircaseEnd::reached);
    EXPECT_EQ(none.steps, 0u);
    // A circle smaller than the unit, run many times: no axis ever steps.
    EXPECT_EQ(staircase(Circular{{1e-4, 0, 0}, {1e-4, 0, 0}, {}, {0, 0, 1}, 2e5 * pi}, 1).steps, 0u);
}

}  // namespace
}  // namespace obrys::geom
