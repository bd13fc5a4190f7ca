/// Bent rapids: where they lead, and by which way.

#include "motion/rapid_way.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "base/seed_testing.hpp"

namespace obrys::motion {
namespace {

using geom::Vec3;

shop::Machine machine_with(const std::array<double, 3>& speeds) {
    shop::Machine m;
    for (std::size_t k = 0; k < speeds.size(); ++k) {
        shop::MachineAxis a;
        a.name = std::string(1, "XYZ"[k]);
        a.rapid = speeds[k];
        m.axes.push_back(a);
    }
    return m;
}

bool near(const Vec3& a, const Vec3& b) { return geom::distance(a, b) < 1e-9; }

TEST(RapidWay, ItBendsWhereAnAxisStops) {
    const auto corners = corners_of_rapid(machine_with({10'000, 5'000, 10'000}), upright_axes, {0, 0, 0}, {10, 10, 30});
    ASSERT_EQ(corners.size(), 3U);
    EXPECT_TRUE(near(corners[0], {10, 5, 10}));
    EXPECT_TRUE(near(corners[1], {10, 10, 20}));
    EXPECT_TRUE(near(corners[2], {10, 10, 30}));
}

TEST(RapidWay, OneAxisOrAxesThatStopTogetherGoStraight) {
    const shop::Machine m = machine_with({10'000, 5'000, 10'000});
    EXPECT_EQ(corners_of_rapid(m, upright_axes, {1, 2, 3}, {1, 2, -40}).size(), 1U);
    EXPECT_EQ(corners_of_rapid(m, upright_axes, {0, 0, 0}, {20, 10, 20}).size(), 1U);
    EXPECT_EQ(corners_of_rapid(m, upright_axes, {1, 2, 3}, {1, 2, 3}).size(), 1U);
}

TEST(RapidWay, AxesThatNoFileKnowsAreEquallyFast) {
    const auto corners = corners_of_rapid({}, upright_axes, {0, 0, 0}, {30, 10, 0});
    ASSERT_EQ(corners.size(), 2U);
    EXPECT_TRUE(near(corners[0], {10, 10, 0}));
}

/// In the box of both ends along the machine's axes, ever nearer to the end along each of them, and each piece has an
/// axis less than the one before.
TEST(RapidWay, ItsCornersLieInTheBoxOfItsEnds) {
    const std::uint32_t seed = base::testing_seed();
    SCOPED_TRACE(seed);
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> coordinate(-100, 100), speed(1'000, 60'000), angle(-3, 3);
    for (int n = 0; n < 2'000; ++n) {
        const shop::Machine m = machine_with({speed(random), speed(random), speed(random)});
        const double c = std::cos(angle(random)), s = std::sqrt(1 - c * c);
        const LinearAxes axes = n % 2 == 0 ? upright_axes : LinearAxes{Vec3{c, 0, s}, Vec3{0, 1, 0}, Vec3{-s, 0, c}};
        ASSERT_TRUE(are_square(axes));
        const Vec3 from{coordinate(random), coordinate(random), coordinate(random)};
        Vec3 to{coordinate(random), coordinate(random), coordinate(random)};
        if (n % 5 == 0) to.y = from.y;
        const auto corners = corners_of_rapid(m, axes, from, to);
        ASSERT_FALSE(corners.empty());
        ASSERT_LE(corners.size(), 3U);
        EXPECT_EQ(corners.back(), to);
        Vec3 last = from;
        int moving_before = 4;
        for (const Vec3& p : corners) {
            int moving = 0;
            for (const Vec3& axis : axes) {
                const double whole = geom::dot(axis, to - from), left = geom::dot(axis, to - last),
                             rest = geom::dot(axis, to - p);
                const double sign = whole < 0 ? -1 : 1;
                EXPECT_GE(sign * rest, -1e-9);
                EXPECT_LE(sign * rest, sign * left + 1e-9);
                EXPECT_LE(sign * left, sign * whole + 1e-9);
                moving += std::abs(geom::dot(axis, p - last)) > 1e-8 ? 1 : 0;
            }
            EXPECT_LT(moving, moving_before);
            moving_before = moving;
            last = p;
        }
    }
}

}  // namespace
}  // namespace obrys::motion
