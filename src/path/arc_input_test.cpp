#include "path/arc_input.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include <cmath>

#include "path/path_testing.hpp"

namespace obrys::path::test {
namespace {

constexpr Sense ccw = Sense::counter_clockwise, cw = Sense::clockwise;

TEST(arc_input, ByCentre) {
    EXPECT_NEAR(arc_by_centre({10, 0}, {0, 10}, {0, 0}, ccw).sweep, pi / 2, 1e-12);
    EXPECT_NEAR(arc_by_centre({10, 0}, {0, 10}, {0, 0}, cw).sweep, -1.5 * pi, 1e-12);
    EXPECT_NEAR(arc_by_centre({10, 0}, {10, 0}, {0, 0}, ccw).sweep, 2 * pi, 1e-12) << "a full circle";
    EXPECT_NEAR(arc_by_centre({10, 0}, {10, 0}, {0, 0}, cw, 2).sweep, -6 * pi, 1e-12) << "TURN=2";
    EXPECT_EQ(arc_by_centre({10, 0}, {0, 10}, {10, 0}, ccw).failure, ArcFailure::no_radius);
}

TEST(arc_input, RadiusDifference) {
    const ArcResult wrong = arc_by_centre({10, 0}, {0, 11}, {0, 0}, ccw);
    EXPECT_EQ(wrong.failure, ArcFailure::radius_mismatch);
    EXPECT_NEAR(wrong.radius_difference, 1, 1e-12);
    const ArcResult near = arc_by_centre({10, 0}, {0, 10.004}, {0, 0}, ccw);
    ASSERT_TRUE(near.ok());
    EXPECT_NEAR(near.radius_difference, 0.004, 1e-12);
    EXPECT_NEAR(geom::distance(near.centre, {10, 0}), geom::distance(near.centre, {0, 10.004}), 1e-9);
    EXPECT_LT(geom::distance(near.centre, {0, 0}), 0.004);
    const ArcTolerance strict{.absolute = 0.001, .relative = 0};
    EXPECT_EQ(arc_by_centre({10, 0}, {0, 10.004}, {0, 0}, ccw, 0, strict).failure, ArcFailure::radius_mismatch);
    EXPECT_TRUE(arc_by_centre({1000, 0}, {0, 1000.9}, {0, 0}, ccw).ok()) << "relative tolerance";
}

TEST(arc_input, ByRadius) {
    const ArcResult small = arc_by_radius({10, 0}, {0, 10}, 10, ccw);
    expect_near(small.centre, {0, 0});
    EXPECT_NEAR(small.sweep, pi / 2, 1e-12);
    const ArcResult large = arc_by_radius({10, 0}, {0, 10}, -10, ccw);
    expect_near(large.centre, {10, 10});
    EXPECT_NEAR(large.sweep, 1.5 * pi, 1e-12);
    expect_near(arc_by_radius({10, 0}, {0, 10}, 10, cw).centre, {10, 10});
    EXPECT_NEAR(arc_by_radius({-5, 0}, {5, 0}, 5, cw).sweep, -pi, 1e-12);
    EXPECT_NEAR(arc_by_radius({-5, 0}, {5, 0}, -5, ccw).sweep, pi, 1e-12);
    EXPECT_NEAR(arc_by_radius({-5, 0}, {5, 0}, 4.995, ccw).sweep, pi, 1e-12) << "within the tolerance";
    EXPECT_EQ(arc_by_radius({-5, 0}, {5, 0}, 4, ccw).failure, ArcFailure::radius_too_small);
    EXPECT_EQ(arc_by_radius({5, 0}, {5, 0}, 4, ccw).failure, ArcFailure::points_coincide);
    EXPECT_EQ(arc_by_radius({-5, 0}, {5, 0}, std::nan(""), ccw).failure, ArcFailure::radius_too_small);
}

TEST(arc_input, ByAngle) {
    const ArcResult r = arc_by_angle({10, 0}, {0, 10}, pi / 2, ccw);
    expect_near(r.centre, {0, 0});
    EXPECT_NEAR(arc_by_angle({10, 0}, {0, 10}, 1.5 * pi, ccw).centre.x, 10, 1e-9);
    expect_near(arc_about_centre({10, 0}, {0, 0}, pi / 2, cw).to, {0, -10});
    expect_near(arc_about_centre({10, 0}, {0, 0}, 2 * pi, cw).to, {10, 0}, 0);
    EXPECT_EQ(arc_by_angle({10, 0}, {0, 10}, 0, ccw).failure, ArcFailure::bad_angle);
    EXPECT_EQ(arc_by_angle({10, 0}, {10, 0}, 1, ccw).failure, ArcFailure::points_coincide);
    EXPECT_EQ(arc_about_centre({1, 1}, {1, 1}, 1, ccw).failure, ArcFailure::no_radius);
}

TEST(arc_input, ByTangent) {
    const ArcResult r = arc_by_tangent({0, 0}, {10, 10}, {3, 0});
    ASSERT_TRUE(r.ok());
    expect_near(r.centre, {0, 10});
    EXPECT_NEAR(r.sweep, pi / 2, 1e-12);
    EXPECT_NEAR(arc_by_tangent({0, 0}, {-10, -10}, {1, 0}).sweep, -1.5 * pi, 1e-12);
    EXPECT_EQ(arc_by_tangent({0, 0}, {10, 0}, {1, 0}).failure, ArcFailure::collinear);
    EXPECT_EQ(arc_by_tangent({0, 0}, {-10, 0}, {1, 0}).failure, ArcFailure::collinear);
    EXPECT_EQ(arc_by_tangent({0, 0}, {10, 0}, {0, 0}).failure, ArcFailure::no_direction);
    EXPECT_EQ(arc_by_tangent({1, 0}, {1, 0}, {1, 0}).failure, ArcFailure::points_coincide);
}

TEST(arc_input, ThroughAPoint) {
    const ArcInSpace r = arc_through({10, 0, 5}, {0, 10, 5}, {-10, 0, 5});
    ASSERT_TRUE(r.ok());
    EXPECT_NEAR(geom::distance(r.centre, {0, 0, 5}), 0, 1e-9);
    EXPECT_NEAR(r.normal.z, 1, 1e-12);
    EXPECT_NEAR(r.sweep, pi, 1e-12);
    const ArcInSpace back = arc_through({10, 0, 5}, {0, -10, 5}, {0, 10, 5});
    EXPECT_NEAR(back.normal.z, -1, 1e-12);
    EXPECT_NEAR(back.sweep, 1.5 * pi, 1e-12);
    EXPECT_EQ(arc_through({0, 0, 0}, {1, 0, 0}, {2, 0, 0}).failure, ArcFailure::collinear);
    EXPECT_EQ(arc_through({0, 0, 0}, {0, 0, 0}, {2, 0, 0}).failure, ArcFailure::points_coincide);
    EXPECT_NEAR(arc_through({0, 0, 0}, {4, 0, 0}, {0, 0, 0}).centre.x, 2, 1e-12);
}

/// A random arc, told in every way, is found again.
RC_GTEST_PROP(arc_input, EveryDefinitionFindsTheSameArc, (std::uint32_t seed)) {
    Random random(seed);
    for (int i = 0; i < 100; ++i) {
        const Vec2 centre{random.in(-50, 50), random.in(-50, 50)};
        const Vec2 from = centre + random.in(1, 100) * rotated({1, 0}, random.in(-4, 4));
        const double sweep = random.in(0.2, 6) * (random.upto(1) == 0 ? 1 : -1);
        const Element e = arc(from, centre, sweep);
        const double radius = geom::distance(from, centre);
        const Sense sense = sweep > 0 ? ccw : cw;
        const auto same = [&](const ArcResult& r) {
            RC_ASSERT(r.ok());
            RC_ASSERT(geom::distance(r.centre, centre) < 1e-7);
            RC_ASSERT(geom::distance(r.to, e.to) < 1e-9);
            RC_ASSERT(std::abs(r.sweep - sweep) < 1e-7);
        };
        same(arc_by_centre(from, e.to, centre, sense));
        if (std::abs(std::abs(sweep) - pi) > 0.1)
            same(arc_by_radius(from, e.to, std::abs(sweep) > pi ? -radius : radius, sense));
        same(arc_by_angle(from, e.to, std::abs(sweep), sense));
        same(arc_about_centre(from, centre, std::abs(sweep), sense));
        same(arc_by_tangent(from, e.to, start_direction(e)));
        const Vec2 via = point_at(e, random.in(0.1, 0.9));
        const ArcInSpace s = arc_through({from.x, from.y, 3}, {via.x, via.y, 3}, {e.to.x, e.to.y, 3});
        RC_ASSERT(geom::distance(s.centre, {centre.x, centre.y, 3}) < 1e-6);
        RC_ASSERT(std::abs(s.sweep * s.normal.z - sweep) < 1e-6);
    }
}

}  // namespace
}  // namespace obrys::path::test
