#include <gtest/gtest.h>

#include "cycles/mill/mill.hpp"
#include "cycles/mill/milling_testing.hpp"
#include "cycles/shapes.hpp"
#include "geom/offset.hpp"

namespace obrys::cycles {
namespace {

using cl::CycleValue;
using testing::covered;
using testing::expect_sound;
using testing::milled_levels;
using testing::Move;
using testing::moves_of;
using testing::with;
using Kind = cl::CycleKind;
using Role = cl::CycleRole;
using geom::Region;
using geom::Vec2;
using geom::Vec3;

constexpr Vec3 pocket_start{50, 40, 60};

Situation pocket_mill(double radius) {
    Situation s;
    s.at = pocket_start;
    s.tool_radius = radius;
    s.spindle_speed = 2000;
    s.spindle_direction = 1;
    s.tool_plunge_angle = 5;
    return s;
}

Demand pocket_251() {
    return {Kind::rectangular_pocket,
            {{Role::operation, 1},         {Role::length, 60},       {Role::width, 40},    {Role::corner_radius, 6},
             {Role::allowance_side, 0.4},  {Role::rotation, 30},     {Role::position, 0},  {Role::feed_mill, 500},
             {Role::direction, 1},         {Role::depth, -12},       {Role::infeed, 5},    {Role::allowance_floor, 0.2},
             {Role::feed_plunge, 150},     {Role::finish_infeed, 6}, {Role::clearance, 2}, {Role::surface, 10},
             {Role::second_clearance, 50}, {Role::overlap, 1},       {Role::plunge, 0},    {Role::feed_finish, 400}}};
}

const Region pocket{{placed(rectangle(60, 40, 6), geom::radians(30), {50, 40})}};

void expect_covers(const std::vector<Move>& moves, const Region& region, double side, double radius, double height) {
    const geom::Box b = geom::box(region);
    const Region reach = geom::offset(geom::offset(region, -radius - side), radius);
    for (double u = b.lo.x + 0.1; u < b.hi.x; u += 0.9)
        for (double v = b.lo.y + 0.1; v < b.hi.y; v += 0.9)
            if (geom::contains(reach, {u, v})) {
                EXPECT_TRUE(covered(moves, {u, v}, radius, height)) << u << ' ' << v;
            }
}

TEST(Pocket, RoughingKeepsItsAllowances) {
    const Expansion e = expand_mill(pocket_251(), pocket_mill(5));
    ASSERT_TRUE(e.ok()) << (e.complaints.empty() ? "" : e.complaints[0].text);
    EXPECT_FALSE(e.assumption.empty());
    const auto moves = moves_of(e, pocket_start);
    expect_sound(moves, pocket, {.surface = 10, .bottom = -1.8, .plunge = 150, .mill = 500, .away = 5.4});
    EXPECT_EQ(milled_levels(moves), (std::set<double>{5, 0, -1.8}));
    for (const double level : {5.0, 0.0, -1.8}) expect_covers(moves, pocket, 0.4, 5, level);
    // Back above the centre at the second clearance.
    EXPECT_NEAR(moves.back().samples.back().x, 50, 1e-9);
    EXPECT_NEAR(moves.back().samples.back().y, 40, 1e-9);
    EXPECT_EQ(moves.back().to, 60);
}

TEST(Pocket, GoesDownInTheCentre) {
    for (const double how : {0.0, 1.0, 2.0}) {
        const Expansion e = expand_mill(with(pocket_251(), Role::plunge, how), pocket_mill(5));
        ASSERT_TRUE(e.ok());
        const auto moves = moves_of(e, pocket_start);
        expect_sound(moves, pocket, {.surface = 10, .bottom = -1.8, .plunge = 150, .mill = 500, .away = 5.4});
        double steepest = 0;
        bool oblique = false;
        for (const Move& m : moves) {
            if (m.rapid || m.to >= m.from || m.to >= 10) continue;
            if (m.vertical()) continue;
            oblique = true;
            double way = 0;
            for (std::size_t i = 1; i < m.samples.size(); ++i) way += geom::distance(m.samples[i - 1], m.samples[i]);
            steepest = std::max(steepest, (m.from - m.to) / way);
            EXPECT_EQ(m.feed, 150);
        }
        EXPECT_EQ(oblique, how != 0);
        EXPECT_LE(steepest, std::tan(geom::radians(5)) * 1.01);
    }
}

TEST(Pocket, RoughingAndFinishingReachTheContour) {
    const Expansion e = expand_mill(with(pocket_251(), Role::operation, 0), pocket_mill(5));
    ASSERT_TRUE(e.ok());
    const auto moves = moves_of(e, pocket_start);
    expect_sound(moves, pocket, {.surface = 10, .bottom = -2, .plunge = 150, .mill = 0, .away = 5 - 1e-6});
    EXPECT_EQ(*milled_levels(moves).begin(), -2);
    expect_covers(moves, pocket, 0, 5, -2);
    // The wall in infeeds of 6, at the finishing feed.
    double nearest = 1e9;
    for (const Move& m : moves)
        if (!m.rapid && m.from == m.to && m.to == 4 && m.feed == 400)
            for (const Vec2 p : m.samples) nearest = std::min(nearest, geom::distance(pocket, p));
    EXPECT_NEAR(nearest, 5, 1e-6);
}

TEST(Pocket, FinishingWithoutAllowanceDoesNothing) {
    Demand d = with(pocket_251(), Role::operation, 2);
    d = with(with(d, Role::allowance_side, 0), Role::allowance_floor, 0);
    const auto moves = moves_of(expand_mill(d, pocket_mill(5)), pocket_start);
    EXPECT_TRUE(milled_levels(moves).empty());
}

TEST(Pocket, CircularAndItsHelix) {
    const Demand d{Kind::circular_pocket,
                   {{Role::diameter, 30},
                    {Role::allowance_side, 0.5},
                    {Role::feed_mill, 500},
                    {Role::depth, -7},
                    {Role::infeed, 4},
                    {Role::feed_plunge, 150},
                    {Role::clearance, 2},
                    {Role::surface, 0},
                    {Role::overlap, 1.4},
                    {Role::plunge, 1},
                    {Role::operation, 1}}};
    const Expansion e = expand_mill(d, pocket_mill(4));
    ASSERT_TRUE(e.ok());
    const auto moves = moves_of(e, pocket_start);
    const Region region{{placed(disc(15), 0, {50, 40})}};
    expect_sound(moves, region, {.surface = 0, .bottom = -7, .plunge = 150, .mill = 500, .away = 4.5});
    EXPECT_EQ(milled_levels(moves), (std::set<double>{-4, -7}));
    expect_covers(moves, region, 0.5, 4, -7);
}

TEST(Pocket, OldForms) {
    Situation s = pocket_mill(5);
    s.at.z = 2;
    const Demand d{Kind::rectangular_pocket_simple,
                   {{Role::clearance, -2},
                    {Role::depth, -10},
                    {Role::infeed, -4},
                    {Role::feed_plunge, 80},
                    {Role::axis_x, 60},
                    {Role::axis_y, 40},
                    {Role::feed_mill, 100},
                    {Role::direction, 1},
                    {Role::corner_radius, 5}}};
    const Expansion e = expand_mill(d, s);
    ASSERT_TRUE(e.ok());
    auto moves = moves_of(e, s.at);
    const Region region{{placed(rectangle(60, 40, 5), 0, {50, 40})}};
    expect_sound(moves, region, {.surface = 0, .bottom = -10, .plunge = 80, .mill = 100, .away = 5});
    EXPECT_EQ(milled_levels(moves), (std::set<double>{-4, -8, -10}));
    expect_covers(moves, region, 0, 5, -10);
    EXPECT_EQ(moves.back().to, 2);
    const Demand round{Kind::circular_pocket_simple,
                       {{Role::clearance, 2},
                        {Role::depth, -6},
                        {Role::infeed, 6},
                        {Role::feed_plunge, 80},
                        {Role::radius, 20},
                        {Role::feed_mill, 100},
                        {Role::direction, -1}}};
    moves = moves_of(expand_mill(round, s), s.at);
    expect_sound(moves, {{placed(disc(20), 0, {50, 40})}},
                 {.surface = 0, .bottom = -6, .plunge = 80, .mill = 100, .away = 5});
}

TEST(Pocket, BadInputIsComplainedOf) {
    const auto complaint = [](const Demand& d, const Situation& s) {
        const Expansion e = expand_mill(d, s);
        EXPECT_FALSE(e.ok());
        EXPECT_TRUE(e.steps.empty());
        return e.complaints.empty() ? std::string() : e.complaints.front().text;
    };
    EXPECT_NE(complaint(pocket_251(), pocket_mill(20.5)).find("u 50.000 v 40.000"), std::string::npos);
    EXPECT_NE(complaint(with(pocket_251(), Role::infeed, 0), pocket_mill(5)), "");
    EXPECT_NE(complaint(with(pocket_251(), Role::infeed, -3), pocket_mill(5)), "");
    EXPECT_NE(complaint(with(pocket_251(), Role::overlap, 0), pocket_mill(5)), "");
    EXPECT_NE(complaint(with(pocket_251(), Role::overlap, 1e-9), pocket_mill(5)), "");
    EXPECT_NE(complaint(with(pocket_251(), Role::corner_radius, 21), pocket_mill(5)), "");
    EXPECT_NE(complaint(with(pocket_251(), Role::operation, 7), pocket_mill(5)), "");
    EXPECT_NE(complaint(with(pocket_251(), Role::depth, 12), pocket_mill(5)), "");
    EXPECT_NE(complaint(pocket_mill(5).tool_radius > 0 ? with(pocket_251(), Role::infeed, 1e-9) : pocket_251(),
                        pocket_mill(5)),
              "");
    Situation unknown_radius = pocket_mill(5);
    unknown_radius.tool_radius = unknown;
    const Expansion e = expand_mill(pocket_251(), unknown_radius);
    EXPECT_FALSE(e.simulated);
    EXPECT_TRUE(e.steps.empty());
    EXPECT_FALSE(expand_mill(with(pocket_251(), Role::length, unknown), pocket_mill(5)).simulated);
    Situation no_angle = pocket_mill(5);
    no_angle.tool_plunge_angle = 0;
    EXPECT_FALSE(expand_mill(with(pocket_251(), Role::plunge, 1), no_angle).ok());
    no_angle.tool_plunge_angle = unknown;
    EXPECT_TRUE(expand_mill(with(pocket_251(), Role::plunge, 1), no_angle).ok());
}

TEST(Slot, NarrowAndWide) {
    for (const double width : {10.0, 13.0, 34.0}) {
        const Demand d{Kind::slot,
                       {{Role::operation, 0},
                        {Role::length, 70},
                        {Role::width, width},
                        {Role::rotation, 20},
                        {Role::allowance_side, width == 10 ? 0 : 0.3},
                        {Role::position, 0},
                        {Role::feed_mill, 500},
                        {Role::depth, -8},
                        {Role::infeed, 3},
                        {Role::allowance_floor, 0},
                        {Role::feed_plunge, 150},
                        {Role::clearance, 2},
                        {Role::surface, 0},
                        {Role::plunge, 2}}};
        const Expansion e = expand_mill(d, pocket_mill(5));
        ASSERT_TRUE(e.ok()) << width;
        const auto moves = moves_of(e, pocket_start);
        const Region region{{placed(long_slot(70, width), geom::radians(20), {50, 40})}};
        expect_sound(moves, region, {.surface = 0, .bottom = -8, .plunge = 150, .mill = 500, .away = 5});
        EXPECT_EQ(*milled_levels(moves).begin(), -8);
        expect_covers(moves, region, width == 10 ? -1e-7 : 0, 5 - 1e-3, -8);
    }
}

TEST(Slot, OnAnArcSeveral) {
    const Demand d{Kind::round_slot,
                   {{Role::operation, 1},
                    {Role::width, 12},
                    {Role::pitch_circle, 80},
                    {Role::position, 0},
                    {Role::centre_u, 10},
                    {Role::centre_v, 20},
                    {Role::start_angle, 30},
                    {Role::angle_length, 50},
                    {Role::angle_step, 120},
                    {Role::count, 3},
                    {Role::feed_mill, 500},
                    {Role::depth, -5},
                    {Role::infeed, 5},
                    {Role::feed_plunge, 150},
                    {Role::clearance, 2},
                    {Role::surface, 0}}};
    const Expansion e = expand_mill(d, pocket_mill(4));
    ASSERT_TRUE(e.ok());
    const auto moves = moves_of(e, pocket_start);
    Region all;
    for (const double turn : {0.0, 120.0, 240.0}) {
        geom::Contour c = round_slot(40, 12, geom::radians(30 + turn), geom::radians(50)).contours.front();
        all.contours.push_back(geom::moved(c, {10, 20}));
    }
    expect_sound(moves, all, {.surface = 0, .bottom = -5, .plunge = 150, .mill = 500, .away = 4});
    expect_covers(moves, all, 0, 4, -5);
    EXPECT_NEAR(geom::area({{round_slot(40, 12, 0, 1).contours.front()}}), 40 * 12 + geom::pi * 36, 1e-9);
    EXPECT_NEAR(geom::area(round_slot(40, 12, 0, 7)), geom::pi * (46.0 * 46 - 34 * 34), 1e-9);
}

TEST(Slot, PlacesOfTheFigure) {
    // Left end called, left arc's centre called: where the slot's left end lies.
    const double lefts[] = {15, 50, 45, -15, -20};
    for (const int position : {0, 1, 2, 3, 4}) {
        const Demand d{Kind::slot,
                       {{Role::operation, 1},
                        {Role::length, 70},
                        {Role::width, 10},
                        {Role::position, double(position)},
                        {Role::feed_mill, 500},
                        {Role::depth, -3},
                        {Role::infeed, 3},
                        {Role::feed_plunge, 150},
                        {Role::clearance, 2},
                        {Role::surface, 0}}};
        double least = 1e9;
        for (const Move& m : moves_of(expand_mill(d, pocket_mill(5)), pocket_start))
            if (!m.rapid)
                for (const Vec2 p : m.samples) least = std::min(least, p.x - 5);
        EXPECT_NEAR(least, lefts[position], 1e-9) << position;
    }
}

TEST(Slot, Reciprocating) {
    const Demand d{Kind::slot_reciprocating,
                   {{Role::clearance, 2},
                    {Role::depth, -9},
                    {Role::feed_mill, 300},
                    {Role::infeed, 2},
                    {Role::operation, 0},
                    {Role::surface, 0},
                    {Role::second_clearance, 20},
                    {Role::centre_u, 30},
                    {Role::centre_v, 10},
                    {Role::length, 60},
                    {Role::width, 12},
                    {Role::rotation, 90},
                    {Role::finish_infeed, 0},
                    {Role::feed_plunge, 150}}};
    const Expansion e = expand_mill(d, pocket_mill(5));
    ASSERT_TRUE(e.ok());
    const auto moves = moves_of(e, pocket_start);
    const Region region{{placed(long_slot(60, 12), geom::pi / 2, {30, 10})}};
    expect_sound(moves, region, {.surface = 0, .bottom = -9, .plunge = 150, .mill = 300, .away = 5});
    expect_covers(moves, region, 0, 5, -9);
    EXPECT_FALSE(expand_mill(with(d, Role::width, 9), pocket_mill(5)).ok());
    EXPECT_FALSE(expand_mill(with(d, Role::width, 40), pocket_mill(5)).ok());
    const Demand round{Kind::round_slot_reciprocating,
                       {{Role::clearance, 2},
                        {Role::depth, -9},
                        {Role::feed_mill, 300},
                        {Role::infeed, 2},
                        {Role::operation, 0},
                        {Role::surface, 0},
                        {Role::centre_u, 30},
                        {Role::centre_v, 10},
                        {Role::pitch_circle, 70},
                        {Role::width, 12},
                        {Role::start_angle, -20},
                        {Role::angle_length, 200},
                        {Role::feed_plunge, 150}}};
    const auto round_moves = moves_of(expand_mill(round, pocket_mill(5)), pocket_start);
    Region bent = round_slot(35, 12, geom::radians(-20), geom::radians(200));
    for (auto& c : bent.contours) c = geom::moved(c, {30, 10});
    expect_sound(round_moves, bent, {.surface = 0, .bottom = -9, .plunge = 150, .mill = 300, .away = 5});
    expect_covers(round_moves, bent, 0, 5, -9);
}

/// The stud as a hole in a large region, so that the same rules hold.
Region outside_of(const geom::Contour& stud) { return {{rectangle(4000, 4000, 0), geom::reversed(stud)}}; }

TEST(Stud, RectangularFromItsBlank) {
    const Demand d{Kind::rectangular_stud,
                   {{Role::length, 40},
                    {Role::blank_length, 64},
                    {Role::width, 30},
                    {Role::blank_width, 50},
                    {Role::corner_radius, 3},
                    {Role::allowance_side, 0.2},
                    {Role::rotation, 15},
                    {Role::position, 0},
                    {Role::feed_mill, 500},
                    {Role::direction, 1},
                    {Role::depth, -10},
                    {Role::infeed, 4},
                    {Role::feed_plunge, 150},
                    {Role::clearance, 2},
                    {Role::surface, 0},
                    {Role::second_clearance, 30},
                    {Role::overlap, 1}}};
    const Expansion e = expand_mill(d, pocket_mill(6));
    ASSERT_TRUE(e.ok());
    const auto moves = moves_of(e, pocket_start);
    const geom::Contour stud = placed(rectangle(40, 30, 3), geom::radians(15), {50, 40});
    expect_sound(moves, outside_of(stud), {.surface = 0, .bottom = -10, .plunge = 150, .mill = 500, .away = 6.2});
    EXPECT_EQ(milled_levels(moves), (std::set<double>{-4, -8, -10}));
    // Everything of the blank is gone.
    const Region left{{placed(rectangle(64, 50, 0), geom::radians(15), {50, 40})}};
    const Region kept = geom::offset({{stud}}, 0.2);
    for (double u = 10; u < 90; u += 0.7)
        for (double v = 5; v < 75; v += 0.7)
            if (geom::contains(left, {u, v}) && !geom::contains(kept, {u, v})) {
                EXPECT_TRUE(covered(moves, {u, v}, 6, -10)) << u << ' ' << v;
            }
    EXPECT_FALSE(expand_mill(with(d, Role::blank_length, 30), pocket_mill(6)).ok());
}

TEST(Stud, CircularClimbsClockwise) {
    const Demand d{Kind::circular_stud,
                   {{Role::diameter, 40},
                    {Role::blank_diameter, 60},
                    {Role::feed_mill, 500},
                    {Role::direction, 1},
                    {Role::depth, -4},
                    {Role::infeed, 4},
                    {Role::feed_plunge, 150},
                    {Role::clearance, 2},
                    {Role::surface, 0},
                    {Role::overlap, 1}}};
    const Expansion e = expand_mill(d, pocket_mill(6));
    ASSERT_TRUE(e.ok());
    expect_sound(moves_of(e, pocket_start), outside_of(placed(disc(20), 0, {50, 40})),
                 {.surface = 0, .bottom = -4, .plunge = 150, .mill = 500, .away = 6});
    double turned = 0;
    for (const cl::Step& s : e.steps)
        if (const auto* a = std::get_if<cl::Arc>(&s); a != nullptr && std::abs(a->centre.x - 50) < 1e-6)
            turned += a->sweep;
    EXPECT_NEAR(turned, -2 * 2 * geom::pi, 1e-6);  // two passes
}

TEST(Finishing, PocketsAndStuds) {
    const std::vector<CycleValue> common{{Role::clearance, 2},
                                         {Role::depth, -9},
                                         {Role::feed_plunge, 150},
                                         {Role::infeed, 4},
                                         {Role::feed_mill, 500},
                                         {Role::surface, 0},
                                         {Role::second_clearance, 20},
                                         {Role::centre_u, 10},
                                         {Role::centre_v, 5},
                                         {Role::length, 60},
                                         {Role::width, 40},
                                         {Role::corner_radius, 8},
                                         {Role::diameter, 50}};
    const geom::Contour box = placed(rectangle(60, 40, 8), 0, {10, 5}), round = placed(disc(25), 0, {10, 5});
    const auto check = [&](Kind kind, const Region& region) {
        const Expansion e = expand_mill({kind, common}, pocket_mill(5));
        ASSERT_TRUE(e.ok());
        const auto moves = moves_of(e, pocket_start);
        expect_sound(moves, region, {.surface = 0, .bottom = -9, .plunge = 150, .mill = 500, .away = 5});
        EXPECT_EQ(milled_levels(moves), (std::set<double>{-4, -8, -9}));
        EXPECT_NEAR(moves.back().samples.back().x, 10, 1e-9);
        double nearest = 1e9;
        for (const Move& m : moves)
            if (m.from == m.to && m.to < 0)
                for (const Vec2 p : m.samples) nearest = std::min(nearest, geom::distance(region, p));
        EXPECT_NEAR(nearest, 5, 1e-9);
    };
    check(Kind::rectangular_pocket_finish, {{box}});
    check(Kind::rectangular_stud_finish, outside_of(box));
    check(Kind::circular_pocket_finish, {{round}});
    check(Kind::circular_stud_finish, outside_of(round));
    EXPECT_FALSE(expand_mill({Kind::circular_pocket_finish, common}, pocket_mill(26)).ok());
}

}  // namespace
}  // namespace obrys::cycles
