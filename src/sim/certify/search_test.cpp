/// What a search for the deepest place may not be led away from: something small beside something large, thin walls.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <vector>

#include "mesh/primitives.hpp"
#include "sim/certify/certify.hpp"

namespace obrys::sim::certify {
namespace {

using geom::Vec3;

Shape mill_of(double r) { return {{r, 0, r, 30, 0}}; }

const mesh::Distance& slab() {
    static const mesh::Distance part(mesh::box({0, 0, -20}, {60, 40, 0}));
    return part;
}

/// A floor at -1 of very many triangles, on it a wall along y from x0 to x1 that is 1 high.
mesh::Mesh walled_floor(double step, double x0, double x1) {
    std::vector<double> xs{x0, x0 + 1e-3, x1 - 1e-3, x1}, ys;
    for (double v = -20; v <= 20; v += step) xs.push_back(v), ys.push_back(v);
    std::sort(xs.begin(), xs.end());
    const auto rows = static_cast<std::uint32_t>(ys.size()), columns = static_cast<std::uint32_t>(xs.size());
    mesh::Mesh m;
    for (const double low : {0.0, 1.0})
        for (const double x : xs)
            for (const double y : ys) m.vertices.push_back({x, y, low > 0 ? -10 : x > x0 && x < x1 ? 0.0 : -1.0});
    const auto quad = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d) {
        m.triangles.push_back({a, b, c});
        m.triangles.push_back({a, c, d});
    };
    const std::uint32_t foot = rows * columns;
    const auto at = [&](std::uint32_t i, std::uint32_t j) { return i * rows + j; };
    for (std::uint32_t i = 0; i + 1 < columns; ++i) {
        for (std::uint32_t j = 0; j + 1 < rows; ++j) {
            quad(at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1));
            quad(foot + at(i, j), foot + at(i, j + 1), foot + at(i + 1, j + 1), foot + at(i + 1, j));
        }
        const std::uint32_t end = rows - 1;
        quad(foot + at(i, 0), foot + at(i + 1, 0), at(i + 1, 0), at(i, 0));
        quad(foot + at(i + 1, end), foot + at(i, end), at(i, end), at(i + 1, end));
    }
    for (std::uint32_t j = 0; j + 1 < rows; ++j) {
        const std::uint32_t end = columns - 1;
        quad(foot + at(0, j + 1), foot + at(0, j), at(0, j), at(0, j + 1));
        quad(foot + at(end, j), foot + at(end, j + 1), at(end, j + 1), at(end, j));
    }
    return m;
}

TEST(CertifiedSearch, a_wall_on_a_floor_of_many_triangles_that_is_too_deep_itself_is_found) {
    constexpr double allowed = 0.01, wall = 0.6;
    for (const double step : {0.2, 5.0})
        for (const double off : {0.008, 0.02}) {
            const mesh::Distance part(walled_floor(step, 7.03, 7.03 + wall));
            const Judge judge(part, allowed);
            const Shape mill = mill_of(2);
            const auto d = judge.deepest({geom::Straight{{-30, 0.1, -1 - off}, {30, 0.1, -1 - off}}, {0, 0, 1}, &mill});
            ASSERT_TRUE(d) << step << ' ' << off;
            EXPECT_NEAR(d->depth, wall, 0.01) << step << ' ' << off;
            EXPECT_NEAR(d->at.x, 7.03 + wall / 2, 0.05);
        }
}

TEST(CertifiedSearch, a_wall_cut_off_on_an_arc_is_as_deep_as_it_is_thick_wherever_it_lies) {
    constexpr double allowed = 0.01, wall = 0.6;
    const Shape mill = mill_of(2);
    for (const double x : {-5.0, -1.0, 3.0, 6.0}) {
        const mesh::Distance part(walled_floor(5, x, x + wall));
        const Judge judge(part, allowed);
        const geom::Circular c{{15, 0, -1.02}, {-15, 0, -1.02}, {0, 0, -1.02}, {0, 0, 1}, geom::pi};
        const auto d = judge.deepest({c, {0, 0, 1}, &mill});
        ASSERT_TRUE(d) << x;
        EXPECT_NEAR(d->depth, wall, 0.01) << x;
    }
}

