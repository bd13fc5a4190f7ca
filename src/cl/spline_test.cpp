#include "cl/spline.hpp"

#include <gtest/gtest.h>

#include <fstream>
#include <nlohmann/json.hpp>

#include "cl/totals.hpp"

namespace obrys::cl {
namespace {

using nlohmann::json;

/// The two blocks of the example in the control's manual, chapter on spline interpolation.
const geom::Vec3 manual_start{28.338, 19.385, -0.5};
Spline block_8() {
    return {{24.875, 15.924, -0.5},    {3.486, 3.486, 0}, {2.459e-2, 2.155e-2, 0},
            {-4.688e-2, -4.563e-2, 0}, {0, 0, 1},         {}};
}
Spline block_9() {
    return {{17.952, 9.003, -0.5},   {6.928, 6.910, 0}, {-5.644e-2, -2.644e-2, 0},
            {5.159e-2, 3.753e-2, 0}, {0, 0, 1},         {}};
}

void expect_near(geom::Vec3 a, geom::Vec3 b, double tolerance) {
    EXPECT_NEAR(a.x, b.x, tolerance);
    EXPECT_NEAR(a.y, b.y, tolerance);
    EXPECT_NEAR(a.z, b.z, tolerance);
}

TEST(Spline, TheExampleOfTheManualAsComputedIndependently) {
    std::ifstream file(OBRYS_SOURCE_DIR "/../shared/programs/heidenhain/expected/spl_001.json");
    if (!file) GTEST_SKIP() << "needs ../shared";
    const json all = json::parse(file);
    geom::Vec3 before = manual_start;
    for (const auto& [block, s] : {std::pair{"8", block_8()}, std::pair{"9", block_9()}}) {
        const json& e = all.at(block);
        for (const json& p : e.at("t_points"))
            expect_near(geom::point_at(curve(s), p.at(0)), {p.at(1), p.at(2), -0.5}, 1e-6);
        expect_near(start_of(s), {e.at("t1").at(0), e.at("t1").at(1), -0.5}, 1e-6);
        expect_near(geom::derivative_at(curve(s), 1), {e.at("tangent_t1").at(0), e.at("tangent_t1").at(1), 0}, 1e-6);
        expect_near(geom::derivative_at(curve(s), 0), {e.at("tangent_t0").at(0), e.at("tangent_t0").at(1), 0}, 1e-6);
        EXPECT_NEAR(move_length(before, s), e.at("length"), 1e-6);
        EXPECT_NEAR(geom::length(start_gap(before, s)), e.at("gap_t1_to_start"), 1e-9);
        before = position_after(before, s);
        EXPECT_EQ(before, s.to);
    }
}

TEST(Spline, MovesFromTheStartToTheEnd) {
    const Spline s = block_8();
    expect_near(geom::point_at(forward(s), 0), start_of(s), 1e-14);
    EXPECT_EQ(geom::point_at(curve(s), 0), s.to);
    expect_near(geom::point_at(forward(s), 0.25), geom::point_at(curve(s), 0.75), 1e-14);
    // The program runs towards smaller x and y.
    expect_near(first_direction({}, s), {-std::sqrt(0.5), -std::sqrt(0.5), 0}, 1e-3);
    expect_near(last_direction({}, s), {-std::sqrt(0.5), -std::sqrt(0.5), 0}, 1e-12);
}

TEST(Spline, JoinsTellGapAndBreak) {
    const Joint j = join(block_8(), block_9());
    EXPECT_NEAR(j.gap.x, 24.87515 - 24.875, 1e-12);
    EXPECT_NEAR(j.gap.y, 15.92409 - 15.924, 1e-12);
    EXPECT_NEAR(j.distance, 0.00017492855685061768, 1e-12);
    EXPECT_NEAR(j.turn, std::atan2(6.96989, 6.96971) - geom::pi / 4, 1e-9);
    // A right angle after a straight move along x; the spline leaves along y, its speed at the start being 0.
    const Spline s{{10, 8, 0}, {0, -16, 0}, {0, 8, 0}, {}, {0, 0, 1}, {}};
    const Linear along_x{{10, 0, 0}, {0, 0, 1}, false};
    const Joint k = join({10, 0, 0}, last_direction({0, 0, 0}, along_x), s);
    EXPECT_EQ(k.distance, 0);
    EXPECT_NEAR(k.turn, geom::pi / 2, 1e-15);
}

TEST(Spline, WhatIsNotKnownStaysNotKnown) {
    Spline s = block_8();
    s.to.z = NAN;  // never programmed
    EXPECT_EQ(start_gap({28, 19, NAN}, s).z, 0);
    EXPECT_TRUE(std::isnan(start_gap({28, 19, 1}, s).z));
    EXPECT_TRUE(std::isnan(join({28, 19, 1}, {1, 0, 0}, s).distance));
    EXPECT_TRUE(std::isnan(join({28, 19, NAN}, {0, 0, 0}, s).turn));
    EXPECT_NEAR(move_length({NAN, NAN, NAN}, s), 4.897160128390714, 1e-9);
    s.k2.z = NAN;
    EXPECT_TRUE(std::isnan(move_length({0, 0, 0}, s)));
}

TEST(Spline, DirectionsOfOtherMoves) {
    const Arc quarter{{0, 10, 0}, {0, 0, 0}, {0, 0, 1}, geom::pi / 2};
    expect_near(first_direction({10, 0, 0}, quarter), {0, 1, 0}, 1e-15);
    expect_near(last_direction({10, 0, 0}, quarter), {-1, 0, 0}, 1e-15);
    const Arc back{{10, 0, 0}, {0, 0, 0}, {0, 0, 1}, -geom::pi / 2};
    expect_near(last_direction({0, 10, 0}, back), {0, -1, 0}, 1e-15);
    // A helix of radius 10 that rises 20 pi in a turn, its way along the circle.
    const Arc helix{{10, 0, 20 * geom::pi}, {0, 0, 0}, {0, 0, 1}, 2 * geom::pi};
    expect_near(first_direction({10, 0, 0}, helix), {0, std::sqrt(0.5), std::sqrt(0.5)}, 1e-15);
    // On a lathe y was never given.
    expect_near(first_direction({10, NAN, 0}, Arc{{0, NAN, 10}, {0, NAN, 0}, {0, 1, 0}, -geom::pi / 2}), {0, 0, 1},
                1e-15);
    EXPECT_EQ(first_direction({1, 2, 3}, Dwell{}), geom::Vec3{});
}

/// Largest way of the curve off the chords, by many points.
double worst_chord(geom::Vec3 from, const Step& move, double tolerance, const std::function<geom::Vec3(double)>& at) {
    std::vector<geom::Vec3> chain{from};
    points_between(from, move, tolerance, 10'000, [&](geom::Vec3 p) { chain.push_back(p); });
    chain.push_back(position_after(from, move));
    double worst = 0;
    for (int i = 0; i <= 2000; ++i) {
        const geom::Vec3 p = at(i / 2000.0);
        double nearest = INFINITY;
        for (std::size_t k = 1; k < chain.size(); ++k) {
            const geom::Vec3 d = chain[k] - chain[k - 1];
            const double along = std::min(1.0, std::max(0.0, geom::dot(p - chain[k - 1], d) / geom::dot(d, d)));
            nearest = std::min(nearest, geom::distance(p, chain[k - 1] + along * d));
        }
        worst = std::max(worst, nearest);
    }
    return worst;
}

TEST(Spline, ChordsKeepTheirTolerance) {
    const Spline s{{0, 0, 0}, {30, -10, 4}, {-12, 60, 0}, {5, -41, 3}, {0, 0, 1}, {}};
    const Arc arc{{-10, 0, 5}, {0, 0, 0}, {0, 0, 1}, 3 * geom::pi};
    for (const double tolerance : {1.0, 0.1, 0.001}) {
        const double of_spline =
            worst_chord(start_of(s), s, tolerance, [&](double u) { return geom::point_at(forward(s), u); });
        EXPECT_LE(of_spline, tolerance);
        EXPECT_GT(of_spline, tolerance / 8);  // not finer than it must be
        const double of_arc = worst_chord({10, 0, 0}, arc, tolerance, [&](double u) {
            return geom::Vec3{10 * std::cos(u * arc.sweep), 10 * std::sin(u * arc.sweep), 5 * u};
        });
        EXPECT_LE(of_arc, tolerance);
        EXPECT_GT(of_arc, tolerance / 8);
    }
    int points = 0;
    points_between({NAN, 0, 0}, arc, 0.01, 100, [&](geom::Vec3) { ++points; });
    points_between({0, 0, 0}, Linear{{1, 1, 1}, {0, 0, 1}, false}, 0.01, 100, [&](geom::Vec3) { ++points; });
    EXPECT_EQ(points, 0);
    points_between({10, 0, 0}, arc, 1e-9, 100, [&](geom::Vec3) { ++points; });
    EXPECT_EQ(points, 99);
}

/// A curve from start to end comes back from its record; its end may be given exactly.
TEST(Spline, RecordOfACurve) {
    const geom::Cubic c{{1, 2, 3}, {10, -4, 0.5}, {-3, 7, 0}, {0.1, -0.2, 0.3}};
    const Spline s = spline_of(c);
    expect_near(s.to, geom::point_at(c, 1), 1e-15);
    expect_near(start_of(s), c.k0, 1e-14);
    for (const double u : {0.0, 0.25, 0.8, 1.0}) {
        expect_near(geom::point_at(forward(s), u), geom::point_at(c, u), 1e-14);
        expect_near(geom::point_at(curve(s), 1 - u), geom::point_at(c, u), 1e-14);
    }
    EXPECT_TRUE(s.axes.empty());
    EXPECT_EQ(spline_of(c, {8.1, 4.8, 3.8}).to, (geom::Vec3{8.1, 4.8, 3.8}));
}

}  // namespace
}  // namespace obrys::cl
