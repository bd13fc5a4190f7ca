#include "path/compensation/compensation.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "path/compensation/compensation_testing.hpp"
#include "path/nose.hpp"

namespace obrys::path::test {
namespace {

const std::vector<Element> square = polyline({{0, 0}, {10, 0}, {10, 10}, {0, 10}, {0, 0}});

TEST(compensation, SquareOutsideWithTransitionArcs) {
    auto steps = contour_steps({-5, -5}, square, right(2));
    steps.push_back({line({0, 0}, {-5, -5}), {}});
    const Result r = run(steps);
    EXPECT_TRUE(r.faults.empty());
    expect_path(r, {{{0, -2}, Kind::approach},
                    {{10, -2}, Kind::contour},
                    {{12, 0}, Kind::transition},
                    {{12, 10}, Kind::contour},
                    {{10, 12}, Kind::transition},
                    {{0, 12}, Kind::contour},
                    {{-2, 10}, Kind::transition},
                    {{-2, 0}, Kind::contour},
                    {{-5, -5}, Kind::retract}});
    expect_point(r.out[2].element.centre, {10, 0});
    EXPECT_NEAR(r.out[2].element.sweep, pi / 2, 1e-12);
    EXPECT_EQ(r.out[2].element.tag, 2u) << "the transition belongs to the following block";
}

TEST(compensation, SquareOutsideWithIntersections) {
    Setting s = right(2);
    s.corner = OuterCorner::intersection;
    const Result r = run(contour_steps({-5, -5}, square, s));
    EXPECT_TRUE(r.faults.empty());
    expect_path(r, {{{0, -2}, Kind::approach},
                    {{12, -2}, Kind::contour},
                    {{12, 12}, Kind::contour},
                    {{-2, 12}, Kind::contour},
                    {{-2, 0}, Kind::contour}});
}

TEST(compensation, IntersectionBeyondTheLimitIsAnArc) {
    Setting s = right(1);
    s.corner = OuterCorner::intersection;
    const auto spike = polyline({{0, 0}, {10, 0}, {0, 3}});  // turns by about 163 degrees
    const Result r = run(contour_steps({-5, 0}, spike, s));
    ASSERT_EQ(r.out.size(), 4u);
    EXPECT_EQ(r.out[2].kind, Kind::transition);
    s.corner_limit = geom::radians(170);
    EXPECT_EQ(run(contour_steps({-5, 0}, spike, s)).out.size(), 3u);
}

TEST(compensation, SquareInside) {
    const auto inside = polyline({{5, 0}, {10, 0}, {10, 10}, {0, 10}, {0, 0}, {5, 0}});
    const Result r = run(contour_steps({5, 5}, inside, left(2)));
    EXPECT_TRUE(r.faults.empty());
    expect_path(r, {{{5, 2}, Kind::approach},
                    {{8, 2}, Kind::contour},
                    {{8, 8}, Kind::contour},
                    {{2, 8}, Kind::contour},
                    {{2, 2}, Kind::contour},
                    {{5, 2}, Kind::contour}});
}

TEST(compensation, RoundedRectangleHasNoExtraElements) {
    const std::vector<Element> shape{line({5, 0}, {17, 0}), arc({17, 0}, {17, 3}, pi / 2), line({20, 3}, {20, 7}),
                                     arc({20, 7}, {17, 7}, pi / 2), line({17, 10}, {5, 10})};
    const Result out = run(contour_steps({5, -9}, shape, right(2)));
    expect_path(out, {{{5, -2}, Kind::approach},
                      {{17, -2}, Kind::contour},
                      {{22, 3}, Kind::contour},
                      {{22, 7}, Kind::contour},
                      {{17, 12}, Kind::contour},
                      {{5, 12}, Kind::contour}});
    const Result in = run(contour_steps({5, 5}, shape, left(2)));
    EXPECT_TRUE(in.faults.empty());
    EXPECT_NEAR(geom::distance(in.out[2].element.from, in.out[2].element.centre), 1, 1e-12);
}

TEST(compensation, FilletOfTheToolsRadiusShrinksToAPointAndHandsOnItsEvents) {
    const std::vector<Element> shape{line({5, 0}, {17, 0}), arc({17, 0}, {17, 3}, pi / 2), line({20, 3}, {20, 7})};
    auto steps = contour_steps({5, 5}, shape, left(3));
    steps[2].e.before = {7};
    steps[3].e.before = {8};
    const Result r = run(steps);
    EXPECT_TRUE(r.faults.empty());
    expect_path(r, {{{5, 3}, Kind::approach}, {{17, 3}, Kind::contour}, {{17, 7}, Kind::contour}});
    EXPECT_EQ(r.out[2].element.before, (Events{7, 8}));
}

TEST(compensation, Slot) {
    const std::vector<Element> slot{line({0, -5}, {20, -5}), arc({20, -5}, {20, 0}, pi), line({20, 5}, {0, 5}),
                                    arc({0, 5}, {0, 0}, pi)};
    const Result r = run(contour_steps({0, 0}, slot, left(4)));
    EXPECT_TRUE(r.faults.empty());
    expect_path(r, {{{0, -1}, Kind::approach},
                    {{20, -1}, Kind::contour},
                    {{20, 1}, Kind::contour},
                    {{0, 1}, Kind::contour},
                    {{0, -1}, Kind::contour}});
    EXPECT_FALSE(run(contour_steps({0, 0}, slot, left(5.001))).faults.empty());
}

TEST(compensation, FullCircleInsideOutsideAndWithANegativeRadius) {
    const std::vector<Element> circle{arc({10, 0}, {0, 0}, 2 * pi)};
    const Result in = run(contour_steps({0, 0}, circle, left(4)));
    expect_path(in, {{{6, 0}, Kind::approach}, {{6, 0}, Kind::contour}});
    EXPECT_DOUBLE_EQ(in.out[1].element.sweep, 2 * pi);
    expect_path(run(contour_steps({20, 0}, circle, right(4))), {{{14, 0}, Kind::approach}, {{14, 0}, Kind::contour}});
    expect_path(run(contour_steps({20, 0}, circle, left(-4))), {{{14, 0}, Kind::approach}, {{14, 0}, Kind::contour}});
    const Result tight = run(contour_steps({0, 0}, circle, left(10.5)));
    ASSERT_EQ(tight.faults.size(), 1u);
    EXPECT_EQ(tight.faults[0].reason, Reason::tool_radius_too_large);
    EXPECT_EQ(tight.faults[0].tag, 1u);
}

TEST(compensation, InnerCornersOfLineAndArc) {
    // Line along y = 0 into the circle of radius 10 about (0, 0) at (10, 0), then up counter-clockwise: turn 90 left.
    const std::vector<Element> c{line({0, 0}, {10, 0}), arc({10, 0}, {0, 0}, pi / 2)};
    const Result r = run(contour_steps({0, 5}, c, left(2)));
    EXPECT_TRUE(r.faults.empty());
    expect_path(r, {{{0, 2}, Kind::approach}, {{std::sqrt(60.0), 2}, Kind::contour}, {{0, 8}, Kind::contour}});
    // Two arcs of radius 10 about (0, 0) and (12, 0), from the left one into the right one at (6, 8): inside both.
    const std::vector<Element> lens{arc({10, 0}, {0, 0}, std::atan2(8, 6)), arc({6, 8}, {12, 0}, std::atan2(8, 6))};
    const Result both = run(contour_steps({8, 0}, lens, left(1)));
    EXPECT_TRUE(both.faults.empty());
    expect_point(both.out[1].element.to, {6, std::sqrt(81.0 - 36.0)});
}

TEST(compensation, SideChangeRunsOverTheBlock) {
    std::vector<Step> steps{{line({-5, 0}, {0, 0}), left(2)},   {line({0, 0}, {10, 0}), left(2)},
                            {line({10, 0}, {20, 0}), right(2)}, {line({20, 0}, {30, 0}), right(2)},
                            {line({30, 0}, {40, 0}), right(1)}, {line({40, 0}, {50, 0}), right(1)}};
    const Result r = run(steps);
    EXPECT_TRUE(r.faults.empty());
    expect_path(r, {{{0, 2}, Kind::approach},
                    {{10, 2}, Kind::contour},
                    {{20, -2}, Kind::contour},
                    {{30, -2}, Kind::contour},
                    {{40, -1}, Kind::contour},
                    {{50, -1}, Kind::contour}});
    steps[2].e = arc({10, 0}, {15, 0}, pi);
    const Result bad = run(steps);
    ASSERT_EQ(bad.faults.size(), 1u);
    EXPECT_EQ(bad.faults[0].reason, Reason::arc_needs_line_at_start);
    EXPECT_LE(largest_gap(bad), 1e-9);
}

TEST(compensation, MovesAlongTheNormalStayInPlaceAndInOrder) {
    auto steps = contour_steps({-5, -5}, square, right(2));
    Element down = line({10, 0}, {10, 0});
    down.w_from = 0;
    down.w_to = -3;
    down.before = {1};
    Element only_event = line({10, 0}, {10, 0}, -3);
    only_event.before = {2};
    steps.insert(steps.begin() + 2, {{down, right(2)}, {only_event, right(2)}});
    steps[4].e.before = {3};
    const Result r = run(steps);
    EXPECT_TRUE(r.faults.empty());
    ASSERT_GE(r.out.size(), 4u);
    expect_point(r.out[2].element.from, {10, -2});
    expect_point(r.out[2].element.to, {10, -2});
    EXPECT_EQ(r.out[2].element.w_to, -3);
    EXPECT_EQ(r.out[2].element.before, (Events{1}));
    EXPECT_EQ(r.out[3].kind, Kind::transition);
    EXPECT_EQ(r.out[3].element.before, (Events{2, 3})) << "events of the next block come before its arc";
    EXPECT_EQ(r.out[3].element.w_from, -3);
    EXPECT_LE(largest_gap(r), 1e-9);
}

TEST(compensation, HelixKeepsItsRise) {
    Element helix = arc({10, 0}, {0, 0}, 4 * pi);
    helix.w_to = -6;
    const Result r = run(contour_steps({0, 0}, {helix}, left(4)));
    ASSERT_EQ(r.out.size(), 2u);
    EXPECT_DOUBLE_EQ(r.out[1].element.sweep, 4 * pi);
    EXPECT_EQ(r.out[1].element.w_to, -6);
}

TEST(compensation, SeveralTurnsAreCutShortAtTheLastOne) {
    const Element helix = arc({10, 0}, {0, 0}, 4 * pi);
    const Result r = run(contour_steps({0, 0}, {helix, line({10, 0}, {2, 0})}, left(1)));
    EXPECT_TRUE(r.faults.empty());
    ASSERT_EQ(r.out.size(), 3u);
    EXPECT_NEAR(r.out[1].element.sweep, 4 * pi - std::asin(1.0 / 9), 1e-12);
    expect_point(r.out[1].element.to, {std::sqrt(80.0), -1});
}

TEST(compensation, IntersectionFarFromTheCornerIsAnArc) {
    Setting s = left(1);
    s.corner = OuterCorner::intersection;
    // Right turn of 90 degrees into an arc that curves away to the left: its parallel meets y = 1 late.
    const auto corner = [&](double radius) {
        return run(contour_steps({-20, 0}, {line({-10, 0}, {0, 0}), arc({0, 0}, {radius, 0}, 1)}, s)).out.size();
    };
    EXPECT_EQ(corner(30), 3u);
    EXPECT_EQ(corner(2.2), 4u);
}

TEST(compensation, OffPassesEverythingAtOnce) {
    Compensation c;
    int seen = 0;
    const auto sink = [&seen](const Output& o) { seen += o.kind == Kind::passed ? 1 : 100; };
    EXPECT_TRUE(c.push(arc({10, 0}, {0, 0}, 1), {}, sink).empty());
    EXPECT_EQ(seen, 1);
    EXPECT_TRUE(c.idle());
}

TEST(compensation, DeselectedAtOnceIsNotSelected) {
    const Result r = run({{line({0, 0}, {5, 0}), left(2)}, {line({5, 0}, {5, 9}), {}}});
    expect_path(r, {{{5, 0}, Kind::passed}, {{5, 9}, Kind::passed}});
}

TEST(compensation, ArcsCannotSwitchItOnOrOff) {
    const Result on = run({{arc({10, 0}, {0, 0}, pi), left(2)}, {line({-10, 0}, {-10, -5}), left(2)}});
    ASSERT_EQ(on.faults.size(), 1u);
    EXPECT_EQ(on.faults[0].reason, Reason::arc_needs_line_at_start);
    auto steps = contour_steps({-5, -5}, square, right(2));
    steps.push_back({arc({0, 0}, {-3, 0}, -pi / 2), {}});
    steps.push_back({line({-3, -3}, {-9, -3}), {}});
    const Result off = run(steps);
    ASSERT_EQ(off.faults.size(), 1u);
    EXPECT_EQ(off.faults[0].reason, Reason::arc_needs_line_at_start);
    expect_point(off.out.back().element.to, {-9, -3});
}

TEST(compensation, ElementTooShortForTheToolIsLeftOutOrReported) {
    // A step of 1 mm at the bottom of an inner corner: the tool of radius 4 cannot follow it.
    const auto step = polyline({{0, 0}, {20, 0}, {21, 1}, {21, 20}});
    const Result bridged = run(contour_steps({0, 9}, step, left(4)));
    ASSERT_EQ(bridged.faults.size(), 1u);
    EXPECT_TRUE(bridged.faults[0].bridged);
    EXPECT_EQ(bridged.faults[0].reason, Reason::element_vanishes);
    EXPECT_EQ(bridged.faults[0].tag, 2u);
    expect_path(bridged, {{{0, 4}, Kind::approach}, {{17, 4}, Kind::contour}, {{17, 20}, Kind::contour}});
    // Here the second corner alone takes 2.9 mm of the element's 3.2 mm, both take too much.
    const auto late = polyline({{0, 0}, {20, 0}, {23, 1}, {23, 20}});
    const Result seen_late = run(contour_steps({0, 9}, late, left(4)));
    ASSERT_EQ(seen_late.faults.size(), 1u);
    EXPECT_TRUE(seen_late.faults[0].bridged);
    expect_path(seen_late, {{{0, 4}, Kind::approach}, {{19, 4}, Kind::contour}, {{19, 20}, Kind::contour}});
    const Result strict = run(contour_steps({0, 9}, step, left(4)), 1);
    ASSERT_FALSE(strict.faults.empty());
    EXPECT_EQ(strict.faults[0].reason, Reason::element_vanishes);
    EXPECT_EQ(strict.faults[0].tag, 2u);
    EXPECT_FALSE(strict.faults[0].bridged);
    EXPECT_LE(largest_gap(strict), 1e-9);
}

TEST(compensation, TurningMovesTheTipOfTheNose) {
    // Plane (z, x): facing at z = 0 down to x = 10, cylinder to z = -20, outside; nose 0.8, position 3.
    Setting s = right(0.8);
    s.tip = *nose_offset(3, 0.8);
    Setting end;
    const Result r = run({{line({5, 14}, {2, 10}), s},
                          {line({2, 10}, {-20, 10}), s},
                          {line({-20, 10}, {-30, 15}), s},
                          {line({-30, 15}, {-30, 40}), end}});
    EXPECT_TRUE(r.faults.empty());
    ASSERT_EQ(r.out.size(), 4u);
    expect_point(r.out[0].element.from, {5, 14});
    expect_point(r.out[0].element.to, {2 - 0.8, 10});
    // An inner corner of 26.565 degrees: the centre stops r tan(half of it) before z = -20, the tip is 0.8 beside it.
    const double half = std::tan(0.5 * std::atan2(5, 10));
    expect_point(r.out[1].element.to, {-20 + 0.8 * half - 0.8, 10});
    expect_point(r.out[3].element.to, {-30, 40});
    const Vec2 centre = r.out[2].element.to - s.tip;
    EXPECT_NEAR(geom::distance(centre, {-30, 15}), 0.8, 1e-12);
}

TEST(compensation, NoIntersection) {
    // From inside a circle of radius 5 into a small circle: parallels at 3 mm have no common point.
    const std::vector<Element> c{arc({5, 0}, {0, 0}, pi / 2), arc({0, 5}, {4, 5}, pi / 2 + 0.3)};
    const Result r = run(contour_steps({2, 0}, c, left(3.9)));
    ASSERT_EQ(r.faults.size(), 1u);
    EXPECT_EQ(r.faults[0].reason, Reason::no_intersection);
    EXPECT_LE(largest_gap(r), 1e-9);
}

}  // namespace
}  // namespace obrys::path::test
