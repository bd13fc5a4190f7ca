#include "path/smooth_approach.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <iostream>
#include <limits>

#include "path/path_testing.hpp"

namespace obrys::path::test {
namespace {

/// The examples of the iTNC 530 manual start at X40 Y10 and go from P_A X10 Y20 to X20 Y35 with RR (LT: from X20 Y20
/// to X35 Y35); tool radius 5 and w 3 are ours.
const OuterEnd manual_start{{40, 10}, 3};
const ContourEnd manual_contour{{10, 20}, {10, 15}, Side::right, 5, -10};
const double diagonal = std::sqrt(325.0);
const Vec2 right_of{15 / diagonal, -10 / diagonal};
const Vec2 centre_at_contour = Vec2{10, 20} + 5 * right_of;

TEST(smooth_approach, ManualExampleLine) {
    const ContourEnd c{{20, 20}, {15, 15}, Side::right, 5, -10};
    const auto r = smooth_approach(manual_start, c, {.kind = SmoothKind::tangent_line, .length = 15});
    ASSERT_TRUE(r.ok());
    const double half = std::sqrt(0.5);
    const Vec2 p_a{20 + 5 * half, 20 - 5 * half}, p_h{p_a.x - 15 * half, p_a.y - 15 * half};
    ASSERT_EQ(r.path.size(), 3u);
    expect_point(r.path[0].from, {40, 10});
    expect_point(r.path[0].to, p_h);
    EXPECT_EQ(r.path[0].w_to, 3) << "in the plane first";
    EXPECT_EQ(r.path[1].w_to, -10) << "then to depth at P_H";
    expect_point(r.path[1].to, p_h);
    expect_point(r.path[2].to, p_a);
    expect_point(r.auxiliary, p_h);
    expect_point(r.contour, p_a);
}

TEST(smooth_approach, ManualExampleNormal) {
    const auto r = smooth_approach(manual_start, manual_contour, {.kind = SmoothKind::normal_line, .length = 15});
    ASSERT_EQ(r.path.size(), 3u);
    expect_point(r.auxiliary, Vec2{10, 20} + 20 * right_of);
    EXPECT_NEAR(geom::distance(r.auxiliary, manual_contour.at), 15 + 5, 1e-12) << "LEN plus tool radius";
    expect_point(r.path[2].to, centre_at_contour);
    EXPECT_FALSE(is_arc(r.path[2]));
}

TEST(smooth_approach, ManualExampleArc) {
    const SmoothShape shape{.kind = SmoothKind::tangent_arc, .radius = 10, .angle = pi};
    const auto r = smooth_approach(manual_start, manual_contour, shape);
    ASSERT_EQ(r.path.size(), 3u);
    // Half a turn clockwise: P_H of the contour is a diameter to the right, and the tool stands inside.
    expect_point(r.path[2].centre, Vec2{10, 20} + 10 * right_of);
    EXPECT_NEAR(r.path[2].sweep, -pi, 1e-12);
    expect_point(r.auxiliary, Vec2{10, 20} + 15 * right_of);
    expect_point(r.path[2].to, centre_at_contour);
    SmoothShape other = shape;
    other.radius = -10;
    const auto from_workpiece = smooth_approach(manual_start, manual_contour, other);
    EXPECT_NEAR(from_workpiece.path[2].sweep, pi, 1e-12);
    expect_point(from_workpiece.path[2].centre, Vec2{10, 20} - 10 * right_of);
    EXPECT_NEAR(geom::distance(from_workpiece.auxiliary, from_workpiece.path[2].centre), 15, 1e-12);
    other = shape;
    other.arc_of = ArcOf::centre;
    expect_point(smooth_approach(manual_start, manual_contour, other).path[2].centre, Vec2{10, 20} + 15 * right_of);
}

TEST(smooth_approach, ManualExampleArcAndLine) {
    const auto r = smooth_approach(manual_start, manual_contour, {.kind = SmoothKind::arc_and_line, .radius = 10});
    ASSERT_EQ(r.path.size(), 3u);
    const Vec2 centre = Vec2{10, 20} + 10 * right_of;
    expect_point(r.path[2].centre, centre);
    EXPECT_LT(r.path[2].sweep, 0);
    expect_point(r.path[2].to, centre_at_contour);
    EXPECT_NEAR(geom::distance(r.auxiliary, centre), 5, 1e-12);
    EXPECT_NEAR(geom::dot(r.auxiliary - manual_start.at, r.auxiliary - centre), 0, 1e-9)
        << "line tangential to the arc";
    const auto together = smooth_approach(manual_start, manual_contour,
                                          {.kind = SmoothKind::arc_and_line, .radius = 10, .w_move = WMove::together});
    ASSERT_EQ(together.path.size(), 2u);
    EXPECT_EQ(together.path[0].w_to, -10);
}

/// Round numbers: contour along +x at the origin, tool 2 on the left, P_S above and behind.
TEST(smooth_approach, ArcAndLineByHand) {
    const ContourEnd c{{0, 0}, {1, 0}, Side::left, 2, 0};
    // Circle of the centre: radius 5 - 2 about (0, 5). One tangent from (-7, 8) is y = 8; the circle is run
    // counter-clockwise, so it is the other one: (0, 8) mirrored at the line to the centre, (7, -3) / sqrt(58).
    const auto r = smooth_approach({{-7, 8}, 0}, c, {.kind = SmoothKind::arc_and_line, .radius = 5});
    ASSERT_EQ(r.path.size(), 2u);
    expect_point(r.auxiliary, {-14 + 686.0 / 58, 8 - 294.0 / 58});
    EXPECT_GT(r.path[1].sweep, 0);
    EXPECT_GT(geom::cross(r.path[0].to - r.path[0].from, r.path[1].centre - r.path[0].from), 0);
    const auto below = smooth_approach({{-12, -10}, 0}, c, {.kind = SmoothKind::arc_and_line, .radius = 5});
    ASSERT_EQ(below.path.size(), 2u);
    expect_point(below.path[1].centre, {0, -5});
    EXPECT_NEAR(geom::distance(below.path[1].from, {0, -5}), 7, 1e-12) << "the tool stands outside of this arc";
    const auto straight = smooth_approach({{-9, 2}, 0}, c, {.kind = SmoothKind::arc_and_line, .radius = 5});
    ASSERT_EQ(straight.path.size(), 1u);
    expect_point(straight.path[0].to, {0, 2});
}

TEST(smooth_departure, ManualExamples) {
    // Contour ends along +y at (50, 20) with RR, tool radius 5: the centre is at (55, 20).
    const ContourEnd end{{50, 20}, {0, 7}, Side::right, 5, -10};
    const auto lt = smooth_departure(end, {{}, -10}, {.kind = SmoothKind::tangent_line, .length = 12.5});
    ASSERT_EQ(lt.path.size(), 1u);
    expect_point(lt.path[0].from, {55, 20});
    expect_point(lt.path[0].to, {55, 32.5});
    const auto ln = smooth_departure(end, {{}, 100}, {.kind = SmoothKind::normal_line, .length = 20});
    ASSERT_EQ(ln.path.size(), 2u);
    expect_point(ln.path[0].to, {75, 20});
    EXPECT_EQ(ln.path[0].w_to, -10);
    EXPECT_EQ(ln.path[1].w_to, 100) << "in the plane first, then along w";
    const auto ct = smooth_departure(end, {{}, -10}, {.kind = SmoothKind::tangent_arc, .radius = 8, .angle = pi});
    ASSERT_EQ(ct.path.size(), 1u);
    expect_point(ct.path[0].centre, {58, 20});
    expect_point(ct.path[0].to, {61, 20});
    EXPECT_NEAR(ct.path[0].sweep, -pi, 1e-12);
    const auto away = smooth_departure(end, {{}, -10}, {.kind = SmoothKind::tangent_arc, .radius = -8, .angle = pi});
    expect_point(away.path[0].to, {55 - 26, 20});
    // P_N to the right at the height of the arc's top: a quarter turn clockwise, then along +x.
    const auto lct = smooth_departure(end, {{90, 23}, -10}, {.kind = SmoothKind::arc_and_line, .radius = 8});
    ASSERT_EQ(lct.path.size(), 2u);
    expect_point(lct.path[0].to, {58, 23});
    EXPECT_NEAR(lct.path[0].sweep, -pi / 2, 1e-12);
    expect_point(lct.path[1].to, {90, 23});
    expect_point(lct.auxiliary, {58, 23});
}

TEST(smooth_departure, WhereTheMotionAlongWTakesPlace) {
    const ContourEnd end{{50, 20}, {0, 7}, Side::right, 5, -10};
    const OuterEnd outer{{90, 23}, 2};
    SmoothShape s{.kind = SmoothKind::arc_and_line, .radius = 8};
    const auto levels = [&](WMove w) {
        s.w_move = w;
        std::vector<double> v;
        for (const Element& e : smooth_departure(end, outer, s).path) v.push_back(e.w_to);
        return v;
    };
    EXPECT_EQ(levels(WMove::at_auxiliary), (std::vector<double>{-10, 2, 2}));
    EXPECT_EQ(levels(WMove::together), (std::vector<double>{-10, 2}));
    EXPECT_EQ(levels(WMove::outside), (std::vector<double>{-10, -10, 2}));
}

TEST(smooth_approach, OffIsRightWithRadiusZero) {
    ContourEnd off = manual_contour, zero = manual_contour;
    off.side = Side::off;
    zero.tool_radius = 0;
    for (const auto kind : {SmoothKind::tangent_line, SmoothKind::normal_line, SmoothKind::tangent_arc}) {
        const SmoothShape s{.kind = kind, .length = 15, .radius = 10, .angle = 1};
        EXPECT_EQ(smooth_approach(manual_start, off, s).path, smooth_approach(manual_start, zero, s).path);
        EXPECT_EQ(smooth_departure(off, manual_start, s).path, smooth_departure(zero, manual_start, s).path);
    }
}

TEST(smooth_approach, Faults) {
    const auto failure = [](const SmoothShape& s, const OuterEnd& from = manual_start, ContourEnd c = manual_contour) {
        const auto r = smooth_approach(from, c, s);
        EXPECT_TRUE(r.path.empty());
        EXPECT_EQ(smooth_departure(c, from, s).failure, r.failure);
        return r.failure;
    };
    const double nan = std::numeric_limits<double>::quiet_NaN();
    using enum SmoothFailure;
    using K = SmoothKind;
    EXPECT_EQ(failure({.kind = K::tangent_line, .length = 0}), bad_length);
    EXPECT_EQ(failure({.kind = K::normal_line, .length = -3}), bad_length);
    EXPECT_EQ(failure({.kind = K::normal_line, .length = nan}), not_a_number);
    EXPECT_EQ(failure({.kind = K::tangent_arc, .radius = 0, .angle = 1}), bad_radius);
    EXPECT_EQ(failure({.kind = K::tangent_arc, .radius = 9, .angle = 0}), bad_angle);
    EXPECT_EQ(failure({.kind = K::tangent_arc, .radius = 9, .angle = 6.3}), bad_angle);
    EXPECT_EQ(failure({.kind = K::tangent_arc, .radius = 9, .angle = nan}), not_a_number);
    EXPECT_EQ(failure({.kind = K::tangent_arc, .radius = 4.9, .angle = 1}), tool_too_large);
    EXPECT_EQ(failure({.kind = K::arc_and_line, .radius = -9}), bad_radius);
    EXPECT_EQ(failure({.kind = K::arc_and_line, .radius = 4}), tool_too_large);
    const Vec2 inside = manual_contour.at + 11 * right_of;
    EXPECT_EQ(failure({.kind = K::arc_and_line, .radius = 10}, {inside, 3}), inside_of_circle);
    EXPECT_EQ(failure({.kind = K::arc_and_line, .radius = 9}, {{nan, 0}, 0}), not_a_number);
    ContourEnd still = manual_contour;
    still.direction = {};
    EXPECT_EQ(failure({.kind = K::tangent_line, .length = 9}, manual_start, still), bad_direction);
    EXPECT_TRUE(smooth_approach(manual_start, manual_contour, {.kind = K::tangent_arc, .radius = -1, .angle = 1}).ok());
}

TEST(smooth_approach, AnArcOfTheToolsRadiusIsAPoint) {
    const auto r =
        smooth_approach(manual_start, manual_contour, {.kind = SmoothKind::tangent_arc, .radius = 5, .angle = 2});
    ASSERT_TRUE(r.ok());
    ASSERT_EQ(r.path.size(), 2u);
    expect_point(r.path[1].to, centre_at_contour);
}

struct Case {
    OuterEnd outer;
    ContourEnd end;
    SmoothShape shape;
};

Case random_case(Random& random) {
    Case c;
    c.outer = {{random.in(-80, 80), random.in(-80, 80)}, random.in(-1, 1)};
    c.end = {{random.in(-9, 9), random.in(-9, 9)},
             rotated({random.in(0.1, 9), 0}, random.in(-4, 4)),
             random.upto(1) == 0 ? Side::left : Side::right,
             random.in(0, 10),
             random.in(-9, 0)};
    c.shape.kind = static_cast<SmoothKind>(random.upto(3));
    c.shape.length = random.in(0.1, 30);
    c.shape.radius = random.in(0.1, 30);
    if (c.shape.kind == SmoothKind::tangent_arc && random.upto(1) == 0) c.shape.radius *= -1;
    c.shape.angle = random.in(0.01, 2 * pi);
    c.shape.arc_of = random.upto(1) == 0 ? ArcOf::contour : ArcOf::centre;
    c.shape.w_move = static_cast<WMove>(random.upto(2));
    return c;
}

void check_ends(const Case& c, const SmoothPath& r) {
    for (std::size_t i = 1; i < r.path.size(); ++i) {
        ASSERT_LE(geom::distance(r.path[i - 1].to, r.path[i].from), 1e-9);
        ASSERT_EQ(r.path[i - 1].w_to, r.path[i].w_from);
    }
    const Vec2 unit_along = (1 / geom::length(c.end.direction)) * c.end.direction, off = r.contour - c.end.at;
    ASSERT_NEAR(geom::length(off), c.end.tool_radius, 1e-9);
    ASSERT_NEAR(geom::dot(off, unit_along), 0, 1e-9);
    ASSERT_GE(geom::cross(unit_along, off) * (c.end.side == Side::left ? 1 : -1), -1e-9);
}

/// The last part is tangential or normal, arcs go over into their lines, both ends are where they belong.
TEST(smooth_approach, EndsTangentialOrNormalAtTheToolsRadius) {
    const std::uint32_t seed = 20250611;
    std::cout << "seed " << seed << '\n';
    Random random(seed);
    int good = 0;
    for (int i = 0; i < 20000; ++i) {
        const Case c = random_case(random);
        const auto r = smooth_approach(c.outer, c.end, c.shape);
        if (!r.ok()) continue;
        ++good;
        check_ends(c, r);
        ASSERT_FALSE(r.path.empty());
        ASSERT_LE(geom::distance(r.path.front().from, c.outer.at), 1e-9);
        ASSERT_LE(geom::distance(r.path.back().to, r.contour), 1e-9);
        const Element& last = r.path.back();
        const Vec2 d = end_direction(last), along_contour = (1 / geom::length(c.end.direction)) * c.end.direction;
        if (c.shape.kind == SmoothKind::normal_line) {
            ASSERT_NEAR(geom::dot(d, along_contour), 0, 1e-9);
            ASSERT_NEAR(planar_length(last), c.shape.length, 1e-9);
        } else if (c.shape.kind == SmoothKind::tangent_line || is_arc(last)) {
            ASSERT_NEAR(geom::cross(d, along_contour), 0, 1e-9);
            ASSERT_GT(geom::dot(d, along_contour), 0);
        }
        if (c.shape.kind != SmoothKind::arc_and_line || !is_arc(last) || !moves_in_plane(r.path.front())) continue;
        ASSERT_NEAR(turn_between(end_direction(r.path.front()), start_direction(last)), 0, 1e-6);
    }
    EXPECT_GT(good, 12000);
}

TEST(smooth_departure, IsTheApproachRunBackwards) {
    const std::uint32_t seed = 20250612;
    std::cout << "seed " << seed << '\n';
    Random random(seed);
    for (int i = 0; i < 20000; ++i) {
        const Case c = random_case(random);
        const auto r = smooth_departure(c.end, c.outer, c.shape);
        if (!r.ok()) continue;
        check_ends(c, r);
        if (r.path.empty()) continue;
        ASSERT_LE(geom::distance(r.path.front().from, r.contour), 1e-9);
        ASSERT_EQ(r.path.back().w_to, c.outer.w);
        const bool lct = c.shape.kind == SmoothKind::arc_and_line;
        ASSERT_LE(geom::distance(r.path.back().to, lct ? c.outer.at : r.auxiliary), 1e-9);
        ContourEnd back = c.end;
        back.direction = -c.end.direction;
        back.side = c.end.side == Side::left ? Side::right : Side::left;
        const auto forwards = smooth_approach({r.path.back().to, c.outer.w}, back, c.shape);
        ASSERT_EQ(forwards.path.size(), r.path.size());
        for (std::size_t k = 0; k < r.path.size(); ++k) {
            const Element &a = r.path[k], &b = forwards.path[r.path.size() - 1 - k];
            ASSERT_LE(geom::distance(a.from, b.to), 1e-9);
            ASSERT_NEAR(a.sweep, -b.sweep, 1e-9);
        }
    }
}

TEST(smooth_approach, MovesAndMirrorsWithItsInput) {
    const std::uint32_t seed = 20250613;
    std::cout << "seed " << seed << '\n';
    Random random(seed);
    for (int i = 0; i < 10000; ++i) {
        const Case c = random_case(random);
        const double angle = random.in(-4, 4), flip = random.upto(1) == 0 ? 1 : -1;
        const Vec2 shift{random.in(-99, 99), random.in(-99, 99)};
        const auto turned = [&](Vec2 p) { return rotated({p.x, flip * p.y}, angle); };
        Case m = c;
        m.outer.at = turned(c.outer.at) + shift;
        m.end.at = turned(c.end.at) + shift;
        m.end.direction = turned(c.end.direction);
        if (flip < 0) m.end.side = c.end.side == Side::left ? Side::right : Side::left;
        const auto a = smooth_approach(c.outer, c.end, c.shape), b = smooth_approach(m.outer, m.end, m.shape);
        ASSERT_EQ(a.failure, b.failure);
        ASSERT_EQ(a.path.size(), b.path.size());
        for (std::size_t k = 0; k < a.path.size(); ++k) {
            ASSERT_LE(geom::distance(turned(a.path[k].to) + shift, b.path[k].to), 1e-8);
            ASSERT_NEAR(flip * a.path[k].sweep, b.path[k].sweep, 1e-8);
        }
    }
}

}  // namespace
}  // namespace obrys::path::test