/// A tall tool through a wall as thin as a hair: however the boxes of the proof come to lie about it.
TEST(CertifiedSearch, a_wall_of_less_than_what_is_allowed_is_proved_to_be_thin_wherever_it_lies) {
    constexpr double allowed = 0.01;
    const Shape cone{{0, 0, 4, 80, 0}};
    for (int i = 0; i < 12; ++i) {
        const double x = 0.1 + 0.00117 * i, wall = 0.0005 + 0.0008 * i;
        const mesh::Distance part(mesh::box({x, -12, -10}, {x + wall, 12, 5}));
        const Judge judge(part, allowed);
        const double y = 0.7 * i - 3;
        const Move move{geom::Straight{{-17, y - 4, 0.5}, {17, y + 4, 0.5}}, {0, 0, 1}, &cone};
        EXPECT_FALSE(judge.is_clear(move));
        EXPECT_TRUE(judge.is_thin(move, {1, 0, 0})) << i;
    }
}

/// The small body that is a tool's point, on a long way through a wall on a floor, however all of it leans.
TEST(CertifiedSearch, a_point_through_a_thin_wall_on_a_floor_is_proved_on_a_long_way) {
    constexpr double allowed = 0.05, wall = 0.035;
    const Shape point{{0, 0, 0.05, 0.28, 0}};
    for (const double lean : {0.0, 0.4, 1.0}) {
        const geom::Frame turned = geom::Frame::rotation(1, lean) * geom::Frame::rotation(2, 0.8);
        const mesh::Distance part(mesh::transformed(walled_floor(5, -wall / 2, wall / 2), turned));
        const Judge judge(part, allowed);
        const auto at = [&](double x, double y, double z) { return geom::apply(turned, Vec3{x, y, z}); };
        const Move move{geom::Straight{at(-14, -12, -0.7), at(14, 12, -0.7)}, geom::apply_direction(turned, {0, 0, 1}),
                        &point};
        EXPECT_FALSE(judge.is_clear(move)) << lean;
        EXPECT_TRUE(judge.is_thin(move, geom::apply_direction(turned, {1, 0, 0}))) << lean;
    }
}

/// A corner that is taken off by nearly as much as is allowed, or hardly more, on whichever way and side of the tool.
TEST(CertifiedSearch, a_corner_taken_off_by_less_than_is_allowed_is_proved) {
    constexpr double allowed = 0.05;
    const double lean = geom::radians(30.0);
    const Shape cone{{0, 0, 0.05, 0.05 / std::tan(lean), 0}, {0.05, 0.05 / std::tan(lean), 4, 4 / std::tan(lean), 0}};
    const Judge judge(slab(), allowed);
    for (const double about : {0.5, 0.8, 1.1})
        for (const double share : {0.5, 0.94, 0.99, 1.1, 1.5}) {
            // The flank's normal at the corner (0, 0, 0), out of the tool and into the slab.
            const Vec3 out{std::cos(lean) * std::cos(about), std::cos(lean) * std::sin(about), -std::sin(lean)};
            const Vec3 along{-std::sin(about), std::cos(about), 0};
            const Vec3 on_flank =
                3 * Vec3{std::sin(lean) * std::cos(about), std::sin(lean) * std::sin(about), std::cos(lean)};
            const Vec3 middle = share * allowed * out - on_flank;
            const Move move{geom::Straight{middle - 3.0 * along, middle + 3.0 * along}, {0, 0, 1}, &cone};
            EXPECT_EQ(judge.is_no_deeper(move, {0, 0, 1}), share < 1.02) << about << ' ' << share;
        }
}

