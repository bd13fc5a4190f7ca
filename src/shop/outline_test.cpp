#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <tuple>

#include "shop/contour_check.hpp"
#include "shop/tool.hpp"

namespace obrys::shop {
namespace {

using geom::pi;
using geom::Vec2;

struct Box {
    double z0, z1, x0, x1;
    bool operator==(const Box&) const = default;
};

/// Extent of the corners: for a blade with rounded corners the same as that of the outline.
Box box(const geom::Contour& c) {
    Box b{1e9, -1e9, 1e9, -1e9};
    for (const geom::Vertex& v : c.vertices)
        b = {std::min(b.z0, v.p.x), std::max(b.z1, v.p.x), std::min(b.x0, v.p.y), std::max(b.x1, v.p.y)};
    return b;
}

Tool blade(ReferenceCorner reference, BladeDirection direction, double left = 0, double right = 0) {
    Tool t;
    t.kind = ToolKind::groove;
    t.width = 3;
    t.corner_radius_left = left;
    t.corner_radius_right = right;
    t.reference = reference;
    t.direction = direction;
    t.cutting_depth = 10;
    return t;
}

TEST(Outline, BladesLieWhereTheirReferenceAndDirectionSay) {
    using enum ReferenceCorner;
    using enum BladeDirection;
    EXPECT_EQ(box(outline(blade(left, out))), (Box{0, 3, 0, 10}));
    EXPECT_EQ(box(outline(blade(right, out))), (Box{-3, 0, 0, 10}));
    EXPECT_EQ(box(outline(blade(left, in))), (Box{0, 3, -10, 0}));
    EXPECT_EQ(box(outline(blade(right, in))), (Box{-3, 0, -10, 0}));
    EXPECT_EQ(box(outline(blade(left, face))), (Box{0, 10, 0, 3}));
    EXPECT_EQ(box(outline(blade(right, face))), (Box{0, 10, -3, 0}));
}

TEST(Outline, ASharpBladeIsARectangle) {
    const auto c = outline(blade(ReferenceCorner::left, BladeDirection::out));
    EXPECT_TRUE(c.closed);
    EXPECT_EQ(c.vertices, (std::vector<geom::Vertex>{{{0, 0}, 0}, {{3, 0}, 0}, {{3, 10}, 0}, {{0, 10}, 0}}));
    Tool endless = blade(ReferenceCorner::left, BladeDirection::out);
    endless.cutting_depth = 0;
    EXPECT_EQ(box(outline(endless)).x1, 1000);
}

TEST(Outline, CornerRadiiAreQuarterCirclesAndCounterClockwiseInEveryDirection) {
    const double cut = (1 - pi / 4) * (0.25 + 1);  // what radii 0.5 and 1 take off the corners
    for (const auto reference : {ReferenceCorner::left, ReferenceCorner::right})
        for (const auto direction : {BladeDirection::out, BladeDirection::in, BladeDirection::face}) {
            const auto c = outline(blade(reference, direction, 0.5, 1));
            EXPECT_EQ(c.vertices.size(), 6U);
            EXPECT_NEAR(signed_area(c), 30 - cut, 1e-12);
            EXPECT_FALSE(first_crossing(c));
        }
    const auto c = outline(blade(ReferenceCorner::left, BladeDirection::out, 0.5, 1));
    EXPECT_EQ(c.vertices[0].p, (Vec2{0.5, 0}));
    EXPECT_EQ(c.vertices[1].p, (Vec2{2, 0}));
    EXPECT_NEAR(c.vertices[1].bulge, std::sqrt(2) - 1, 1e-15);
    EXPECT_EQ(c.vertices[2].p, (Vec2{3, 1}));
    const auto round = outline(blade(ReferenceCorner::left, BladeDirection::out, 1.5, 1.5));
    EXPECT_EQ(round.vertices.size(), 5U);
    EXPECT_NEAR(signed_area(round), 30 - (1 - pi / 4) * 2 * 2.25, 1e-12);
}

TEST(Outline, NoShapeWhereDimensionsMakeNone) {
    EXPECT_TRUE(outline(Tool{}).vertices.empty());
    Tool t = blade(ReferenceCorner::left, BladeDirection::out, 2, 2);
    EXPECT_TRUE(outline(t).vertices.empty());
    t.width = 0;
    EXPECT_TRUE(outline(t).vertices.empty());
}

Tool insert(int orientation, double r = 0.8, double tip = 55, double entering = 93) {
    Tool t;
    t.kind = ToolKind::turning;
    t.orientation = orientation;
    t.nose_radius = r;
    t.tip_angle = tip;
    t.entering_angle = orientation >= 5 ? 90 - tip / 2 : entering;
    t.edge_length = 10;
    return t;
}

/// Centre of the only arc.
Vec2 nose_centre(const geom::Contour& c, double r) {
    for (std::size_t i = 0; i < c.vertices.size(); ++i) {
        if (c.vertices[i].bulge == 0) continue;
        const Vec2 a = c.vertices[i].p, b = c.vertices[(i + 1) % c.vertices.size()].p, m = 0.5 * (a + b);
        const double h = std::sqrt(r * r - geom::dot(b - a, b - a) / 4);
        return m + (h / geom::distance(a, b)) * geom::left_of(b - a);
    }
    return {1e9, 1e9};
}

TEST(Outline, TheNoseLiesAsTheOrientationSays) {
    const std::vector<std::tuple<int, double, double>> centres{
        {1, -1, -1}, {2, 1, -1}, {3, 1, 1}, {4, -1, 1}, {5, -1, 0}, {6, 0, -1}, {7, 1, 0}, {8, 0, 1}, {9, 0, 0}};
    for (const auto& [orientation, z, x] : centres) {
        const auto c = outline(insert(orientation));
        const Vec2 centre = nose_centre(c, 0.8);
        EXPECT_NEAR(centre.x, 0.8 * z, 1e-12) << orientation;
        EXPECT_NEAR(centre.y, 0.8 * x, 1e-12) << orientation;
        EXPECT_GT(signed_area(c), 0) << orientation;
        EXPECT_FALSE(first_crossing(c)) << orientation;
        EXPECT_EQ(c.vertices.size(), 4U);
    }
}

TEST(Outline, EdgesOfATurningInsert) {
    // PCLNR: entering angle 95, tip 80: the main edge leans 5 degrees away from a shoulder, the other clears the turned
    // surface by 5 degrees.
    const auto c = outline(insert(3, 0.8, 80, 95)).vertices;
    ASSERT_EQ(c.size(), 4U);
    const Vec2 main = c[0].p - c[1].p, other = c[3].p - c[2].p;
    EXPECT_NEAR(geom::length(main), 10, 1e-12);
    EXPECT_NEAR(geom::length(other), 10, 1e-12);
    EXPECT_NEAR(geom::degrees(std::atan2(main.y, main.x)), 85, 1e-9);
    EXPECT_NEAR(geom::degrees(std::atan2(other.y, other.x)), 5, 1e-9);
    EXPECT_NEAR(4 * std::atan(c[1].bulge), geom::radians(100), 1e-12);
    // the nose touches both axes through the programmed point: no corner lies below or left of it
    EXPECT_GE(box(outline(insert(3, 0.8, 80, 95))).x0, 0);
    EXPECT_GE(box(outline(insert(3, 0.8, 80, 95))).z0, 0);
}

TEST(Outline, ASharpInsertIsATriangleAtTheTip) {
    const auto c = outline(insert(2, 0, 60, 90));
    ASSERT_EQ(c.vertices.size(), 3U);
    EXPECT_NEAR(signed_area(c), 0.5 * 10 * 10 * std::sin(geom::radians(60)), 1e-9);
    EXPECT_TRUE(std::any_of(c.vertices.begin(), c.vertices.end(), [](const geom::Vertex& v) {
        return v.p == Vec2{0, 0};
    }));
    EXPECT_LE(box(c).x1, 0);  // a boring bar reaches towards the axis from the bore's wall
}

TEST(Outline, CentreReferenceTurnsInsideOutWithTheDirection) {
    Tool t = insert(9);
    EXPECT_GT(box(outline(t)).x1, 8);
    t.direction = BladeDirection::in;
    EXPECT_LT(box(outline(t)).x0, -8);
    EXPECT_LT(box(outline(t)).x1, 1);
}

}  // namespace
}  // namespace obrys::shop
