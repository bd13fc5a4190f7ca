#include <gtest/gtest.h>

#include <cmath>

#include "path/compensation/compensation_testing.hpp"

namespace obrys::path::test {
namespace {

/// The contour runs along +x from the origin; the tool of radius 2 is left of it, i.e. above.
const std::vector<Element> ray{line({0, 0}, {50, 0})};

Setting kont(OuterCorner corner) {
    Setting s = left(2);
    s.approach = Approach::around;
    s.corner = corner;
    return s;
}

TEST(approach, NormGoesToTheNormalPointFromEverywhere) {
    for (const Vec2 from : {Vec2{-10, 0}, Vec2{-10, 7}, Vec2{0, 9}, Vec2{10, 9}, Vec2{0, -9}, Vec2{8, -3}}) {
        const Result r = run(contour_steps(from, ray, left(2)));
        ASSERT_EQ(r.out.size(), 2u);
        EXPECT_NEAR(geom::distance(r.out[0].element.to, {0, 2}), 0, 1e-12);
    }
}

TEST(approach, KontInFrontOfTheContourIsNorm) {
    for (const Vec2 from : {Vec2{-10, 0}, Vec2{-10, 7}, Vec2{0, 9}, Vec2{10, 9}}) {
        const Result r = run(contour_steps(from, ray, kont(OuterCorner::arc)));
        ASSERT_EQ(r.out.size(), 2u) << from.x << ' ' << from.y;
        EXPECT_NEAR(geom::distance(r.out[0].element.to, {0, 2}), 0, 1e-12);
    }
}

TEST(approach, KontBehindGoesRoundTheStartPoint) {
    const Result below = run(contour_steps({-2, -10}, ray, kont(OuterCorner::arc)));
    ASSERT_EQ(below.out.size(), 3u);
    // The vertical through (-2, -10) touches the circle about the origin at (-2, 0).
    EXPECT_NEAR(geom::distance(below.out[0].element.to, {-2, 0}), 0, 1e-9);
    EXPECT_EQ(below.out[1].kind, Kind::transition);
    EXPECT_NEAR(below.out[1].element.sweep, -geom::pi / 2, 1e-9);
    EXPECT_NEAR(geom::distance(below.out[1].element.to, {0, 2}), 0, 1e-9);
    for (const Vec2 from : {Vec2{-10, -1}, Vec2{-1, -3}, Vec2{5, -5}, Vec2{20, -1}, Vec2{20, -0.1}}) {
        const Result r = run(contour_steps(from, ray, kont(OuterCorner::arc)));
        ASSERT_EQ(r.out.size(), 3u);
        EXPECT_LT(r.out[1].element.sweep, 0) << "round the point clockwise, the tool is left";
        EXPECT_GE(distance_to({r.out[0].element}, {0, 0}), 2 - 1e-9) << "the straight part keeps clear of the point";
        EXPECT_LE(largest_gap(r), 1e-9);
        const Element& a = r.out[1].element;
        EXPECT_NEAR(geom::distance(a.to, a.centre + rotated(a.from - a.centre, a.sweep)), 0, 1e-9);
        EXPECT_NEAR(turn_between(end_direction(r.out[0].element), start_direction(a)), 0, 1e-9);
    }
}

TEST(approach, KontWithIntersection) {
    const Result r = run(contour_steps({-2, -10}, ray, kont(OuterCorner::intersection)));
    ASSERT_EQ(r.out.size(), 2u);
    EXPECT_NEAR(geom::distance(r.out[0].element.to, {-2, 2}), 0, 1e-9);
    EXPECT_NEAR(geom::distance(r.out[1].element.from, {-2, 2}), 0, 1e-9);
    const Result far = run(contour_steps({20, -1}, ray, kont(OuterCorner::intersection)));
    EXPECT_EQ(far.out.size(), 3u) << "beyond the corner limit: by an arc";
}

TEST(approach, KontRetractMirrorsTheApproach) {
    for (const auto corner : {OuterCorner::arc, OuterCorner::intersection})
        for (const Vec2 off : {Vec2{2, -10}, Vec2{10, -1}, Vec2{-5, -5}, Vec2{3, 8}, Vec2{9, 0}}) {
            const Setting s = kont(corner);
            Setting end = s;
            end.side = Side::off;
            std::vector<Step> steps{
                {line({-90, 2}, {-50, 0}), s}, {line({-50, 0}, {0, 0}), s}, {line({0, 0}, off), end}};
            const Result out = run(steps);
            Setting other = s;
            other.side = Side::right;
            const Result in = run(contour_steps(off, {line({0, 0}, {-50, 0})}, other));
            ASSERT_EQ(out.out.size(), in.out.size() + 1) << off.x << ' ' << off.y;
            for (std::size_t i = 0; i < in.out.size(); ++i) {
                const Element& a = in.out[i].element;
                const Element& b = out.out[out.out.size() - 1 - i].element;
                EXPECT_NEAR(geom::distance(a.from, b.to), 0, 1e-9);
                EXPECT_NEAR(geom::distance(a.to, b.from), 0, 1e-9);
                EXPECT_NEAR(a.sweep, -b.sweep, 1e-9);
            }
            EXPECT_EQ(out.out.back().kind, Kind::retract);
        }
}

TEST(approach, OntoAnArcAndWithDepthOnTheWay) {
    const std::vector<Element> circle{arc({10, 0}, {0, 0}, geom::pi)};
    auto steps = contour_steps({3, 0}, circle, left(2));
    Element down = line({10, 0}, {10, 0});
    down.w_to = -5;
    steps.insert(steps.begin() + 1, {down, left(2)});
    const Result r = run(steps);
    ASSERT_EQ(r.out.size(), 3u);
    EXPECT_NEAR(geom::distance(r.out[0].element.to, {8, 0}), 0, 1e-12);
    EXPECT_NEAR(geom::distance(r.out[1].element.to, {8, 0}), 0, 1e-12);
    EXPECT_EQ(r.out[1].element.w_to, -5);
    EXPECT_NEAR(geom::distance(r.out[2].element.to, {-8, 0}), 0, 1e-12);
}

}  // namespace
}  // namespace obrys::path::test
