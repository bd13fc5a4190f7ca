/// What is seen of a mesh: places to the pixel, hidden faces, cuts, coordinates that are no numbers.
#include "report/picture/raster.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "mesh/primitives.hpp"

namespace obrys::report::picture {
namespace {

using geom::Vec3;

mesh::Mesh square(double side, double z) {
    return {{{0, 0, z}, {side, 0, z}, {side, side, z}, {0, side, z}}, {{0, 1, 2}, {0, 2, 3}}, {}};
}

Camera above(int width, int height) {
    Camera c;
    c.y = height;
    c.width = width;
    c.height = height;
    return c;
}

TEST(Raster, ASquareCoversItsPixelsOnce) {
    Camera c = above(20, 20);
    c.px_per_mm = 2;
    const Visible v = rasterise(square(5, 1.25), c);
    for (int j = 0; j < 20; ++j)
        for (int i = 0; i < 20; ++i) {
            const bool covered = i < 10 && j >= 10;
            EXPECT_EQ(v.triangle[v.at(i, j)] != Visible::none, covered) << i << ' ' << j;
            if (covered) {
                EXPECT_FLOAT_EQ(v.depth[v.at(i, j)], 1.25F);
            }
        }
}

TEST(Raster, TheNearerOneIsSeenWhateverTheOrder) {
    for (const bool lower_first : {true, false}) {
        mesh::Mesh m = square(10, lower_first ? 1 : 2);
        append(m, square(10, lower_first ? 2 : 1));
        const Visible v = rasterise(m, above(10, 10));
        for (const std::uint32_t t : v.triangle) EXPECT_EQ(t / 2, lower_first ? 1U : 0U);
    }
}

TEST(Raster, WhatLiesBeforeTheCutIsNotSeen) {
    mesh::Mesh m = square(10, 1);
    append(m, square(10, 5));
    Camera c = above(10, 10);
    c.nearest = 3;
    for (const std::uint32_t t : rasterise(m, c).triangle) EXPECT_EQ(t / 2, 0U);
    c.nearest = 0.5;
    for (const std::uint32_t t : rasterise(m, c).triangle) EXPECT_EQ(t, Visible::none);
}

TEST(Raster, CornersThatAreNoNumbersOrTooFarLeaveTheirTrianglesOut) {
    for (const double bad : {double(NAN), double(INFINITY), -double(INFINITY), 1e300, -1e18}) {
        for (const int axis : {0, 1, 2}) {
            mesh::Mesh m = square(10, 1);
            Vec3 far{0, 0, 0};
            (axis == 0 ? far.x : axis == 1 ? far.y : far.z) = bad;
            m.vertices.push_back(far);
            m.triangles.insert(m.triangles.begin(), {0, 1, 4});
            const Visible v = rasterise(m, above(10, 10));
            for (const std::uint32_t t : v.triangle)
                if (axis < 2 || !(std::abs(bad) < 1e30)) {
                    EXPECT_TRUE(t == 1 || t == 2) << bad << ' ' << axis;
                }
        }
    }
    mesh::Mesh wrong = square(10, 1);
    wrong.triangles.push_back({0, 1, 99});
    EXPECT_TRUE(rasterise(wrong, above(10, 10)).complete);
}

/// The outline of a box from any side ends at its projected corners.
TEST(Raster, OutlinesLieAtTheProjectedPlacesToAPixel) {
    std::mt19937 random(20261121);
    std::uniform_real_distribution<double> angle(-3, 3), size(5, 40);
    for (int round = 0; round < 60; ++round) {
        const double a = angle(random), e = angle(random) / 2;
        Camera c;
        c.right = {std::cos(a), std::sin(a), 0};
        c.up = {-std::sin(a) * std::sin(e), std::cos(a) * std::sin(e), std::cos(e)};
        c.toward = cross(c.right, c.up);
        c.px_per_mm = 3;
        c.width = c.height = 300;
        c.x = c.y = 150;
        const Vec3 half{size(random) / 2, size(random) / 2, size(random) / 2};
        const mesh::Mesh m = mesh::box(-1.0 * half, half);
        double left = INFINITY, right = -INFINITY, top = INFINITY, bottom = -INFINITY;
        for (const Vec3 p : m.vertices) {
            const Vec3 d = p;
            const double x = 150 + 3 * dot(d, c.right), y = 150 - 3 * dot(d, c.up);
            left = std::min(left, x), right = std::max(right, x), top = std::min(top, y), bottom = std::max(bottom, y);
        }
        const Visible v = rasterise(m, c);
        int first = 300, last = -1, highest = 300, lowest = -1;
        for (int j = 0; j < 300; ++j)
            for (int i = 0; i < 300; ++i)
                if (v.triangle[v.at(i, j)] != Visible::none) {
                    first = std::min(first, i), last = std::max(last, i);
                    highest = std::min(highest, j), lowest = std::max(lowest, j);
                }
        // A sharp corner can lie between the middles of pixels: two of them at the most.
        EXPECT_NEAR(first, left, 2) << "seed 20261121, round " << round;
        EXPECT_NEAR(last + 1, right, 2) << "round " << round;
        EXPECT_NEAR(highest, top, 2) << "round " << round;
        EXPECT_NEAR(lowest + 1, bottom, 2) << "round " << round;
    }
}

}  // namespace
}  // namespace obrys::report::picture
