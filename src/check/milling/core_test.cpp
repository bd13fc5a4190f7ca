#include "check/milling/core.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <functional>
#include <random>

namespace obrys::check {
namespace {

using geom::Vec3;

/// Whether a way is too steep anywhere; in pieces of at most a quarter of the core.
bool is_steep(double core, const std::function<Vec3(double)>& at, double length, bool met = true) {
    CoreDescent descent;
    descent.begin(core, 0.001);
    const int pieces = static_cast<int>(std::ceil(4 * length / core));
    bool steep = false;
    for (int i = 0; i < pieces; ++i) {
        std::array<Vec3, 5> points;
        for (std::size_t k = 0; k < points.size(); ++k)
            points[k] = at((i + static_cast<double>(k) / 4) / pieces * length);
        steep = descent.take(points, met) || steep;
    }
    return steep;
}

/// On a straight ramp what lies under the core is as high as the ramp falls over the core's width.
TEST(CoreDescent, StraightRampsUpToThirtyDegreesGo) {
    std::mt19937 random(1);
    std::uniform_real_distribution<double> angle(1, 89), size(0.5, 20), heading(0, 2 * geom::pi);
    for (int i = 0; i < 500; ++i) {
        const double core = size(random), a = angle(random), to = heading(random);
        if (std::abs(a - 30) < 1) continue;
        const double way = 5 * core, slope = geom::radians(a);
        const auto at = [&](double s) {
            return Vec3{s * std::cos(slope) * std::cos(to), s * std::cos(slope) * std::sin(to), -s * std::sin(slope)};
        };
        EXPECT_EQ(is_steep(core, at, way), a > 30) << a << " degrees, core " << core;
        EXPECT_FALSE(is_steep(core, at, way, false));
    }
}

/// While the core crosses a place, on a chord of its own width, a helix turns by 2 asin(core / radius); one narrower
/// than the core leaves what lies in its middle for ever.
TEST(CoreDescent, HelicesWiderThanTheCoreGo) {
    std::mt19937 random(2);
    std::uniform_real_distribution<double> size(0.5, 20), share(0.05, 4), rise(0.02, 4);
    for (int i = 0; i < 500; ++i) {
        const double core = size(random), radius = core * share(random), pitch = core * rise(random);
        const double depth = 4 * core + 3 * pitch, turn = std::hypot(2 * geom::pi * radius, pitch);
        const auto at = [&](double s) {
            const double t = s / turn;
            return Vec3{radius * std::cos(2 * geom::pi * t), radius * std::sin(2 * geom::pi * t), -pitch * t};
        };
        double ratio = depth / (2 * radius);
        if (radius >= core) ratio = pitch * std::asin(core / radius) / (2 * geom::pi * core);
        if (std::abs(ratio / CoreDescent::steepest - 1) < 0.15 || std::abs(radius / core - 1) < 0.02) continue;
        EXPECT_EQ(is_steep(core, at, depth / pitch * turn), ratio > CoreDescent::steepest)
            << "radius " << radius << " pitch " << pitch << " core " << core;
    }
}

/// A ramp to and fro in a slot shorter than the core is as good as a plunge, on a long one every layer is cleared.
TEST(CoreDescent, RampsToAndFroMustBeLongerThanTheCore) {
    const auto to_and_fro = [](double half) {
        return [half](double s) {
            const double way = std::fmod(s, 4 * half), x = way < 2 * half ? way - half : 3 * half - way;
            return Vec3{x, 0, -0.05 * s};
        };
    };
    EXPECT_TRUE(is_steep(2, to_and_fro(0.8), 100));
    EXPECT_FALSE(is_steep(2, to_and_fro(15), 400));
}

/// Layer by layer at the same place, with level ways between that clear it.
TEST(CoreDescent, WhatLevelWaysClearDoesNotCountAgain) {
    CoreDescent descent;
    descent.begin(2, 0.001);
    for (int layer = 0; layer < 20; ++layer) {
        const double z = -layer;
        for (int i = 0; i < 16; ++i) {
            const std::array<Vec3, 2> ramp{Vec3{0.5 * i, 0, z - i / 16.0}, Vec3{0.5 * i + 0.5, 0, z - (i + 1) / 16.0}};
            EXPECT_FALSE(descent.take(ramp, true));
        }
        const std::array<Vec3, 2> back{Vec3{8, 0, z - 1}, Vec3{0, 0, z - 1}};
        EXPECT_FALSE(descent.take(back, false));
    }
}

}  // namespace
}  // namespace obrys::check