TEST(CertifiedSearch, a_wall_as_thick_as_is_allowed_is_not_thin) {
    const Shape mill = mill_of(2);
    const mesh::Distance part(mesh::box({0, -12, -10}, {0.0105, 12, 5}));
    const Judge judge(part, 0.01);
    EXPECT_FALSE(judge.is_thin({geom::Straight{{-17, 0, 0.5}, {17, 0, 0.5}}, {0, 0, 1}, &mill}, {1, 0, 0}));
}

TEST(CertifiedSearch, a_search_begins_where_it_is_told) {
    const Judge judge(slab(), 0.01);
    const Shape mill = mill_of(5);
    const Move move{geom::Straight{{-20, 20, -0.3}, {80, 20, -0.3}}, {0, 0, 1}, &mill};
    const auto d = judge.deepest(move, Vec3{41, 21, -0.3});
    ASSERT_TRUE(d);
    EXPECT_NEAR(d->depth, 0.3, 0.001);
    EXPECT_NEAR(d->at.x, 41, 1);
}

TEST(CertifiedSearch, what_goes_through_air_of_the_stock_is_clear_of_the_part_in_it) {
    const auto stock = std::make_shared<const mesh::Distance>(mesh::box({0, 0, -20}, {60, 40, -1}));
    const Judge judge(slab(), 0.01, {[](Vec3 p) { return -1 - p.z; }, stock, 0, true});
    const Shape mill = mill_of(5);
    const auto move = [&](double z) { return Move{geom::Straight{{-20, 20, z}, {80, 20, z}}, {0, 0, 1}, &mill}; };
    EXPECT_FALSE(judge.is_clear(move(-1.005)));
    EXPECT_TRUE(judge.is_clear(move(-1.005), Judge::Of::part_in_stock));
    EXPECT_FALSE(judge.is_clear(move(-1.02), Judge::Of::part_in_stock));
}

// A tool takes a strip off the edge of a slab, wider than it is deep: where the edge's other face is as near, the way
// from there to the tool's side is no thickness.
TEST(CertifiedSearch, the_strip_off_an_edge_is_no_thin_wall) {
    const Shape mill = mill_of(3);
    const Judge judge(slab(), 0.01);
    constexpr double deep = 0.15;
    for (const double wide : {0.2, 0.269, 0.3})
        for (const double off : {-1e-9, 0.0, 1e-9, 1e-6}) {
            const double x = 60 - wide + 3;
            const geom::Straight way{{x, -10, -deep}, {x, 50, -deep}};
            const std::optional<Depth> d = judge.deepest({way, {0, 0, 1}, &mill}, Vec3{60 - deep + off, 20, -deep});
            ASSERT_TRUE(d) << wide;
            EXPECT_NEAR(d->depth, deep, 0.05 * deep) << wide << " off " << off;
        }
}

// A pointed tool goes askew through a wall: with its tip it does not fill it, higher up it does.
TEST(CertifiedSearch, a_point_through_a_wall_is_as_deep_as_the_wall_is_thick) {
    constexpr double thick = 1.26;
    const mesh::Distance wall(mesh::box({-thick / 2, -40, -10}, {thick / 2, 40, 4}));
    const Judge judge(wall, 0.05);
    const double slope = std::tan(geom::radians(15.0));
    const Shape point{{0, 0, 20 * slope, 20, 0}};
    for (const double askew : {0.0, 0.2, 0.4})
        for (const double up : {0.0, 1.0, 2.2}) {
            const geom::Straight way{{-17, -17 * askew, 0.9}, {17, 17 * askew, 0.9}};
            const std::optional<Depth> d = judge.deepest({way, {0, 0, 1}, &point}, Vec3{0, up * slope, 0.9 + up});
            ASSERT_TRUE(d) << askew;
            EXPECT_NEAR(d->depth, thick, 0.02 * thick) << askew << " from " << up;
        }
}

}  // namespace
}  // namespace obrys::sim::certify
