#include "geom/sweep.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "geom/random_contours_testing.hpp"

namespace obrys::geom {
namespace {

/// A simple outline: the largest outer contour of a random region.
Contour outline_of(const Region& r) {
    Contour best;
    for (const Contour& c : r.contours)
        if (best.vertices.empty() || area(c) > area(best)) best = c;
    return best;
}

TEST(Sweep, ZeroMoveIsTheOutline) {
    const Contour square{{{{0, 0}}, {{1, 0}}, {{1, 1}}, {{0, 1}}}, true};
    EXPECT_EQ(area(sweep_straight(square, {0, 0})), 1);
    EXPECT_NEAR(area(sweep_straight(square, {2, 3})), 1 + 2 + 3, 1e-12);
}

TEST(Sweep, DiscAroundACircleIsARing) {
    const Contour disc{{{{-1, 0}, 1}, {{1, 0}, 1}}, true};
    EXPECT_NEAR(area(sweep_round(disc, {5, 5}, 3, 0.3, 2 * pi)), pi * (16 - 4), 1e-7);
    EXPECT_NEAR(area(sweep_round(disc, {5, 5}, 0.5, 0.3, 2 * pi)), pi * 2.25, 1e-7);
}

// The sampled oracle: a point is covered if it lies in the outline at one of many poses, and not if it is farther from all
// of them than the step between two.
RC_GTEST_PROP(SweepProperty, CoversWhatThePosesCover, ()) {
    const Contour outline = outline_of(*testing::lattice_region(5, 6));
    if (outline.vertices.empty()) return;
    const bool round = *rc::gen::arbitrary<bool>();
    const double turn = *rc::gen::element(0.5, -0.5, pi / 2, -pi / 2, pi, 2.5, -2 * pi);
    const double radius = *rc::gen::element(1.0, 2.0, 0.5, 3.25), from = *rc::gen::element(0.0, pi / 2, pi, 0.7);
    const Vec2 by{static_cast<double>(*rc::gen::inRange(-3, 4)), static_cast<double>(*rc::gen::inRange(-3, 4))};
    const Region r = round ? sweep_round(outline, {0, 0}, radius, from, turn) : sweep_straight(outline, by);
    const auto pose = [&](double t) {
        return round ? radius * Vec2{std::cos(from + t * turn), std::sin(from + t * turn)} : t * by;
    };
    constexpr int steps = 200;
    const double step = (round ? radius * std::abs(turn) : length(by)) / steps;
    for (int k = 0; k < 20; ++k) {
        const Vec2 p = *testing::free_point(6);
        bool covered = false;
        double away = 1e9;
        for (int i = 0; i <= steps; ++i) {
            const Vec2 q = p - pose(static_cast<double>(i) / steps);
            covered = covered || contains({{outline}}, q);
            away = std::min(away, distance(Region{{outline}}, q));
        }
        if (!r.empty() && distance(r, p) < 1e-6) continue;
        if (covered) RC_ASSERT(contains(r, p));
        if (!covered && away > step) RC_ASSERT(!contains(r, p));
    }
}

}  // namespace
}  // namespace obrys::geom
