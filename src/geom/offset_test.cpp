#include "geom/offset.hpp"

#include <gtest/gtest.h>

#include "geom/boolean.hpp"
#include "geom/random_cases_testing.hpp"

namespace obrys::geom {
namespace {

using testing::disc;
using testing::lattice_region;
using testing::Random;
using testing::rectangle;
using testing::turned;

#ifdef NDEBUG
constexpr unsigned many_offsets = 2000;
#else
constexpr unsigned many_offsets = 500;
#endif

TEST(Offset, OfRectangle) {
    const Region r{{rectangle(1, 2, 8, 6)}};
    const Region grown = offset(r, 1.5);
    EXPECT_NEAR(area(grown), 28 + 22 * 1.5 + pi * 2.25, 1e-12);
    ASSERT_EQ(grown.contours.size(), 1U);
    EXPECT_EQ(grown.contours[0].vertices.size(), 8U);
    const Region shrunk = offset(r, -1.5);
    EXPECT_NEAR(area(shrunk), 4 * 1, 1e-12);
    EXPECT_TRUE(offset(r, -2).empty());
    EXPECT_TRUE(offset(r, -2.5).empty());
    EXPECT_EQ(offset(r, 0), r);
}

TEST(Offset, OfDiscAndRing) {
    EXPECT_NEAR(area(offset({{disc(300, 4, 5)}}, 2)), pi * 49, 1e-9);
    EXPECT_NEAR(area(offset({{disc(300, 4, 5)}}, -2)), pi * 9, 1e-9);
    EXPECT_TRUE(offset({{disc(3, 4, 5)}}, -5).empty());
    EXPECT_TRUE(offset({{disc(3, 4, 5)}}, -6).empty());
    const Region ring{{disc(0, 0, 5), reversed(disc(0, 0, 2))}};
    EXPECT_NEAR(area(offset(ring, 1)), pi * (36 - 1), 1e-9);
    EXPECT_NEAR(area(offset(ring, 2)), pi * 49, 1e-8);
    EXPECT_NEAR(area(offset(ring, 3)), pi * 64, 1e-9);
    EXPECT_NEAR(area(offset(ring, -1)), pi * (16 - 9), 1e-9);
    EXPECT_TRUE(offset(ring, -1.5).empty());
}

TEST(Offset, InwardAndOutwardRoundsCorners) {
    const Region r{{rectangle(0, 0, 10, 6)}};
    EXPECT_NEAR(area(offset(offset(r, -1), 1)), 60 - (4 - pi), 1e-9);
    EXPECT_NEAR(area(offset(offset(r, 1), -1)), 60, 1e-9);
}

TEST(Offset, OfACrescentWithCusps) {
    // Two discs that touch from inside: one cusp; the ends of the crescent are rounded outward.
    const Region crescent = subtract({{disc(0, 0, 3)}}, {{disc(1, 0, 2)}});
    Random random(1);
    const Region grown = offset(crescent, 0.5);
    for (int i = 0; i < 2000; ++i) {
        const Vec2 p = random.point(-4, 4);
        const double d = contains(crescent, p) ? 0 : distance(crescent, p);
        if (std::abs(d - 0.5) < 1e-6) continue;
        EXPECT_EQ(contains(grown, p), d < 0.5) << p.x << ' ' << p.y;
    }
}

void expect_offset(const Region& r, double by, Random& random, Vec2 far) {
    const Region grown = offset(r, by), shrunk = offset(r, -by);
    for (int i = 0; i < 25; ++i) {
        const Vec2 p = far + random.point(-8, 8);
        const double d = distance(r, p);
        const bool inside = contains(r, p);
        if (std::abs(d - by) < 1e-6 || d < 1e-6) continue;
        EXPECT_EQ(contains(grown, p), inside || d < by) << p.x << ' ' << p.y << " by " << by;
        EXPECT_EQ(contains(shrunk, p), inside && d > by) << p.x << ' ' << p.y << " by " << by;
    }
    EXPECT_NEAR(area(subtract(r, grown)), 0, 1e-7);
    EXPECT_NEAR(area(subtract(shrunk, r)), 0, 1e-7);
    EXPECT_NEAR(area(subtract(r, offset(grown, -by))), 0, 2e-7) << "closing keeps the region";
    EXPECT_NEAR(area(subtract(offset(shrunk, by), r)), 0, 2e-7) << "opening stays within it";
}

TEST(OffsetRandom, PointsNearerThanTheDistanceAndNoOthers) {
    constexpr double distances[] = {0.05, 0.4, 0.5, 1, 1.25, 2};
    for (unsigned number = 0; number < many_offsets && !HasFailure(); ++number) {
        SCOPED_TRACE(number);
        Random random(number);
        const Vec2 far = random.below(2) ? Vec2{400, -250} : Vec2{};
        const double angle = random.below(2) ? random.between(0, 6) : 0;
        const double by = random.below(3) ? random.one_of(distances) : random.between(0.001, 2);
        expect_offset(turned(lattice_region(random, 6), angle, far), by, random, far);
    }
}

}  // namespace
}  // namespace obrys::geom
