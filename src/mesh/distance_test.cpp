#include "mesh/distance.hpp"

#include <gtest/gtest.h>

#include <random>

#include "mesh/primitives.hpp"

namespace obrys::mesh {
namespace {

using geom::Vec3;

/// Signed distance to a box about the origin, by formula.
double box_distance(Vec3 p, Vec3 half) {
    const Vec3 q{std::abs(p.x) - half.x, std::abs(p.y) - half.y, std::abs(p.z) - half.z};
    const Vec3 out{std::max(q.x, 0.0), std::max(q.y, 0.0), std::max(q.z, 0.0)};
    return length(out) + std::min(std::max({q.x, q.y, q.z}), 0.0);
}

TEST(DistanceTo, a_box_agrees_with_the_formula) {
    const Vec3 half{3, 2, 1};
    const geom::Frame turn =
        geom::Frame::shift({5, -7, 2}) * geom::Frame::rotation(0, 0.4) * geom::Frame::rotation(2, 1.1);
    const Distance d(transformed(box(-1.0 * half, half), turn));
    std::mt19937 random(1);
    std::uniform_real_distribution<double> coordinate(-5, 5);
    for (int i = 0; i < 5000; ++i) {
        const Vec3 p{coordinate(random), coordinate(random), coordinate(random)};
        ASSERT_NEAR(d.signed_distance(apply(turn, p)), box_distance(p, half), 1e-12) << p.x << ' ' << p.y << ' ' << p.z;
    }
}

TEST(DistanceTo, a_box_is_right_on_its_planes_edges_and_corners) {
    const Vec3 half{3, 2, 1};
    const Distance d(box(-1.0 * half, half));
    for (const double x : {-4.0, -3.0, 0.0, 3.0, 4.0})
        for (const double y : {-3.0, -2.0, 0.0, 2.0, 3.0})
            for (const double z : {-2.0, -1.0, -0.5, 1.0, 2.0})
                EXPECT_NEAR(d.signed_distance({x, y, z}), box_distance({x, y, z}, half), 1e-12);
}

TEST(DistanceTo, a_round_body_agrees_with_every_triangle_asked_by_itself) {
    Mesh m = ball({1, 2, 3}, 4, 36);
    append(m, cylinder({9, 2, 0}, 1.5, 6, 24));
    const Distance d(m);
    std::mt19937 random(2);
    std::uniform_real_distribution<double> coordinate(-5, 13);
    for (int i = 0; i < 1000; ++i) {
        const Vec3 p{coordinate(random), coordinate(random), coordinate(random)};
        double best = 1e9;
        for (std::size_t t = 0; t < m.triangles.size(); ++t)
            best = std::min(best, nearest_on_triangle(p, corners(m, t)).distance);
        const Nearest found = d.nearest(p);
        ASSERT_DOUBLE_EQ(found.distance, best);
        ASSERT_NEAR(distance(found.at, p), best, 1e-12);
        const double to_ball = distance(p, {1, 2, 3}) - 4,
                     to_rod = std::max({std::hypot(p.x - 9, p.y - 2) - 1.5, -p.z, p.z - 6});
        if (std::min(to_ball, to_rod) < -0.1 || std::min(to_ball, to_rod) > 0.1) {
            ASSERT_EQ(d.signed_distance(p) < 0, std::min(to_ball, to_rod) < 0);
        }
    }
}

TEST(DistanceTo, a_triangle_is_least_among_its_points) {
    std::mt19937 random(3);
    std::uniform_real_distribution<double> coordinate(-1, 1);
    const auto any = [&] { return Vec3{coordinate(random), coordinate(random), coordinate(random)}; };
    for (int i = 0; i < 300; ++i) {
        std::array<Vec3, 3> c{any(), any(), any()};
        if (i % 10 == 0) c[2] = 0.5 * (c[0] + c[1]);
        if (i % 15 == 0) c[1] = c[0];
        const Vec3 p = any();
        const Nearest found = nearest_on_triangle(p, c);
        double least = 1e9;
        for (int a = 0; a <= 60; ++a)
            for (int b = 0; a + b <= 60; ++b) {
                const Vec3 q = (1.0 / 60) * (a * c[0] + b * c[1] + (60 - a - b) * c[2]);
                least = std::min(least, distance(p, q));
            }
        EXPECT_LE(found.distance, least + 1e-12) << i;
        EXPECT_GE(found.distance, least - 0.05) << i;
        EXPECT_NEAR(distance(found.at, p), found.distance, 1e-12) << i;
    }
}

TEST(DistanceTo, what_is_out_of_reach_or_not_there_is_infinite) {
    const Distance d(box({0, 0, 0}, {1, 1, 1})), nothing{Mesh{}};
    EXPECT_TRUE(std::isinf(d.signed_distance({3, 0, 0}, 1.9)));
    EXPECT_DOUBLE_EQ(d.signed_distance({3, 0.5, 0.5}, 2.1), 2);
    EXPECT_TRUE(std::isinf(nothing.signed_distance({0, 0, 0})));
    EXPECT_TRUE(std::isinf(d.nearest({std::nan(""), 0, 0}).distance));
}

}  // namespace
}  // namespace obrys::mesh
