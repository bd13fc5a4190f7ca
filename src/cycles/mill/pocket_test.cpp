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

Demand pocket_251() {
    return {Kind::rectangular_pocket,
            {{Role::operation, 1},         {Role::length, 60},       {Role::width, 40},    {Role::corner_radius, 6},
             {Role::allowance_side, 0.4},  {Role::rotation, 30},     {Role::position, 0},  {Role::feed_mill, 500},
             {Role::direction, 1},         {Role::depth, -12},       {Role::infeed, 5},    {Role::allowance_floor, 0.2},
             {Role::feed_plunge, 150},     {Role::finish_infeed, 6}, {Role::clearance, 2}, {Role::surface, 10},
             {Role::second_clearance, 50}, {Role::overlap, 1},       {Role::plunge, 0},    {Role::feed_finish, 400}}};
}

const Region pocket{{placed(rectangle(60, 40, 6), geom::radians(30), {50, 40})}};

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
