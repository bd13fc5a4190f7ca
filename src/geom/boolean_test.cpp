#include "geom/boolean.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "geom/random_cases_testing.hpp"
#include "geom/random_contours_testing.hpp"

namespace obrys::geom {
namespace {

using testing::disc;
using testing::rectangle;

TEST(Measures, OfRectangleDiscAndHalfDisc) {
    EXPECT_DOUBLE_EQ(area(rectangle(1, 2, 4, 6)), 12);
    EXPECT_DOUBLE_EQ(moment({{rectangle(1, 2, 4, 6)}}), 48);  // 12 mm2, centre at y = 4
    EXPECT_NEAR(volume({{rectangle(0, 2, 5, 3)}}), pi * (9 - 4) * 5, 1e-9);
    EXPECT_NEAR(area(disc(3, 7, 2)), 4 * pi, 1e-12);
    EXPECT_NEAR(volume({{disc(3, 7, 2)}}), 2 * pi * 7 * 4 * pi, 1e-9);  // torus
    const Contour half{{{{-2, 0}}, {{2, 0}, 1}}, true};
    EXPECT_NEAR(area(half), 2 * pi, 1e-12);
    EXPECT_NEAR(volume({{half}}), 4.0 / 3 * pi * 8, 1e-12);  // sphere
    EXPECT_NEAR(length(half), 4 + 2 * pi, 1e-12);
    EXPECT_DOUBLE_EQ(area(reversed(half)), -area(half));
    EXPECT_NEAR(box(half).hi.y, 2, 1e-15);
}

TEST(Boolean, RectanglesSharingAnEdge) {
    const Region a{{rectangle(0, 0, 2, 2)}}, b{{rectangle(2, 0, 5, 2)}};
    const Region both = unite(a, b);
    ASSERT_EQ(both.contours.size(), 1U);
    EXPECT_EQ(both.contours[0].vertices.size(), 4U);  // the seam's corners are gone
    EXPECT_DOUBLE_EQ(area(both), 10);
    EXPECT_TRUE(intersect(a, b).empty());
    EXPECT_EQ(area(subtract(a, b)), 4);
}

TEST(Boolean, DiscInRectangleMakesAHole) {
    const Region r = subtract({{rectangle(0, 0, 10, 10)}}, {{disc(5, 5, 3)}});
    ASSERT_EQ(r.contours.size(), 2U);
    EXPECT_NEAR(area(r), 100 - 9 * pi, 1e-12);
    EXPECT_EQ(pieces(r).size(), 1U);
}

TEST(Boolean, TangentDiscTouchesTheEdge) {
    for (const double shift : {-1e-6, -1e-9, -1e-12, 0.0, 1e-12, 1e-9, 1e-6}) {
        const Region slab{{rectangle(-5, -2, 5, 0)}}, round{{disc(0, 1 + shift, 1)}};
        EXPECT_NEAR(area(unite(slab, round)), 20 + pi, 1e-8) << shift;
        EXPECT_NEAR(area(intersect(slab, round)), 0, 1e-8) << shift;
        EXPECT_NEAR(area(subtract(slab, round)), 20, 1e-8) << shift;
    }
}

TEST(Boolean, CornersThatTouchStayTwoPieces) {
    const Region r = unite({{rectangle(0, 0, 1, 1)}}, {{rectangle(1, 1, 2, 2)}});
    EXPECT_EQ(r.contours.size(), 2U);
    EXPECT_EQ(pieces(r).size(), 2U);
    EXPECT_DOUBLE_EQ(area(r), 2);
}

TEST(Boolean, SameRegionShiftedALittle) {
    const Region a{{disc(3, 4, 2)}};
    for (double shift = 1e-13; shift < 1e-5; shift *= 3) {
        const Region b{{moved(a.contours[0], {shift, 0.7 * shift})}};
        EXPECT_NEAR(area(unite(a, b)) + area(intersect(a, b)), 8 * pi, 2e-8) << shift;
        EXPECT_NEAR(area(subtract(a, b)), 0, 8 * shift + 2e-8) << shift;
    }
}

using testing::free_point;
using testing::lattice_loop;
using testing::lattice_region;

RC_GTEST_PROP(BooleanProperty, AreasOfUnionAndIntersectionAddUp, ()) {
    const Region a = *lattice_region(6), b = *lattice_region(6);
    const double whole = area(a) + area(b);
    RC_ASSERT(std::abs(area(unite(a, b)) + area(intersect(a, b)) - whole) < 1e-7);
    RC_ASSERT(std::abs(area(subtract(a, b)) + area(intersect(a, b)) - area(a)) < 1e-7);
}

RC_GTEST_PROP(BooleanProperty, MembershipIsThatOfTheDrawnLoops, ()) {
    const Contour x = *lattice_loop(6), y = *lattice_loop(6);
    const Region a = tidied({x}), b = tidied({y});
    const Region u = unite(a, b), i = intersect(a, b), d = subtract(a, b);
    for (int k = 0; k < 50; ++k) {
        const Vec2 p = *free_point(6);
        if (distance(Region{{x, y}}, p) < 1e-6) continue;
        const bool in_a = winding(edges(x), p) % 2 != 0, in_b = winding(edges(y), p) % 2 != 0;
        RC_ASSERT(contains(a, p) == in_a);
        RC_ASSERT(contains(u, p) == (in_a || in_b));
        RC_ASSERT(contains(i, p) == (in_a && in_b));
        RC_ASSERT(contains(d, p) == (in_a && !in_b));
    }
}

RC_GTEST_PROP(BooleanProperty, RigidMotionOfInputIsRigidMotionOfResult, ()) {
    const Region a = *lattice_region(6), b = *lattice_region(6);
    const double w = *rc::gen::inRange(0, 628) / 100.0, c = std::cos(w), s = std::sin(w);
    const auto turned = [&](Region r) {
        for (Contour& k : r.contours)
            for (Vertex& v : k.vertices) v.p = {c * v.p.x - s * v.p.y + 100, s * v.p.x + c * v.p.y + 50};
        return r;
    };
    RC_ASSERT(std::abs(area(subtract(turned(a), turned(b))) - area(subtract(a, b))) < 1e-7);
    RC_ASSERT(std::abs(area(unite(turned(a), turned(b))) - area(unite(a, b))) < 1e-7);
}

RC_GTEST_PROP(BooleanProperty, ShiftedByLessThanNothingChangesNothing, ()) {
    const Region a = *lattice_region(6);
    Region b = *lattice_region(6);
    const double plain = area(subtract(a, b));
    const double by = *rc::gen::element(1e-13, 1e-12, 1e-11, 1e-10, 5e-10, 1e-9, 2e-9, 1e-8, 1e-7);
    for (Contour& k : b.contours) k = moved(k, {by, -0.3 * by});
    RC_ASSERT(std::abs(area(subtract(a, b)) - plain) < 200 * by + 1e-7);
}

}  // namespace
}  // namespace obrys::geom
