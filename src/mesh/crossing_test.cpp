#include "mesh/crossing.hpp"

#include <gtest/gtest.h>

#include "mesh/primitives.hpp"

namespace obrys::mesh {
namespace {

using geom::Vec3;

/// Two blocks of 10 mm, the second one beside the first by so much; turned, so that nothing lies along an axis.
Distance blocks(double apart, double turn) {
    Mesh m = box({0, 0, 0}, {10, 10, 10});
    append(m, box({10 + apart, 3, 3}, {20 + apart, 7, 7}));
    return Distance(transformed(m, geom::Frame::rotation(0, turn) * geom::Frame::rotation(2, 2 * turn)));
}

TEST(SelfCrossing, bodies_that_overlap_cross_and_those_that_touch_do_not) {
    for (const double turn : {0.0, 0.3}) {
        EXPECT_FALSE(self_crossing(blocks(1, turn), 0.01).has_value());
        EXPECT_FALSE(self_crossing(blocks(0, turn), 0.01).has_value());
        EXPECT_FALSE(self_crossing(blocks(-0.009, turn), 0.01).has_value());
        EXPECT_TRUE(self_crossing(blocks(-0.02, turn), 0.01).has_value()) << turn;
    }
}

TEST(SelfCrossing, round_bodies_of_small_triangles_cross_in_the_first_place) {
    for (const int corners : {24, 200}) {
        Mesh m = ball({0, 0, 0}, 4, corners);
        EXPECT_FALSE(self_crossing(Distance(m), 0.01).has_value());
        append(m, cylinder({3, 0, 0}, 0.5, 6, 24));
        const auto found = self_crossing(Distance(m), 0.01);
        ASSERT_TRUE(found.has_value());
        // Where the rod leaves the ball.
        EXPECT_NEAR(length(*found), 4, 0.1);
        EXPECT_NEAR(std::hypot(found->x - 3, found->y), 0.5, 0.1);
    }
}

// One upper corner of a block lies below its lower face.
TEST(SelfCrossing, a_block_that_is_turned_through_itself_crosses) {
    Mesh m = box({0, 0, 0}, {10, 10, 10});
    EXPECT_FALSE(self_crossing(Distance(m), 0.01).has_value());
    for (Vec3& v : m.vertices)
        if (v == Vec3{10, 10, 10}) v = {4, 4, -3};
    EXPECT_TRUE(self_crossing(Distance(m), 0.01).has_value());
    // The same at an edge: all sides that cross lie in one plane.
    m = box({0, 0, 0}, {10, 10, 10});
    for (Vec3& v : m.vertices)
        if (v == Vec3{10, 10, 10}) v = {10, 10, -2};
    EXPECT_TRUE(self_crossing(Distance(m), 0.01).has_value());
}

}  // namespace
}  // namespace obrys::mesh
