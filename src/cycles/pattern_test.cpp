#include "cycles/pattern.hpp"

#include <gtest/gtest.h>

#include "cycles/cycle_testing.hpp"

namespace obrys::cycles::test {
namespace {

using geom::Vec2;

void expect_at(const Positions& p, const std::vector<Vec2>& expected) {
    ASSERT_TRUE(p.ok());
    ASSERT_EQ(p.at.size(), expected.size());
    for (std::size_t i = 0; i < expected.size(); ++i)
        EXPECT_NEAR(geom::distance(p.at[i], expected[i]), 0, 1e-9) << i << ": " << p.at[i].x << ' ' << p.at[i].y;
}

const Values circle = {
    {Role::centre_u, 50}, {Role::centre_v, 40}, {Role::pitch_circle, 20}, {Role::start_angle, 0}, {Role::count, 4}};
const Values point_grid = {{Role::start_u, 10}, {Role::start_v, 5}, {Role::spacing_u, 10}, {Role::spacing_v, 8},
                           {Role::columns, 3},  {Role::rows, 2},    {Role::rotation, 0}};

TEST(pattern, FullCircle) {
    expect_at(pattern_positions({Kind::pattern_circle, with(circle, {{Role::end_angle, 360}})}),
              {{60, 40}, {50, 50}, {40, 40}, {50, 30}});
}

TEST(pattern, PartOfACircleReachesItsEnd) {
    expect_at(pattern_positions({Kind::pattern_circle, with(circle, {{Role::end_angle, -90}, {Role::count, 3}})}),
              {{60, 40}, {50 + std::sqrt(50.0), 40 - std::sqrt(50.0)}, {50, 30}});
}

TEST(pattern, SteppingAngleGoesBeforeTheStoppingAngle) {
    expect_at(pattern_positions({Kind::pattern_circle,
                                 with(circle, {{Role::end_angle, 360}, {Role::angle_step, 180}, {Role::count, 2}})}),
              {{60, 40}, {40, 40}});
}

TEST(pattern, TraverseIsHandedOn) {
    const Positions p =
        pattern_positions({Kind::pattern_circle,
                           with(circle, {{Role::end_angle, 360}, {Role::move_at_clearance, 0}, {Role::traverse, 1}})});
    EXPECT_FALSE(p.at_second_clearance);
    EXPECT_TRUE(p.along_circle);
    EXPECT_EQ(p.centre, (Vec2{50, 40}));
}

TEST(pattern, LinesBackAndForth) {
    expect_at(pattern_positions({Kind::pattern_lines, point_grid}),
              {{10, 5}, {20, 5}, {30, 5}, {30, 13}, {20, 13}, {10, 13}});
    expect_at(pattern_positions({Kind::pattern_lines, with(point_grid, {{Role::rotation, 90}, {Role::columns, 2}})}),
              {{10, 5}, {10, 15}, {2, 15}, {2, 5}});
}

TEST(pattern, BadInput) {
    EXPECT_FALSE(pattern_positions({Kind::pattern_lines, with(point_grid, {{Role::columns, 0}})}).ok());
    EXPECT_FALSE(pattern_positions({Kind::pattern_lines, with(point_grid, {{Role::columns, 2.5}})}).ok());
    EXPECT_FALSE(pattern_positions({Kind::pattern_lines, with(point_grid, {{Role::columns, 1e9}})}).ok());
    EXPECT_FALSE(
        pattern_positions({Kind::pattern_lines, with(point_grid, {{Role::columns, 9e4}, {Role::rows, 9e4}})}).ok());
    EXPECT_FALSE(pattern_positions({Kind::pattern_lines, with(point_grid, {{Role::start_u, unknown}})}).ok());
    EXPECT_FALSE(pattern_positions({Kind::pattern_circle, circle}).ok());  // no stopping angle
    EXPECT_FALSE(pattern_positions({Kind::pattern_circle, with(circle, {{Role::end_angle, 0}})}).ok());
}

TEST(pattern, Figures) {
    Figure f{.kind = Figure::Kind::position, .start = {1, 2}};
    expect_at(figure_positions(f), {{1, 2}});
    f = {.kind = Figure::Kind::row, .start = {1, 2}, .spacing = {5, 0}, .columns = 3, .rotation = 90};
    expect_at(figure_positions(f), {{1, 2}, {1, 7}, {1, 12}});
    f = {.kind = Figure::Kind::grid, .start = {0, 0}, .spacing = {5, 4}, .columns = 2, .rows = 2};
    expect_at(figure_positions(f), {{0, 0}, {5, 0}, {5, 4}, {0, 4}});
    f.rotation_v = 45;  // the second axis leans over
    expect_at(figure_positions(f),
              {{0, 0}, {5, 0}, {5 - std::sqrt(8.0), std::sqrt(8.0)}, {-std::sqrt(8.0), std::sqrt(8.0)}});
    f = {.kind = Figure::Kind::frame, .start = {0, 0}, .spacing = {1, 1}, .columns = 3, .rows = 3};
    expect_at(figure_positions(f), {{0, 0}, {1, 0}, {2, 0}, {2, 1}, {2, 2}, {1, 2}, {0, 2}, {0, 1}});
    f = {.kind = Figure::Kind::circle, .start = {0, 0}, .diameter = 20, .columns = 4, .start_angle = 90};
    expect_at(figure_positions(f), {{0, 10}, {-10, 0}, {0, -10}, {10, 0}});
    f = {.kind = Figure::Kind::arc, .start = {0, 0}, .diameter = 20, .columns = 2, .start_angle = 0, .angle_step = -90};
    expect_at(figure_positions(f), {{10, 0}, {0, -10}});
    f.columns = 0;
    EXPECT_FALSE(figure_positions(f).ok());
    f.columns = 2;
    f.diameter = unknown;
    EXPECT_FALSE(figure_positions(f).ok());
}

TEST(pattern, FrameHasEachPointOnce) {
    for (int columns = 1; columns < 6; ++columns)
        for (int rows = 1; rows < 6; ++rows) {
            const Positions p = figure_positions(
                {.kind = Figure::Kind::frame, .start = {}, .spacing = {1, 1}, .columns = columns, .rows = rows});
            const int inner = std::max(0, columns - 2) * std::max(0, rows - 2);
            EXPECT_EQ(int(p.at.size()), columns * rows - inner) << columns << ' ' << rows;
        }
}

}  // namespace
}  // namespace obrys::cycles::test
