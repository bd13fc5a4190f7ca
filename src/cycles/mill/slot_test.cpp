#include <gtest/gtest.h>

#include "cycles/mill/mill.hpp"
#include "cycles/mill/pocket_testing.hpp"
#include "cycles/shapes.hpp"
#include "geom/offset.hpp"

namespace obrys::cycles {
namespace {

using cl::CycleValue;
using testing::covered;
using testing::expect_covers;
using testing::expect_sound;
using testing::milled_levels;
using testing::Move;
using testing::moves_of;
using testing::outside_of;
using testing::pocket_mill;
using testing::pocket_start;
using testing::with;
using Kind = cl::CycleKind;
using Role = cl::CycleRole;
using geom::Region;
using geom::Vec2;
using geom::Vec3;

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

}  // namespace
}  // namespace obrys::cycles
