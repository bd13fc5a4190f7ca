#include <gtest/gtest.h>

#include "geom/boolean.hpp"
#include "geom/random_cases_testing.hpp"

namespace obrys::geom {
namespace {

using testing::lattice_loop;
using testing::lattice_region;
using testing::Random;
using testing::turned;

#ifdef NDEBUG
constexpr unsigned many_booleans = 6000;
#else
constexpr unsigned many_booleans = 2000;
#endif

/// x is what odd crossings make of the loop, which needs no arrangement.
void expect_membership(const Contour& x, const Contour& y, Random& random, int points) {
    const Region a = tidied({x}), b = tidied({y});
    const Region u = unite(a, b), i = intersect(a, b), d = subtract(a, b);
    EXPECT_NEAR(area(u) + area(i), area(a) + area(b), 1e-7);
    EXPECT_NEAR(area(d) + area(i), area(a), 1e-7);
    const std::vector<Edge> ex = edges(x), ey = edges(y);
    for (int k = 0; k < points; ++k) {
        const Vec2 p = random.point(-1, 7);
        if (distance(Region{{x, y}}, p) < 1e-6) continue;
        const bool in_a = winding(ex, p) % 2 != 0, in_b = winding(ey, p) % 2 != 0;
        EXPECT_EQ(contains(a, p), in_a);
        EXPECT_EQ(contains(u, p), in_a || in_b);
        EXPECT_EQ(contains(i, p), in_a && in_b);
        EXPECT_EQ(contains(d, p), in_a && !in_b);
    }
}

TEST(BooleanRandom, MembershipAndAreasAreThoseOfTheDrawnLoops) {
    for (unsigned number = 0; number < many_booleans && !HasFailure(); ++number) {
        SCOPED_TRACE(number);
        Random random(number);
        const Contour x = lattice_loop(random, 6), y = lattice_loop(random, 6);
        expect_membership(x, y, random, 12);
    }
}

TEST(BooleanRandom, RigidMotionOfInputIsRigidMotionOfResult) {
    for (unsigned number = 0; number < many_booleans / 6 && !HasFailure(); ++number) {
        SCOPED_TRACE(number);
        Random random(number);
        const Region a = lattice_region(random, 6), b = lattice_region(random, 6);
        const double w = random.between(0, 2 * pi);
        for (const double far : {0.0, 100.0, 400.0}) {
            const Region ta = turned(a, w, {far, 0.5 * far}), tb = turned(b, w, {far, 0.5 * far});
            EXPECT_NEAR(area(subtract(ta, tb)), area(subtract(a, b)), 1e-7) << far;
            EXPECT_NEAR(area(unite(ta, tb)), area(unite(a, b)), 1e-7) << far;
        }
    }
}

TEST(BooleanRandom, NearlyCoincidentRegionsDifferByNearlyNothing) {
    for (unsigned number = 0; number < many_booleans / 3 && !HasFailure(); ++number) {
        SCOPED_TRACE(number);
        Random random(number);
        const Region a = lattice_region(random, 6), b = lattice_region(random, 6);
        const double by = std::pow(10, random.between(-13, -6)), angle = random.between(0, 2 * pi);
        const Vec2 far = random.below(2) ? Vec2{400, 250} : Vec2{};
        const Region fixed = turned(a, 0, far);
        const Region shifted = turned(b, 0, far + by * Vec2{std::cos(angle), std::sin(angle)});
        const Region twin = turned(a, by / 6, far);
        EXPECT_NEAR(area(subtract(fixed, shifted)), area(subtract(a, b)), 200 * by + 2e-7) << by;
        EXPECT_NEAR(area(subtract(fixed, twin)), 0, 200 * by + 2e-7) << by;
        EXPECT_NEAR(area(unite(fixed, twin)), area(a), 200 * by + 2e-7) << by;
        EXPECT_NEAR(area(intersect(fixed, twin)), area(a), 200 * by + 2e-7) << by;
    }
}

TEST(BooleanRandom, ArcsThatAreNearlyStraight) {
    for (unsigned number = 0; number < many_booleans / 6 && !HasFailure(); ++number) {
        SCOPED_TRACE(number);
        Random random(number);
        Contour x = lattice_loop(random, 6), y = lattice_loop(random, 6);
        for (Contour* c : {&x, &y})
            for (Vertex& v : c->vertices)
                if (random.below(2))
                    v.bulge = std::copysign(std::pow(10, random.between(-13, -3)), random.between(-1, 1));
        expect_membership(x, y, random, 12);
    }
}

TEST(BooleanRandom, RepeatedCutsLoseNothing) {
    // As in turning: one region, many_booleans cuts each of which shares an edge with what the last one left.
    for (unsigned number = 0; number < many_booleans / 40 && !HasFailure(); ++number) {
        SCOPED_TRACE(number);
        Random random(number);
        Region rest{{testing::rectangle(0, 0, 100, 40)}};
        double removed = 0;
        Vec2 at{random.between(0, 100), random.between(20, 45)};
        for (int i = 0; i < 30; ++i) {
            const Vec2 to = random.below(3) ? Vec2{random.between(0, 100), at.y} : Vec2{at.x, random.between(5, 45)};
            const double lo = std::min(at.x, to.x) - 0.4, hi = std::max(at.x, to.x) + 0.4;
            const Region cut{{testing::disc(at.x, at.y, 0.4), testing::rectangle(lo, std::min(at.y, to.y), hi, 50)}};
            const Region whole = positive(cut.contours);
            removed += area(intersect(rest, whole));
            rest = subtract(rest, whole);
            at = to;
        }
        EXPECT_NEAR(area(rest) + removed, 4000, 1e-6);
    }
}

}  // namespace
}  // namespace obrys::geom
