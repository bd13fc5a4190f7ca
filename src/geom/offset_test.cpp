#include "geom/offset.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "geom/random_contours_testing.hpp"

namespace obrys::geom {
namespace {

const Region square{{{{{{0, 0}}, {{10, 0}}, {{10, 10}}, {{0, 10}}}, true}}};

TEST(Offset, SquareOutwardHasRoundCorners) {
    EXPECT_NEAR(area(offset(square, 2)), 100 + 4 * 10 * 2 + 4 * pi, 1e-8);
    ASSERT_EQ(offset(square, 2).contours.size(), 1U);
    EXPECT_EQ(offset(square, 2).contours[0].vertices.size(), 8U);
}

TEST(Offset, SquareInwardStaysASquareAndVanishes) {
    EXPECT_NEAR(area(offset(square, -2)), 36, 1e-9);
    EXPECT_TRUE(offset(square, -5.5).empty());
}

TEST(Offset, DiscGrowsAndShrinks) {
    const Region disc{{{{{{-3, 5}, 1}, {{3, 5}, 1}}, true}}};
    EXPECT_NEAR(area(offset(disc, 1)), 16 * pi, 1e-8);
    EXPECT_NEAR(area(offset(disc, -1)), 4 * pi, 1e-8);
    EXPECT_NEAR(area(offset(disc, -3.5)), 0, 1e-8);
}

RC_GTEST_PROP(OffsetProperty, AreThePointsNearerThanTheDistance, ()) {
    const Region r = *testing::lattice_region(6);
    const double d = *rc::gen::element(0.3, 1.0, 0.5, -0.25, -0.5);
    const Region o = offset(r, d);
    for (int k = 0; k < 50; ++k) {
        const Vec2 p = *testing::free_point(6);
        const double away = r.empty() ? 1e9 : distance(r, p), inside = contains(r, p) ? away : -away;
        if (std::abs(inside + d) < 1e-6 || away < 1e-6) continue;
        RC_ASSERT(contains(o, p) == (inside + d > 0));
    }
}

}  // namespace
}  // namespace obrys::geom
