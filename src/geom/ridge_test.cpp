#include "geom/ridge.hpp"

#include <gtest/gtest.h>

#include <random>

namespace obrys::geom {
namespace {

TEST(Ridge, TheFiguresOfTheThesisExample) {
    const RidgeTool tool{50, 4};
    EXPECT_NEAR(half_ridge_step(tool), 13.564659966250536, 1e-12);
    EXPECT_NEAR(degrees(ridge_step_angle(100, tool, true)), 13.641003449980756, 1e-9);
    EXPECT_NEAR(degrees(ridge_step_angle(80, tool, false)), 24.08647160097871, 1e-9);
    EXPECT_NEAR(ridge_of_arc(100, radians(180.0 / 14), 50, true), 3.4987103104982538, 1e-9);
    EXPECT_NEAR(ridge_of_arc(80, radians(22.5), 50, false), 3.4765573001501195, 1e-9);
    EXPECT_NEAR(ridge_of_line(332.41540277189324 / 13, 50), 3.5165537788170127, 1e-9);
}

TEST(Ridge, IsAsHighAsAskedForAtTheWidestStep) {
    std::mt19937 random(7);
    std::uniform_real_distribution<double> share(0.0, 1.0);
    for (int i = 0; i < 2000; ++i) {
        const double d = 0.5 + 80 * share(random),
                     h = d / 8 * std::pow(share(random), 3) + 1e-4;  // far below the radius
        const RidgeTool tool{d, std::min(h, d / 2)};
        EXPECT_NEAR(ridge_of_line(2 * half_ridge_step(tool), d), tool.height, 1e-7);
        const double radius = 200 * std::pow(share(random), 2);
        const double out = ridge_step_angle(radius, tool, true);
        EXPECT_LE(ridge_of_arc(radius, out, d, true), tool.height + 1e-7);
        if (out < pi / 2) {
            EXPECT_NEAR(ridge_of_arc(radius, out, d, true), tool.height, 1e-6);
        }
        const double inner = d / 2 + radius + 1e-3, in = ridge_step_angle(inner, tool, false);
        EXPECT_LE(ridge_of_arc(inner, in, d, false), tool.height + 1e-7);
        if (in < pi / 2) {
            EXPECT_NEAR(ridge_of_arc(inner, in, d, false), tool.height, 1e-6);
        }
    }
}

TEST(Ridge, GapsAreInfinite) {
    EXPECT_TRUE(std::isinf(ridge_of_line(11, 10)));
    EXPECT_TRUE(std::isinf(ridge_of_arc(50, 2, 10, true)));
}

TEST(Ridge, TheCornerLiesOnTheSideThatIsAskedFor) {
    EXPECT_EQ(stair_corner({0, 0}, {2, 1}, true), (Vec2{0, 1}));
    EXPECT_EQ(stair_corner({0, 0}, {2, 1}, false), (Vec2{2, 0}));
    EXPECT_EQ(stair_corner({2, 1}, {0, 0}, true), (Vec2{2, 0}));
    EXPECT_EQ(stair_corner({0, 0}, {-2, 1}, true), (Vec2{-2, 0}));
}

}  // namespace
}  // namespace obrys::geom
