#include "geom/sweep.hpp"

#include <gtest/gtest.h>

#include <functional>

#include "geom/boolean.hpp"
#include "geom/random_cases_testing.hpp"

namespace obrys::geom {
namespace {

using testing::disc;
using testing::Random;
using testing::rectangle;

#ifdef NDEBUG
constexpr unsigned many_sweeps = 150;
#else
constexpr unsigned many_sweeps = 25;
#endif

/// Corners of a regular polygon, some moved in: convex or not, simple, with some sides bent outward.
Contour star(Random& random) {
    Contour out;
    const int n = 3 + random.below(5);
    const double turn = random.between(0, 6);
    const bool dented = random.below(2) != 0;
    for (int i = 0; i < n; ++i) {
        const double w = turn + 2 * pi * i / n, r = dented ? random.between(0.4, 1.2) : 1;
        const double room = std::tan(pi / (2 * n));  // the bulge of the circle about the polygon
        out.vertices.push_back(
            {r * Vec2{std::cos(w), std::sin(w)}, random.below(2) ? random.between(-0.2, 1) * room : 0});
    }
    return out;
}

Contour outline_of(Random& random) {
    switch (random.below(5)) {
        case 0: return rectangle(0, 0, 3, 0.5 + random.below(2));  // blade
        case 1: return disc(random.below(2), 0, 0.8);
        case 2: return {{{{-0.4, 0}, 1}, {{0.4, 0}}, {{0.4, 3}}, {{-0.4, 3}}}, true};  // round grooving insert
        case 3: return {{{{0.4, 0}, std::tan(pi / 8)}, {{0, 0.4}}, {{-3, 1}}, {{-1, -2}}}, true};
        default: return star(random);
    }
}

/// `shift`: by fraction of the motion, samples close enough that two neighbours differ by less than `step`.
void expect_covered(const Region& swept, const Contour& outline, const std::function<Vec2(double)>& shift, double step,
                    Random& random) {
    const std::vector<Edge> around = edges(outline);
    Box reach;
    constexpr int samples = 2000;
    for (int k = 0; k <= samples; k += 50) reach.add(shift(k / 2000.0));
    for (int i = 0; i < 25; ++i) {
        const Vec2 p =
            random.point(-4, 4) + Vec2{random.between(reach.lo.x, reach.hi.x), random.between(reach.lo.y, reach.hi.y)};
        if (distance(swept, p) < 2 * step) continue;
        bool covered = false;
        for (int k = 0; k <= samples && !covered; ++k) covered = winding(around, p - shift(k / 2000.0)) > 0;
        EXPECT_EQ(contains(swept, p), covered) << p.x << ' ' << p.y;
    }
}

TEST(Sweep, Straight) {
    EXPECT_NEAR(area(sweep_straight(rectangle(0, 0, 2, 1), {3, 4})), 2 + 3 * 1 + 4 * 2, 1e-12);
    EXPECT_NEAR(area(sweep_straight(disc(0, 0, 1), {3, 4})), pi + 2 * 5, 1e-12);
    EXPECT_NEAR(area(sweep_straight(rectangle(0, 0, 2, 1), {0, 0})), 2, 1e-12);
    EXPECT_NEAR(area(sweep_straight(rectangle(0, 0, 2, 1), {-3, 0})), 5, 1e-12);
}

TEST(Sweep, RoundOfADiscIsAThickArc) {
    const double r = 0.5, path = 3;
    for (const double w : {-2.0, -0.3, 0.3, 2.0, 5.0}) {
        const Region thick = sweep_round(disc(0, 0, r), {400, 0}, path, 1, w);
        EXPECT_NEAR(area(thick), pi * r * r + std::abs(w) * path * 2 * r, 1e-8) << w;
    }
    for (const double w : {2 * pi, -2 * pi, 7.0, -20.0}) {
        const Region ring = sweep_round(disc(0, 0, r), {400, 0}, path, 1, w);
        EXPECT_NEAR(area(ring), pi * (3.5 * 3.5 - 2.5 * 2.5), 1e-8) << w;
        EXPECT_EQ(ring.contours.size(), 2U);
    }
    // the path's circle within the disc: no hole
    EXPECT_NEAR(area(sweep_round(disc(0, 0, 2), {0, 0}, 1, 0.3, 2 * pi)), pi * 9, 1e-8);
    EXPECT_NEAR(area(sweep_round(disc(0, 0, 1), {0, 0}, 1, 0.3, 2 * pi)), pi * 4, 1e-8);
    EXPECT_NEAR(area(sweep_round(rectangle(0, 0, 2, 1), {5, 5}, 1, 0.3, 0)), 2, 1e-8);
}

TEST(SweepRandom, StraightCoversTheShiftedOutlinesAndNoMore) {
    for (unsigned number = 0; number < many_sweeps && !HasFailure(); ++number) {
        SCOPED_TRACE(number);
        Random random(number);
        const Contour outline = outline_of(random);
        constexpr Vec2 ways[] = {{3, 0}, {0, -2}, {-1, 0}, {1, 1}, {-2, 0.5}, {0.001, 0}, {1e-7, 1e-7}};
        const Vec2 by = random.below(2) ? random.one_of(ways) : random.point(-4, 4);
        expect_covered(
            sweep_straight(outline, by), outline, [by](double t) { return t * by; }, 5e-3, random);
    }
}

TEST(SweepRandom, RoundCoversTheShiftedOutlinesAndNoMore) {
    for (unsigned number = 0; number < many_sweeps && !HasFailure(); ++number) {
        SCOPED_TRACE(number);
        Random random(number);
        const Contour outline = outline_of(random);
        constexpr double radii[] = {0.4, 0.8, 1, 2, 0.01, 50};
        constexpr double sweeps[] = {pi / 2, -pi / 2, pi, 2 * pi, -2 * pi, 0.001, -8, 1e-6};
        constexpr double starts[] = {0, pi / 2, -pi, 1, 4};
        const double radius = random.below(2) ? random.one_of(radii) : random.between(0.1, 4);
        const double from = random.below(2) ? random.one_of(starts) : random.between(-7, 7);
        const double sweep = random.below(2) ? random.one_of(sweeps) : random.between(-7, 7);
        const Vec2 centre = random.below(2) ? Vec2{} : random.point(-300, 300);
        const auto shift = [&](double t) {
            return centre + radius * Vec2{std::cos(from + t * sweep), std::sin(from + t * sweep)};
        };
        const double step = 1e-3 + std::abs(radius * sweep) / 2000;
        expect_covered(sweep_round(outline, centre, radius, from, sweep), outline, shift, step, random);
    }
}

}  // namespace
}  // namespace obrys::geom
