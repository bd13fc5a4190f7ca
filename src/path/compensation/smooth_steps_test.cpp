/// Approaches and departures of smooth_approach.hpp on their way through the compensation.

#include <gtest/gtest.h>

#include <cmath>
#include <iostream>

#include "path/compensation/compensation_testing.hpp"
#include "path/smooth_approach.hpp"

namespace obrys::path::test {
namespace {

/// Approach, contour and departure, as a run hands them to the compensation: the approach's last step selects it, where
/// need be by an element of no length; the departure's first one deselects it.
std::vector<Step> steps_of(const SmoothPath& on, const std::vector<Element>& contour, const SmoothPath& off,
                           const Setting& s) {
    std::vector<Step> steps;
    for (const Element& e : on.path) steps.push_back({e, {}});
    if (steps.empty() || !moves_in_plane(steps.back().e))
        steps.push_back({line(on.contour, on.contour, steps.empty() ? 0 : steps.back().e.w_to), {}});
    steps.back().s = s;
    steps.back().s.approach = Approach::ready;
    for (const Element& e : contour) steps.push_back({e, s});
    Setting away;
    away.approach = Approach::ready;
    for (const Element& e : off.path) steps.push_back({e, away});
    return steps;
}

TEST(smooth_steps, AreLeftAsTheyAre) {
    const ContourEnd begin{{0, 0}, {1, 0}, Side::left, 5, -2}, end{{40, 0}, {1, 0}, Side::left, 5, -2};
    const auto on = smooth_approach({{-20, 30}, 3}, begin, {.kind = SmoothKind::arc_and_line, .radius = 12});
    const auto off = smooth_departure(end, {{60, 30}, 3}, {.kind = SmoothKind::arc_and_line, .radius = 12});
    for (const auto clearance : {Clearance::neighbours, Clearance::reported, Clearance::avoided}) {
        Setting s = left(5);
        s.clearance = clearance;
        s.window = 9;
        const Result r = run(steps_of(on, {line({0, 0}, {40, 0}, -2)}, off, s));
        EXPECT_TRUE(r.faults.empty());
        ASSERT_EQ(r.out.size(), 7u);
        EXPECT_LE(largest_gap(r), 1e-12);
        const std::vector<Kind> kinds{Kind::passed,  Kind::passed, Kind::approach, Kind::contour,
                                      Kind::retract, Kind::passed, Kind::passed};
        for (std::size_t i = 0; i < r.out.size(); ++i) {
            SCOPED_TRACE(i);
            EXPECT_EQ(r.out[i].kind, kinds[i]);
            const Element want = i < 3 ? on.path[i] : i > 3 ? off.path[i - 4] : line({0, 5}, {40, 5}, -2);
            EXPECT_LE(geom::distance(r.out[i].element.to, want.to), 1e-12);
            EXPECT_NEAR(r.out[i].element.sweep, want.sweep, 1e-12);
            EXPECT_EQ(r.out[i].element.w_to, want.w_to);
        }
    }
}

TEST(smooth_steps, AnArcThatShrinksToAPointStillSelects) {
    const ContourEnd begin{{0, 0}, {1, 0}, Side::left, 5, -2};
    const auto on = smooth_approach({{-9, 20}, 3}, begin, {.kind = SmoothKind::arc_and_line, .radius = 5});
    ASSERT_EQ(on.path.size(), 2u);
    const Result r = run(steps_of(on, {line({0, 0}, {9, 0}, -2)}, {}, left(5)));
    EXPECT_TRUE(r.faults.empty());
    ASSERT_EQ(r.out.size(), 3u);
    EXPECT_LE(geom::distance(r.out[0].element.to, {0, 5}), 1e-12);
    EXPECT_EQ(r.out[1].element.w_to, -2);
    EXPECT_EQ(r.out[2].kind, Kind::contour);
    EXPECT_LE(geom::distance(r.out[2].element.to, {9, 5}), 1e-12);
}

/// The last element is an inner arc tighter than the tool and is left out: the departure keeps its circle all the same.
TEST(smooth_steps, ADepartureKeepsItsCircleWhereverTheContourEnded) {
    const Element straight = line({0, 0}, {50, 0}), tight = arc({50, 0}, {50, 4}, pi / 2);
    const ContourEnd end{tight.to, {0, 1}, Side::left, 5, 0};
    const auto off = smooth_departure(end, {}, {.kind = SmoothKind::tangent_arc, .radius = 8, .angle = pi / 2});
    const Result r = run(steps_of(smooth_approach({{-20, 5}, 0}, {{0, 0}, {1, 0}, Side::left, 5, 0},
                                                  {.kind = SmoothKind::tangent_line, .length = 9}),
                                  {straight, tight}, off, left(5)));
    EXPECT_FALSE(r.faults.empty());
    EXPECT_LE(largest_gap(r), 1e-12);
    for (const Output& o : r.out) {
        const Element& e = o.element;
        if (!is_arc(e)) continue;
        EXPECT_NEAR(geom::distance(e.from, e.centre), geom::distance(e.to, e.centre), 1e-9);
    }
}

/// Nothing follows an approach by an arc (a programmed stop): it ends where it was to end.
TEST(smooth_steps, AnApproachAloneEndsOnTheContour) {
    const auto on = smooth_approach({{-20, 30}, 0}, {{0, 0}, {1, 0}, Side::left, 5, 0},
                                    {.kind = SmoothKind::tangent_arc, .radius = 8, .angle = pi / 2});
    const Result r = run(steps_of(on, {}, {}, left(5)));
    ASSERT_FALSE(r.out.empty());
    EXPECT_LE(geom::distance(r.out.back().element.to, {0, 5}), 1e-12);
    EXPECT_NEAR(std::abs(r.out.back().element.sweep), pi / 2, 1e-12);
}

/// Whatever the shape: the path holds together, and the elements of approach and departure come out as they went in.
TEST(smooth_steps, HoldTogetherWithTheContour) {
    const std::uint32_t seed = 20251125;
    std::cout << "seed " << seed << '\n';
    Random random(seed);
    int good = 0;
    for (int i = 0; i < 10000; ++i) {
        const Setting s = random.upto(1) == 0 ? left(random.in(0, 5)) : right(random.in(0, 5));
        const Element first = line({0, 0}, rotated({30, 0}, random.in(-4, 4)));
        const Element last = arc(first.to, first.to + 20 * geom::left_of(start_direction(first)), random.in(0.5, 5));
        const auto shape = [&] {
            return SmoothShape{.kind = static_cast<SmoothKind>(random.upto(3)),
                               .length = random.in(1, 20),
                               .radius = random.in(5, 15),
                               .angle = random.in(0.1, 2 * pi)};
        };
        const OuterEnd outer{{random.in(-90, 90), random.in(-90, 90)}, 5};
        const auto on = smooth_approach(outer, {first.from, start_direction(first), s.side, s.radius, 0}, shape());
        const auto off = smooth_departure({last.to, end_direction(last), s.side, s.radius, 0}, outer, shape());
        if (!on.ok() || !off.ok()) continue;
        ++good;
        const Result r = run(steps_of(on, {first, last}, off, s));
        SCOPED_TRACE(i);
        ASSERT_TRUE(r.faults.empty());
        ASSERT_LE(largest_gap(r), 1e-9);
        ASSERT_EQ(r.out.size(), on.path.size() + 2 + off.path.size());
        for (std::size_t k = 0; k < off.path.size(); ++k) {
            const Element &have = r.out[on.path.size() + 2 + k].element, &want = off.path[k];
            ASSERT_LE(geom::distance(have.to, want.to), 1e-9);
            ASSERT_NEAR(have.sweep, want.sweep, 1e-9);
        }
    }
    EXPECT_GT(good, 8000);
}

}  // namespace
}  // namespace obrys::path::test
