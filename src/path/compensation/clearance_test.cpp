#include <gtest/gtest.h>

#include <cmath>
#include <iostream>

#include "path/compensation/compensation_testing.hpp"

namespace obrys::path::test {
namespace {

Setting reported(double radius, std::size_t window = 99) {
    Setting s = left(radius);
    s.clearance = Clearance::reported;
    s.window = window;
    return s;
}

Setting avoided(double radius, std::size_t window = 99) {
    Setting s = reported(radius, window);
    s.clearance = Clearance::avoided;
    return s;
}

void expect_faults(const Result& r, Reason why, const std::vector<std::uint64_t>& tags, bool bridged) {
    ASSERT_EQ(r.faults.size(), tags.size());
    for (std::size_t i = 0; i < tags.size(); ++i) {
        EXPECT_EQ(r.faults[i].reason, why);
        EXPECT_EQ(r.faults[i].tag, tags[i]);
        EXPECT_EQ(r.faults[i].bridged, bridged);
    }
}

/// The manual's example to M97: steps of 0.5 mm and a tool of radius 20 (points 12 to 17; the lengths are ours).
const std::vector<Element> small_steps = polyline({{-100, 0}, {0, 0}, {0, -0.5}, {100, -0.5}, {100, 0}, {200, 0}});

TEST(clearance, SmallStepsWithoutHelpCannotBeReached) {
    const Result r = run(contour_steps({-100, 40}, small_steps, reported(20)));
    ASSERT_FALSE(r.faults.empty());
    EXPECT_EQ(r.faults[0].reason, Reason::element_vanishes);
    EXPECT_EQ(r.faults[0].tag, 2u);
    EXPECT_FALSE(r.faults[0].bridged);
    EXPECT_LE(largest_gap(r), 1e-9);
}

TEST(clearance, M97ClosesOuterCornersByTheCrossing) {
    auto steps = contour_steps({-100, 40}, small_steps, reported(20));
    steps[1].s.at_end = steps[4].s.at_end = CornerEnd::crossing;
    const Result r = run(steps);
    EXPECT_TRUE(r.faults.empty());
    expect_path(r, {{{-100, 20}, Kind::approach},
                    {{20, 20}, Kind::contour},
                    {{20, 19.5}, Kind::contour},
                    {{80, 19.5}, Kind::contour},
                    {{80, 20}, Kind::contour},
                    {{200, 20}, Kind::contour}});
}

TEST(clearance, M97ProlongsArcs) {
    // A half circle of radius 10 over the top, left at a right angle: parallels of radius 15 and x = 15 touch.
    std::vector<Step> steps{{line({-30, 0}, {-10, 0}), reported(5)},
                            {arc({-10, 0}, {0, 0}, -pi / 2), reported(5)},
                            {line({0, 10}, {0, -20}), reported(5)}};
    steps[1].s.at_end = CornerEnd::crossing;
    const Result r = run(steps);
    EXPECT_TRUE(r.faults.empty());
    expect_path(r, {{{-15, 0}, Kind::approach}, {{5, std::sqrt(200.0)}, Kind::contour}, {{5, -20}, Kind::contour}});
    EXPECT_NEAR(r.out[1].element.sweep, -pi / 2 - std::asin(5.0 / 15), 1e-12);
}

TEST(clearance, LookAheadLeavesSmallStepsOut) {
    const Result r = run(contour_steps({-100, 40}, small_steps, avoided(20)));
    expect_faults(r, Reason::element_vanishes, {2, 4}, true);
    const double in = std::sqrt(400 - 19.5 * 19.5);
    expect_path(r, {{{-100, 20}, Kind::approach},
                    {{0, 20}, Kind::contour},
                    {{in, 19.5}, Kind::transition},
                    {{100 - in, 19.5}, Kind::contour},
                    {{100, 20}, Kind::transition},
                    {{200, 20}, Kind::contour}});
    EXPECT_NEAR(r.out[2].element.sweep, -std::asin(in / 20), 1e-12);
}

TEST(clearance, M98RunsAnInnerCornerOutToBothNormals) {
    auto steps = contour_steps({30, 50}, polyline({{0, 50}, {0, 0}, {50, 0}}), reported(10));
    const Result usual = run(steps);
    expect_path(usual, {{{10, 50}, Kind::approach}, {{10, 10}, Kind::contour}, {{50, 10}, Kind::contour}});
    steps[1].s.at_end = CornerEnd::open;
    const auto expected = std::vector<std::pair<Vec2, Kind>>{
        {{10, 50}, Kind::approach}, {{10, 0}, Kind::contour}, {{0, 10}, Kind::link}, {{50, 10}, Kind::contour}};
    const Result open = run(steps);
    EXPECT_TRUE(open.faults.empty());
    expect_path(open, expected);
    for (Step& s : steps) s.s.clearance = Clearance::neighbours;
    expect_path(run(steps), expected);
}

/// SOUCAST1.H of the article (../shared/programs/heidenhain), RL with radius 5: its compensated contour is 331.312 mm
/// long.
TEST(clearance, TheArticlesPart) {
    const std::vector<Element> part{
        line({110, 10}, {49.5, 10}),  arc({49.5, 10}, {42, 10}, pi / 2), line({42, 17.5}, {32, 17.5}),
        line({32, 17.5}, {10, 22.5}), line({10, 22.5}, {10, 55}),        arc({10, 55}, {15, 55}, -pi),
        arc({20, 55}, {30, 55}, pi),  line({40, 55}, {40, 60}),          line({40, 60}, {50, 70}),
        line({50, 70}, {60, 70}),     line({60, 70}, {70, 60}),          line({70, 60}, {70, -20})};
    for (const Setting& s : {reported(5), avoided(5)}) {
        const Result r = run(contour_steps({110, -30}, part, s));
        EXPECT_TRUE(r.faults.empty());
        ASSERT_EQ(r.out.size(), 20u);
        double length = 0;
        for (std::size_t i = 1; i < r.out.size(); ++i) length += planar_length(r.out[i].element);
        EXPECT_NEAR(length, 331.31210674955094, 1e-9);
        EXPECT_NEAR(planar_length(r.out[0].element), 35, 1e-12);
        EXPECT_NEAR(r.out[2].element.sweep, -pi / 2, 1e-12);
        EXPECT_NEAR(r.out.back().element.to.x, 75, 1e-12);
    }
}

/// A slot 6 mm wide and a tool of radius 5.
const std::vector<Element> narrow_slot = polyline({{0, 0}, {50, 0}, {50, -30}, {56, -30}, {56, 0}, {100, 0}});

TEST(clearance, LookAheadPassesOverASlot) {
    const Result r = run(contour_steps({0, 20}, narrow_slot, avoided(5)));
    expect_faults(r, Reason::element_vanishes, {2, 3, 4}, true);
    expect_path(r, {{{0, 5}, Kind::approach},
                    {{50, 5}, Kind::contour},
                    {{53, 4}, Kind::transition},
                    {{56, 5}, Kind::transition},
                    {{100, 5}, Kind::contour}});
}

TEST(clearance, TheWindowLimitsTheLookAhead) {
    const Result enough = run(contour_steps({0, 20}, narrow_slot, avoided(5, 4)));
    expect_faults(enough, Reason::element_vanishes, {2, 3, 4}, true);
    const Result small = run(contour_steps({0, 20}, narrow_slot, avoided(5, 1)));
    ASSERT_FALSE(small.faults.empty());
    EXPECT_FALSE(small.faults[0].bridged);
    const Result none = run(contour_steps({0, 20}, narrow_slot, reported(5)));
    ASSERT_EQ(none.faults.size(), 1u) << "the neighbours' fault is enough";
    EXPECT_EQ(none.faults[0].reason, Reason::element_vanishes);
    EXPECT_EQ(none.faults[0].tag, 3u);
}

/// A chamber of 48 by 40 mm behind a neck 8 mm wide: every neighbour can be reached, but not through the neck.
const std::vector<Element> bottle_path =
    polyline({{0, 0}, {50, 0}, {50, -5}, {30, -5}, {30, -45}, {78, -45}, {78, -5}, {58, -5}, {58, 0}, {100, 0}});

TEST(clearance, AnUndercutIsReportedThoughNeighboursAreSound) {
    const Result r = run(contour_steps({0, 20}, bottle_path, reported(5)));
    ASSERT_FALSE(r.faults.empty());
    for (const Fault& f : r.faults) EXPECT_EQ(f.reason, Reason::interference);
    EXPECT_EQ(r.faults[0].tag, 2u) << "on the arc before element 2";
    EXPECT_EQ(r.faults[0].other, 9u);
    EXPECT_NEAR(r.faults[0].at.x, 54, 1e-9);
    EXPECT_NEAR(r.faults[0].at.y, 3, 1e-9);
    EXPECT_TRUE(run(contour_steps({0, 20}, bottle_path, reported(3.9))).faults.empty());
    EXPECT_TRUE(run(contour_steps({0, 20}, bottle_path, left(5))).faults.empty()) << "neighbours alone do not see it";
}

TEST(clearance, LookAheadPassesOverABottleneck) {
    const Result r = run(contour_steps({0, 20}, bottle_path, avoided(5)));
    expect_faults(r, Reason::element_vanishes, {2, 3, 4, 5, 6, 7, 8}, true);
    expect_path(r, {{{0, 5}, Kind::approach},
                    {{50, 5}, Kind::contour},
                    {{54, 3}, Kind::transition},
                    {{58, 5}, Kind::transition},
                    {{100, 5}, Kind::contour}});
}

TEST(clearance, ArcsTighterThanTheTool) {
    // A groove of radius 3 in a straight line, and a tool of radius 5.
    const std::vector<Element> groove{line({0, 0}, {50, 0}), arc({50, 0}, {53, 0}, pi), line({56, 0}, {100, 0})};
    const Result over = run(contour_steps({0, 20}, groove, avoided(5)));
    expect_faults(over, Reason::tool_radius_too_large, {2}, true);
    expect_path(over, {{{0, 5}, Kind::approach},
                       {{50, 5}, Kind::contour},
                       {{53, 4}, Kind::transition},
                       {{56, 5}, Kind::transition},
                       {{100, 5}, Kind::contour}});
    const Result stops = run(contour_steps({0, 20}, groove, reported(5)));
    expect_faults(stops, Reason::tool_radius_too_large, {2}, false);
    EXPECT_LE(largest_gap(stops), 1e-9);
    EXPECT_TRUE(run(contour_steps({0, 20}, groove, reported(3))).faults.empty());
}

TEST(clearance, EventsAndPlungesOfWhatIsLeftOutStayInOrder) {
    auto steps = contour_steps({0, 20}, narrow_slot, avoided(5));
    for (std::size_t i = 0; i < steps.size(); ++i) steps[i].e.before = {static_cast<int>(i)};
    Element down = line({50, -30}, {50, -30});
    down.w_to = -4;
    down.before = {7};
    steps.insert(steps.begin() + 3, {down, avoided(5)});
    std::vector<int> seen;
    double w = 0;
    for (const Output& o : run(steps).out) {
        seen.insert(seen.end(), o.element.before.begin(), o.element.before.end());
        w = std::min(w, o.element.w_to);
    }
    EXPECT_EQ(seen, (std::vector<int>{0, 1, 2, 7, 3, 4, 5}));
    EXPECT_EQ(w, -4);
}

TEST(clearance, ClosedContoursAndFullCircles) {
    const auto inside = polyline({{20, 0}, {40, 0}, {40, 40}, {0, 40}, {0, 0}, {20, 0}});
    for (const Setting& s : {reported(5), avoided(5)}) {
        auto steps = contour_steps({20, 20}, inside, s);
        steps.push_back({line({20, 0}, {20, 20}), {}});
        EXPECT_TRUE(run(steps).faults.empty());
        auto twice = contour_steps({20, 20}, inside, s);
        for (const Element& e : inside) twice.push_back({e, s});
        twice.push_back({line({20, 0}, {20, 20}), {}});
        const Result laps = run(twice);
        EXPECT_TRUE(laps.faults.empty());
        EXPECT_EQ(laps.out.size(), 12u);
        const Result circle =
            run({{line({0, 0}, {20, 0}), s}, {arc({20, 0}, {0, 0}, 2 * pi), s}, {line({20, 0}, {}), {}}});
        EXPECT_TRUE(circle.faults.empty());
        ASSERT_EQ(circle.out.size(), 3u);
        EXPECT_DOUBLE_EQ(circle.out[1].element.sweep, 2 * pi);
    }
}

TEST(clearance, StartingInAnInnerCornerCutsIntoTheFirstElement) {
    for (const Setting& s : {reported(5), avoided(5)}) {
        auto steps = contour_steps({20, 20}, polyline({{0, 0}, {40, 0}, {40, 40}, {0, 40}, {0, 0}}), s);
        steps.push_back({line({0, 0}, {20, 20}), {}});
        const Result r = run(steps);
        expect_faults(r, Reason::interference, {4}, false);
        EXPECT_EQ(r.faults[0].other, 1u);
        EXPECT_NEAR(r.faults[0].at.y, 5, 1e-9);
        EXPECT_EQ(r.out.size(), 6u) << "it begins in the last element's zone, which is no reason to go over to it";
    }
    Setting outside = reported(-5);
    EXPECT_TRUE(
        run(contour_steps({-20, 0}, polyline({{0, 0}, {40, 0}, {40, 40}, {0, 40}, {0, 0}}), outside)).faults.empty());
}

/// Round a ring whose gap is 4 mm wide, its walls included: the tool of radius 5 cuts into the other wall. Passing over
/// "what does not fit" would leave out the ring.
TEST(clearance, AGapInARingIsNoPocket) {
    const auto ring = polyline({{-2, 15}, {-2, 0}, {-20, 0}, {-20, 40}, {20, 40}, {20, 0}, {2, 0}, {2, 15}});
    for (const Setting& s : {reported(5), avoided(5)}) {
        const Result r = run(contour_steps({3, 25}, ring, s));
        ASSERT_FALSE(r.faults.empty());
        for (const Fault& f : r.faults) EXPECT_EQ(f.reason, Reason::interference);
        EXPECT_EQ(r.faults.front().tag, 7u);
        EXPECT_EQ(r.out.size(), 14u);
    }
    EXPECT_TRUE(run(contour_steps({3, 25}, ring, reported(2))).faults.empty());
}

}  // namespace
}  // namespace obrys::path::test
