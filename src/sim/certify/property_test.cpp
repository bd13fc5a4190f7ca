/// What holds of every body and tool: nothing is deeper than what is certified, wherever and however all of it stands.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "sim/certify/certify_testing.hpp"
#include "sim/certify/closest.hpp"

namespace obrys::sim::certify {
namespace {

using namespace testing;

/// The deepest of many points of the tool on its way: never deeper than what is certified.
double sampled(const Case& c, const mesh::Distance& part, Random& random, int points) {
    double deepest = 0;
    for (int i = 0; i < points; ++i) {
        const Swept whole{c.tool[static_cast<std::size_t>(random.below(static_cast<int>(c.tool.size())))], c.from,
                          c.to - c.from, c.axis};
        const mesh::Box box = box_of(whole);
        const Vec3 p{random.between(box.lo.x, box.hi.x), random.between(box.lo.y, box.hi.y),
                     random.between(box.lo.z, box.hi.z)};
        deepest = std::max(deepest, -part.signed_distance(nearest_within(whole, p)));
    }
    return deepest;
}

TEST(Certified, no_point_of_the_tool_is_deeper_than_what_is_certified) {
    constexpr double allowed = 0.01;
    for (unsigned number = 1; number <= 300; ++number) {
        Random random(number);
        const Case c = random_case(random);
        const mesh::Distance part(c.part);
        const Judge judge(part, allowed);
        const double d = depth_of(judge, c.tool, c.from, c.to, c.axis);
        const double found = sampled(c, part, random, 2000);
        EXPECT_LE(found, std::max(d, allowed) + allowed / 10 + 0.02 * found) << "case " << number;
    }
}

TEST(Certified, depth_grows_with_the_radius_and_does_not_change_when_all_is_moved_and_turned) {
    constexpr double allowed = 0.01;
    for (unsigned number = 1; number <= 100; ++number) {
        Random random(number);
        Case c = random_case(random);
        const double r = random.between(1, 4);
        const mesh::Distance part(c.part);
        const Judge judge(part, allowed);
        const double small = depth_of(judge, end_mill(r, 20), c.from, c.to, c.axis);
        const double large = depth_of(judge, end_mill(r * 1.1, 20), c.from, c.to, c.axis);
        if (large < 1) {
            EXPECT_LE(small, std::max(large, allowed) + allowed / 5) << "case " << number;
        }
        const geom::Frame turn = geom::Frame::shift({1000, -20, 7}) * geom::Frame::rotation(0, random.between(-3, 3)) *
                                 geom::Frame::rotation(2, random.between(-3, 3));
        const mesh::Distance turned_part(transformed(c.part, turn));
        const Judge turned(turned_part, allowed);
        const double there =
            depth_of(turned, end_mill(r, 20), apply(turn, c.from), apply(turn, c.to), apply_direction(turn, c.axis));
        if (small > allowed && small < 1) {
            EXPECT_NEAR(there, small, allowed / 5 + 0.01 * small) << "case " << number;
        }
    }
}

/// What proofs rest on, whichever way the corners are moved.
TEST(Certified, a_smaller_body_grown_by_the_depth_covers_the_body) {
    for (unsigned number = 1; number <= 400; ++number) {
        Random random(number);
        const auto radius = [&] { return random.below(3) == 0 ? 0.0 : random.between(0, 5); };
        const Body body{radius(), 0, radius(), random.between(0, 1) * random.between(0, 1) * 20,
                        random.below(2) == 0 ? 0.0 : random.between(0, 1)};
        const double depth = random.between(0.001, 2);
        for (const Inwards how : all_ways) {
            const Body inner = shrunk(body, depth, how);
            EXPECT_GE(inner.rounding, 0);
            for (int i = 0; i < 50; ++i) {
                const Vec3 u = direction(random);
                // The farthest point of the body that way, and all of it: convex bodies with support functions.
                const Vec3 at = support({body, {}, {}, {0, 0, 1}}, u) + body.rounding * u;
                const Vec3 near = nearest_within({inner, {}, {}, {0, 0, 1}}, at);
                ASSERT_LE(geom::distance(at, near), depth * (1 + 1e-9))
                    << "case " << number << " way " << static_cast<int>(how) << " body " << body.r0 << ' ' << body.r1
                    << ' ' << body.z1 << ' ' << body.rounding << " inner " << inner.r0 << ' ' << inner.z0 << ' '
                    << inner.r1 << ' ' << inner.z1 << ' ' << inner.rounding << " at " << at.x << ' ' << at.y << ' '
                    << at.z;
            }
        }
    }
}

/// In a corner the floor may lie at most of the depth and the wall at some of it: there is a way that is off both.
TEST(Certified, a_rim_moves_inwards_in_every_direction) {
    constexpr double depth = 0.01, share = 0.8;
    const Body mill{5, 0, 5, 20, 0};
    for (double angle = 0; angle <= 90; angle += 1) {
        const double up = share * depth * std::cos(geom::radians(angle)),
                     in = share * depth * std::sin(geom::radians(angle));
        EXPECT_TRUE(std::any_of(all_ways.begin(), all_ways.end(), [&](Inwards how) {
            const Body b = shrunk(mill, depth, how);
            return b.z0 - b.rounding >= up && mill.r0 - (b.r0 + b.rounding) >= in;
        })) << angle;
    }
}

TEST(Certified, closest_agrees_with_a_search) {
    for (unsigned number = 1; number <= 200; ++number) {
        Random random(number);
        const Case c = random_case(random);
        const Swept whole{c.tool.front(), c.from, c.to - c.from, c.axis};
        const Vec3 p = 20.0 * direction(random);
        const Apart apart = closest(whole, {&p, 1}, to_the_end);
        EXPECT_NEAR(apart.upper, whole.body.rounding + geom::distance(p, nearest_within(whole, p)), 1e-5)
            << "case " << number;
        EXPECT_LE(apart.lower, apart.upper * (1 + 1e-12));
    }
}

}  // namespace
}  // namespace obrys::sim::certify
