#include "mesh/mesh.hpp"

#include <gtest/gtest.h>

#include "mesh/primitives.hpp"
#include "mesh/topology.hpp"
#include "mesh/weld.hpp"

namespace obrys::mesh {
namespace {

using geom::Frame;
using geom::Vec3;

TEST(Measures, of_a_box) {
    const Mesh m = box({1, 2, 3}, {4, 6, 8});
    EXPECT_DOUBLE_EQ(volume(m), 60);
    EXPECT_DOUBLE_EQ(area(m), 2 * (12 + 15 + 20));
    EXPECT_EQ(bounds(m).lo, (Vec3{1, 2, 3}));
    EXPECT_EQ(bounds(m).hi, (Vec3{4, 6, 8}));
    EXPECT_TRUE(topology(m).closed());
    EXPECT_EQ(topology(m).edges, 18U);
    EXPECT_TRUE(box({0, 0, 0}, {1, 0, 1}).empty());
}

TEST(Measures, of_round_bodies_follow_from_their_sides) {
    const int n = 60;
    const Mesh c = cylinder({5, -3, 2}, 4, 7, n);
    // The regular polygon: n/2 r² sin(2π/n).
    const double base = n / 2.0 * 16 * std::sin(2 * geom::pi / n);
    EXPECT_NEAR(volume(c), base * 7, 1e-9);
    EXPECT_NEAR(area(c), 2 * base + 7 * n * 8 * std::sin(geom::pi / n), 1e-9);
    EXPECT_TRUE(topology(c).closed());
    const Mesh b = ball({0, 0, 100}, 3, 200);
    EXPECT_NEAR(volume(b), 4.0 / 3 * geom::pi * 27, 0.1);
    EXPECT_LT(volume(b), 4.0 / 3 * geom::pi * 27);
    EXPECT_TRUE(topology(b).closed());
}

TEST(Measures, sides_of_a_circle_hold_their_tolerance) {
    for (const double r : {0.5, 3.0, 50.0}) {
        const int n = circle_sides(r, 0.01);
        EXPECT_LE(r * (1 - std::cos(geom::pi / n)), 0.0100001) << r;
        if (n > 8) {
            EXPECT_GT(r * (1 - std::cos(geom::pi / (n - 1))), 0.01) << r;
        }
    }
    EXPECT_EQ(circle_sides(1, 0), 8);
    EXPECT_EQ(circle_sides(1e9, 1e-9), 4096);
}

TEST(Measures, of_a_moved_mesh_stay) {
    const Mesh m = cylinder({5, -3, 2}, 4, 7, 12);
    const Frame moved = Frame::shift({100, 20, -7}) * Frame::rotation(0, 0.7) * Frame::rotation(2, -2.1);
    EXPECT_NEAR(volume(transformed(m, moved)), volume(m), 1e-9);
    const Frame mirrored = Frame::scaling({-1, 1, 1});
    EXPECT_NEAR(volume(transformed(m, mirrored)), volume(m), 1e-9) << "outside stays outside";
    EXPECT_NEAR(volume(transformed(m, Frame::scaling({2, 2, 2}))), 8 * volume(m), 1e-9);
}

TEST(Measures, far_from_the_origin_lose_no_digits) {
    const Mesh m = box({1e6, 1e6, 1e6}, {1e6 + 1, 1e6 + 1, 1e6 + 1});
    EXPECT_NEAR(volume(m), 1, 1e-9);
}

TEST(Append, keeps_tags_by_triangle) {
    Mesh m = box({0, 0, 0}, {1, 1, 1}), other = box({2, 0, 0}, {3, 1, 1});
    other.tags.assign(12, 7);
    append(m, other);
    ASSERT_EQ(m.tags.size(), m.triangles.size());
    EXPECT_EQ(m.tag(11), 0U);
    EXPECT_EQ(m.tag(12), 7U);
    EXPECT_DOUBLE_EQ(volume(m), 2);
    EXPECT_TRUE(topology(m).closed());
}

TEST(TopologyOf, a_box_without_a_triangle_is_open) {
    Mesh m = box({0, 0, 0}, {1, 1, 1});
    m.triangles.erase(m.triangles.begin() + 3);  // 4 7 6: the far corner of the top
    const Topology t = topology(m);
    EXPECT_EQ(t.open.count, 3U);
    EXPECT_EQ(t.crowded.count + t.turned.count, 0U);
    EXPECT_EQ(t.open.triangle, 2U);
    EXPECT_EQ(t.open.from.z, 1);
    EXPECT_FALSE(t.closed());
}

TEST(TopologyOf, a_turned_triangle_is_told_by_its_three_edges) {
    Mesh m = box({0, 0, 0}, {1, 1, 1});
    std::swap(m.triangles[5][0], m.triangles[5][1]);
    EXPECT_EQ(topology(m).turned.count, 3U);
    EXPECT_EQ(topology(m).open.count, 0U);
}

TEST(TopologyOf, two_boxes_on_one_edge_crowd_it) {
    Mesh m = box({0, 0, 0}, {1, 1, 1});
    append(m, box({1, 1, 0}, {2, 2, 1}));
    Welder welder;
    for (Triangle& t : m.triangles)
        for (std::uint32_t& v : t) v = welder.add(m.vertices[v]);
    m.vertices = welder.take();
    EXPECT_EQ(m.vertices.size(), 14U);
    const Topology t = topology(m);
    EXPECT_EQ(t.crowded.count, 1U);
    EXPECT_EQ(t.crowded.from.x, 1);
    EXPECT_EQ(t.crowded.to.y, 1);
}

TEST(Welding, joins_within_the_tolerance_only) {
    Welder exact;
    EXPECT_EQ(exact.add({0.0, 0, 0}), exact.add({-0.0, 0, -0.0}));
    EXPECT_NE(exact.add({1, 0, 0}), exact.add({1 + 1e-15, 0, 0}));
    for (const double shift : {0.0, 0.0009999, -0.0009999, 0.4995, 0.5}) {
        Welder near(0.001);
        const auto first = near.add({shift, shift, shift});
        EXPECT_EQ(near.add({shift + 0.0009, shift, shift}), first) << shift;
        EXPECT_EQ(near.add({shift, shift - 0.0009, shift}), first) << shift;
        EXPECT_NE(near.add({shift + 0.0008, shift + 0.0008, shift}), first) << shift;
    }
}

TEST(Welding, of_many_points_finds_each_again) {
    Welder w;
    for (int round = 0; round < 2; ++round)
        for (int i = 0; i < 20'000; ++i)
            ASSERT_EQ(w.add({i * 0.25, i % 7 * 1.5, -i * 1.0}), static_cast<std::uint32_t>(i));
}

TEST(Primitives, ABoxIsKnownAsOneHoweverItsFacesAreCut) {
    const Vec3 lo{-1, 2, 0.3}, hi{4, 2.5, 7};
    Mesh m = box(lo, hi);
    ASSERT_TRUE(as_box(m));
    EXPECT_EQ(as_box(m)->lo, lo);
    EXPECT_EQ(as_box(m)->hi, hi);
    turn_over(m);
    EXPECT_TRUE(as_box(m)) << "inside out it is the same body";
    // A face in three by a place in its middle.
    Mesh fan = box(lo, hi);
    const Triangle t = fan.triangles[0];
    const auto middle = static_cast<std::uint32_t>(fan.vertices.size());
    fan.vertices.push_back({1, 2.2, 0.3});
    fan.triangles[0] = {t[0], t[1], middle};
    fan.triangles.push_back({t[1], t[2], middle});
    fan.triangles.push_back({t[2], t[0], middle});
    EXPECT_TRUE(as_box(fan));
    fan.vertices[middle].z = 0.4;
    EXPECT_FALSE(as_box(fan)) << "a dent";
    Mesh open = box(lo, hi);
    open.triangles.pop_back();
    EXPECT_FALSE(as_box(open));
    EXPECT_FALSE(as_box(cylinder({0, 0, 0}, 3, 5, 16)));
    EXPECT_FALSE(as_box(Mesh{}));
}

}  // namespace
}  // namespace obrys::mesh
