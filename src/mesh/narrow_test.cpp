#include "mesh/narrow.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "mesh/primitives.hpp"

namespace obrys::mesh {
namespace {

using geom::Vec3;

constexpr std::size_t many = 100'000;

/// Two blocks of 10 x 10 x 4 mm with a gap between them.
Distance blocks(double gap) {
    Mesh m = box({0, 0, 0}, {10, 10, 4});
    append(m, box({10 + gap, 0, 0}, {20 + gap, 10, 4}));
    return Distance(std::move(m));
}

TEST(Narrow, FacesAcrossAGapAreFoundAndNoOthers) {
    const auto found = narrow_faces(blocks(0.1), 0.5, 0.2, many);
    ASSERT_TRUE(found);
    double area = 0;
    for (const NarrowFace& f : *found) {
        for (const Vec3& c : f.corners) {
            EXPECT_GE(c.x, 10);
            EXPECT_LE(c.x, 10.1);
        }
        for (std::size_t i = 0; i < 3; ++i) EXPECT_LE(geom::distance(f.corners[i], f.corners[(i + 1) % 3]), 0.2);
        area += 0.5 * length(cross(f.corners[1] - f.corners[0], f.corners[2] - f.corners[0]));
    }
    EXPECT_NEAR(area, 2 * 10 * 4, 1e-9);
    EXPECT_FALSE(narrow_faces(blocks(0.1), 0.5, 0.2, 100));
}

TEST(Narrow, WhatIsWideOrHasNothingBeforeItIsNot) {
    const auto wide = narrow_faces(blocks(0.6), 0.5, 0.2, many);
    ASSERT_TRUE(wide);
    EXPECT_TRUE(wide->empty());
    // A thin plate: its faces look away from each other.
    const auto plate = narrow_faces(Distance(box({0, 0, 0}, {10, 10, 0.1})), 0.5, 0.2, many);
    ASSERT_TRUE(plate);
    EXPECT_TRUE(plate->empty());
}

TEST(Narrow, WindingKnowsBodiesWithinBodiesAndHollows) {
    Mesh m = box({0, 0, 0}, {10, 10, 10});
    append(m, box({5, 5, 5}, {15, 15, 15}));
    Mesh hollow = box({1, 1, 1}, {3, 3, 3});
    turn_over(hollow);
    append(m, hollow);
    const Distance d(std::move(m));
    EXPECT_EQ(winding(d, {4, 4, 4}), 1);
    EXPECT_EQ(winding(d, {7, 7, 7}), 2);
    EXPECT_EQ(winding(d, {2, 2, 2}), 0);
    EXPECT_EQ(winding(d, {12, 3, 3}), 0);
    EXPECT_EQ(winding(d, {-1, 5, 5}), 0);
}

}  // namespace
}  // namespace obrys::mesh
