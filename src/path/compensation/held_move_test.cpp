/// Expectations by hand; held_move_rs274_test.cpp has the comparison with the interpreter.

#include "path/compensation/held_move.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "path/compensation/compensation_testing.hpp"
#include "path/compensation/contour_path.hpp"
#include "path/compensation/preset.hpp"
#include "path/compensation/refusal.hpp"

namespace obrys::path::test {
namespace {

Setting with(Side side, double radius) {
    Setting s = held_move_preset(1);
    s.side = side;
    s.radius = radius;
    return s;
}
Setting held_left(double radius) { return with(Side::left, radius); }
Setting held_right(double radius) { return with(Side::right, radius); }
Setting rapid(Setting s) {
    s.rapid = true;
    return s;
}

struct End {
    double x = 0, y = 0;
    Kind kind = Kind::contour;
};

void expect_ends(const Result& r, const std::vector<End>& expected) {
    ASSERT_EQ(r.out.size(), expected.size());
    for (std::size_t i = 0; i < expected.size(); ++i) {
        SCOPED_TRACE(i);
        EXPECT_NEAR(r.out[i].element.to.x, expected[i].x, 1e-9);
        EXPECT_NEAR(r.out[i].element.to.y, expected[i].y, 1e-9);
        EXPECT_EQ(r.out[i].kind, expected[i].kind);
    }
    EXPECT_LE(largest_gap(r), 1e-9);
}

Refusal refusal_of(const Result& r) {
    if (r.faults.size() != 1) return Refusal::none;
    EXPECT_EQ(r.faults.front().reason, Reason::refused);
    return r.faults.front().refusal;
}

/// Entry to the first point and lines from there under `s`, and an exit.
Result run_lines(const std::vector<Vec2>& points, const Setting& s) {
    std::vector<Step> steps;
    for (std::size_t i = 1; i < points.size(); ++i) {
        steps.push_back({line(points[i - 1], points[i]), i + 1 < points.size() ? s : Setting{}});
        steps.back().e.tag = i;
    }
    return run(steps);
}

TEST(held_move, OuterCornersAreArcsAndInnerOnesCrossings) {
    const Result r = run_lines({{-10, 0}, {0, 0}, {10, 0}, {10, 10}, {20, 10}, {30, 30}}, held_right(2));
    EXPECT_TRUE(r.faults.empty());
    expect_ends(
        r, {{0, -2, Kind::approach}, {10, -2}, {12, 0, Kind::transition}, {12, 8}, {20, 8}, {30, 30, Kind::retract}});
    EXPECT_NEAR(r.out[2].element.sweep, pi / 2, 1e-12);
    EXPECT_EQ(r.out[2].element.centre, (Vec2{10, 0}));
    EXPECT_EQ(r.out[2].element.tag, 3u) << "the arc belongs to the following block";
}

TEST(held_move, EntryIntoAnInnerCornerIsCutShort) {
    const Result r = run_lines({{-10, 0}, {0, 0}, {0, 10}, {-5, 20}}, held_left(2));
    expect_ends(r, {{-2, 2, Kind::approach}, {-2, 10}, {-5, 20, Kind::retract}});
}

TEST(held_move, NegativeRadiusIsTheOtherSide) {
    const std::vector<Vec2> p{{-10, 0}, {0, 0}, {10, 0}, {10, 10}, {0, 30}};
    EXPECT_EQ(run_lines(p, held_left(-2)).out.size(), 5u);
    const Result a = run_lines(p, held_left(-2)), b = run_lines(p, held_right(2));
    for (std::size_t i = 0; i < a.out.size(); ++i) EXPECT_EQ(a.out[i], b.out[i]) << i;
}

TEST(held_move, RadiusZeroIsAsProgrammed) {
    const Result r = run_lines({{-10, 0}, {0, 0}, {10, 0}, {10, 0.1}, {0, 0.1}}, held_left(0));
    EXPECT_TRUE(r.faults.empty());
    expect_ends(r, {{0, 0, Kind::passed}, {10, 0, Kind::passed}, {10, 0.1, Kind::passed}, {0, 0.1, Kind::passed}});
}

TEST(held_move, RadiusNotKnownIsAsProgrammed) {
    const Result r = run_lines({{-10, 0}, {0, 0}, {10, 0}}, held_left(std::nan("")));
    expect_ends(r, {{0, 0, Kind::passed}, {10, 0, Kind::passed}});
}

TEST(held_move, SmallBendsAreNoCorner) {
    const double y = 10 * std::tan(0.049);
    Result r = run_lines({{-10, 0}, {0, 0}, {10, y}, {30, 30}}, held_right(2));
    EXPECT_EQ(r.out.size(), 3u);
    EXPECT_NEAR(r.out[0].element.to.x, 0, 1e-12) << "nor is the held move's end moved";
    r = run_lines({{-10, 0}, {0, 0}, {10, 10 * std::tan(0.051)}, {30, 30}}, held_right(2));
    ASSERT_EQ(r.out.size(), 4u);
    EXPECT_EQ(r.out[1].kind, Kind::transition);
}

TEST(held_move, RapidGoesRoundByLines) {
    std::vector<Step> steps{{line({-10, 0}, {0, 0}), held_right(2)},
                            {line({0, 0}, {0, 10}), rapid(held_right(2))},
                            {line({0, 10}, {-10, 30}), {}}};
    const Result r = run(steps);
    expect_ends(r, {{0, -2, Kind::approach}, {2, 0, Kind::transition}, {2, 10}, {-10, 30, Kind::retract}});
    EXPECT_FALSE(is_arc(r.out[1].element));
}

TEST(held_move, MovesAlongWGoWithTheCorner) {
    Element down = line({0, 0}, {0, 0}, 5);
    down.w_to = 1;
    const Result r = run({{line({-10, 0}, {0, 0}, 5), held_left(2)},
                          {down, held_left(2)},
                          {line({0, 0}, {0, 10}, 1), held_left(2)},
                          {line({0, 10}, {-5, 20}, 1), {}}});
    expect_ends(r, {{-2, 2, Kind::approach}, {-2, 2}, {-2, 10}, {-5, 20, Kind::retract}});
    EXPECT_EQ(r.out[1].element.w_from, 5);
    EXPECT_EQ(r.out[1].element.w_to, 1);
}

TEST(held_move, EntryArcIsEquallyFarFromBothEnds) {
    const Result r = run({{arc({0, 0}, {10, 0}, -pi / 2), held_left(2)}, {line({10, 10}, {20, 10}), held_left(2)}});
    expect_ends(r, {{10, 12, Kind::approach}, {20, 12}});
    const Element& e = r.out.front().element;
    EXPECT_NEAR(e.centre.x, 10, 1e-9) << "under the end of the programmed arc";
    EXPECT_NEAR(geom::distance(e.centre, e.from), geom::distance(e.centre, e.to), 1e-9);
}

TEST(held_move, FullCirclesStayFull) {
    for (const double sweep : {2 * pi, -2 * pi, 4 * pi}) {
        SCOPED_TRACE(sweep);
        const Result r = run(
            {{line({-10, 0}, {0, 0}), held_left(2)}, {arc({0, 0}, {0, std::copysign(5, sweep)}, sweep), held_left(2)}});
        ASSERT_EQ(r.out.size(), 2u);
        EXPECT_NEAR(r.out[1].element.sweep, sweep, 1e-9);
        EXPECT_NEAR(geom::distance(r.out[1].element.to, {0, 2}), 0, 1e-9);
    }
}

TEST(held_move, LatheNoseIsMovedOnToItsEntryArc) {
    Setting s = held_left(2);
    s.tip = table_nose_offset(2, 2).value();
    EXPECT_EQ(s.tip, (Vec2{-2, -2}));
    const Result r =
        run({{arc({0, 0}, {10, 0}, -pi / 2), s}, {line({10, 10}, {20, 10}), s}, {line({20, 10}, {30, 30}), {}}});
    expect_ends(r, {{-2, -2, Kind::approach}, {8, 10, Kind::approach}, {18, 10}, {30, 30, Kind::retract}});
}

TEST(held_move, NoseOffsetsByOrientation) {
    EXPECT_EQ(table_nose_offset(0, 2), (Vec2{0, 0}));
    EXPECT_EQ(table_nose_offset(9, 2), (Vec2{0, 0}));
    EXPECT_EQ(table_nose_offset(6, 2), (Vec2{0, -2}));
    EXPECT_EQ(table_nose_offset(4, 2), (Vec2{2, 2}));
    EXPECT_EQ(table_nose_offset(10, 2), std::nullopt);
}

TEST(held_move, TooShortToEnter) {
    EXPECT_EQ(refusal_of(run_lines({{-2, 0}, {0, 0}, {10, 0}}, held_left(2))), Refusal::entry_line_short);
    const Result r = run({{arc({0, 0}, {0, 5}, 0.2), held_right(2)}});
    EXPECT_EQ(refusal_of(r), Refusal::entry_arc_short);
    EXPECT_EQ(message(r.faults.front()), "Radius of cutter compensation entry arc is not greater than the tool radius");
    EXPECT_TRUE(r.out.empty());
}

TEST(held_move, ArcTighterThanTheTool) {
    const Result r = run({{line({-10, 0}, {0, 0}), held_left(2)}, {arc({0, 0}, {0, 2}, pi / 2), held_left(2)}});
    EXPECT_EQ(refusal_of(r), Refusal::arc_too_tight);
    EXPECT_EQ(message(r.faults.front()), "Tool radius not less than arc radius with comp");
}

TEST(held_move, LineTurnedRoundByItsCorners) {
    const Result r = run_lines({{-10, 0}, {0, 0}, {0, 3}, {-10, 3}, {-20, 3}}, held_left(2));
    EXPECT_EQ(refusal_of(r), Refusal::feed_reversed);
    EXPECT_EQ(r.faults.front().tag, 3u) << "the block whose corner is found to be beyond the held move";
    expect_ends(r, {{-2, 2, Kind::approach}, {-20, 3, Kind::retract}});
}

TEST(held_move, RefusedOnlyWhereTheBlockSwitchesOff) {
    ContourPath path;
    std::size_t count = 0;
    const auto out = [&count](const Output&) { ++count; };
    const std::vector<Vec2> p{{-10, 0}, {0, 0}, {0, 1}};
    for (std::size_t i = 0; i < 2; ++i) EXPECT_TRUE(path.push(line(p[i], p[i + 1]), held_left(2), {}, out).empty());
    EXPECT_EQ(count, 1u);
    const PathFaults faults = path.switch_off(out);
    ASSERT_EQ(faults.compensation.size(), 1u);
    EXPECT_EQ(faults.compensation.front().refusal, Refusal::feed_reversed);
    EXPECT_FALSE(path.idle()) << "who goes on nevertheless goes on from where the tool stands";
}

TEST(held_move, SwitchedOnAndOffWithoutAMove) {
    ContourPath path;
    const auto out = [](const Output&) {};
    EXPECT_TRUE(path.switch_off(out).empty());
    EXPECT_TRUE(path.idle());
}

TEST(held_move, ExitMustBeStraight) {
    const Result r = run({{line({-10, 0}, {0, 0}), held_left(2)},
                          {line({0, 0}, {10, 0}), held_left(2)},
                          {arc({10, 0}, {10, 5}, pi), {}},
                          {line({10, 10}, {0, 10}), {}}});
    EXPECT_EQ(refusal_of(r), Refusal::arc_after_off);
    expect_ends(r, {{0, 2, Kind::approach}, {10, 2}, {0, 10, Kind::retract}});
}

TEST(held_move, SideCannotChangeWhileSelected) {
    const Result r = run({{line({-10, 0}, {0, 0}), held_left(2)}, {line({0, 0}, {10, 0}), held_right(2)}});
    EXPECT_EQ(refusal_of(r), Refusal::already_on);
}

TEST(held_move, SelectedAnewBeforeTheExitMove) {
    ContourPath path;
    std::vector<Output> all;
    const auto out = [&all](const Output& o) { all.push_back(o); };
    static_cast<void>(path.push(line({-10, 0}, {0, 0}), held_left(2), {}, out));
    static_cast<void>(path.switch_off(out));
    static_cast<void>(path.push(line({0, 0}, {10, 0}), held_right(1), {}, out));
    static_cast<void>(path.flush(out));
    ASSERT_EQ(all.size(), 2u);
    EXPECT_EQ(all[1].element.from, (Vec2{0, 2})) << "from where the tool stands";
    EXPECT_EQ(all[1].element.to, (Vec2{10, -1})) << "to the point that the programmed line gives";
}

TEST(held_move, EventsKeepTheirPlace) {
    std::vector<Step> steps{{line({-10, 0}, {0, 0}), held_right(2)},
                            {line({0, 0}, {10, 0}), held_right(2)},
                            {line({10, 0}, {10, 10}), held_right(2)},
                            {line({10, 10}, {30, 30}), {}}};
    for (std::size_t i = 0; i < steps.size(); ++i) steps[i].e.before = {static_cast<int>(i)};
    const Result r = run(steps);
    ASSERT_EQ(r.out.size(), 5u);
    EXPECT_EQ(r.out[2].kind, Kind::transition);
    EXPECT_EQ(r.out[2].element.before, Events{2}) << "F of a block holds round the corner that leads to it";
    EXPECT_TRUE(r.out[3].element.before.empty());
    EXPECT_EQ(r.out[4].element.before, Events{3});
}

/// Whatever is asked for, and also behind refusals, the path has no gap, and every event of a contour that is not
/// refused comes out once and in order.
TEST(held_move, ConnectedWhateverIsAskedFor) {
    for (std::uint32_t seed = 1; seed <= 2000; ++seed) {
        SCOPED_TRACE(seed);
        Random random(seed);
        Compensation c;
        Result r;
        const auto sink = [&r](const Output& o) {
            if (moves(o.element)) r.out.push_back(o);  // what brings events alone may stand anywhere
            for (const int event : o.element.before)
                r.faults.push_back({Reason::refused, static_cast<std::uint64_t>(event), 0, {}, false});
        };
        bool refused = false;
        Vec2 at;
        Setting s;
        int events = 0;
        for (int i = 0; i < 20; ++i) {
            if (random.upto(4) == 0) s = random.upto(1) == 0 ? Setting{} : held_left(random.in(-2, 2));
            if (random.upto(9) == 0) refused |= !c.switch_off(sink).empty();
            if (random.upto(9) == 0) refused |= !c.flush(sink).empty();
            const Vec2 to = random.upto(9) == 0 ? at : Vec2{random.in(-9, 9), random.in(-9, 9)};
            Element e = random.upto(2) == 0 ? arc(at, to, random.in(-7, 7)) : line(at, to);
            at = e.to;
            e.before = {++events};
            s.rapid = random.upto(3) == 0;
            refused |= !c.push(Element(e), s, sink).empty();
        }
        refused |= !c.flush(sink).empty();
        EXPECT_LE(largest_gap(r), 1e-9);
        for (std::size_t i = 1; i < r.faults.size(); ++i) EXPECT_LT(r.faults[i - 1].tag, r.faults[i].tag);
        if (!refused) {
            EXPECT_EQ(r.faults.size(), static_cast<std::size_t>(events));
        }
    }
}

TEST(held_move, NumbersThatAreNoneDoNoHarm) {
    const double odd[]{0, 1, -1, 1e308, std::nan(""), HUGE_VAL, 1e-308};
    for (std::uint32_t seed = 1; seed <= 2000; ++seed) {
        Random random(seed);
        const auto some = [&] { return odd[random.upto(6)]; };
        std::vector<Step> steps;
        for (int i = 0; i < 5; ++i) {
            Element e = line({some(), some()}, {some(), some()}, some());
            e.centre = {some(), some()};
            e.sweep = random.upto(1) == 0 ? 0 : some();
            steps.push_back({e, held_left(some())});
        }
        EXPECT_LE(run(steps).out.size(), 20u);
    }
}

TEST(held_move, EveryRefusalHasWords) {
    for (int i = 1; i <= static_cast<int>(Refusal::already_on); ++i) {
        Fault f;
        f.refusal = static_cast<Refusal>(i);
        EXPECT_FALSE(message(f).empty()) << i;
    }
    Fault f;
    f.refusal = Refusal::radii_differ;
    f.radius_was = 25.4;
    f.radius_is = 50.8;
    EXPECT_EQ(message(f, 25.4),
              "BUG: cutter compensation has generated an invalid arc with mismatched radii r1 1.000000 r2 2.000000");
}

}  // namespace
}  // namespace obrys::path::test
