#include "mesh/compare.hpp"

#include <gtest/gtest.h>

#include "mesh/primitives.hpp"
#include "mesh/topology.hpp"

namespace obrys::mesh {
namespace {

using geom::Vec3;

/// A plate from z = -5 to 0 whose top is a grid, with dents and bumps of the given heights.
struct Bump {
    Vec3 at;  ///< z: how high
    double width;
};
Mesh plate(int n, const std::vector<Bump>& bumps) {
    Mesh m;
    for (int j = 0; j <= n; ++j)
        for (int i = 0; i <= n; ++i) {
            Vec3 p{static_cast<double>(i), static_cast<double>(j), 0};
            for (const Bump& b : bumps)
                if (std::hypot(p.x - b.at.x, p.y - b.at.y) < b.width) p.z += b.at.z;
            m.vertices.push_back(p);
        }
    const auto at = [&](int i, int j) { return static_cast<std::uint32_t>(j * (n + 1) + i); };
    for (int j = 0; j < n; ++j)
        for (int i = 0; i < n; ++i) {
            m.triangles.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1)});
            m.triangles.push_back({at(i, j), at(i + 1, j + 1), at(i, j + 1)});
        }
    for (std::uint32_t t = 0; t < m.triangles.size(); ++t) m.tags.push_back(t);
    return m;
}

TEST(Compare, finds_gouges_and_excess_with_their_places) {
    const Distance part(box({-10, -10, -5}, {50, 50, 0}));
    const Mesh result = plate(40, {{{10, 10, -0.3}, 0.5}, {{10, 30, -0.1}, 1.2}, {{30, 20, 0.25}, 2.1}});
    const Comparison c = compare(result, part);
    ASSERT_EQ(c.gouges.size(), 2U);
    EXPECT_EQ(c.gouge_count, 2U);
    EXPECT_NEAR(c.gouges[0].deviation, -0.3, 1e-12);
    EXPECT_EQ(c.gouges[0].at, (Vec3{10, 10, -0.3}));
    EXPECT_EQ(c.gouges[0].triangles, 6U) << "the triangles around one vertex";
    EXPECT_EQ(c.gouges[0].tag, c.gouges[0].triangle);
    EXPECT_NEAR(c.gouges[1].deviation, -0.1, 1e-12);
    EXPECT_GE(c.gouges[1].triangles, 16U);
    ASSERT_EQ(c.excesses.size(), 1U);
    EXPECT_NEAR(c.excesses[0].deviation, 0.25, 1e-12);
    EXPECT_EQ(c.excesses[0].extent.lo.x, 27);
    EXPECT_EQ(c.excesses[0].extent.hi.x, 33);
    EXPECT_DOUBLE_EQ(c.largest_gouge, 0.3);
    EXPECT_DOUBLE_EQ(c.largest_excess, 0.25);
    ASSERT_EQ(c.deviation.size(), result.triangles.size());
    EXPECT_NEAR(c.deviation[0], 0, 1e-12);
}

TEST(Compare, allows_what_is_allowed_and_lists_no_more_than_asked) {
    const Distance part(box({-10, -10, -5}, {50, 50, 0}));
    const Mesh result = plate(40, {{{10, 10, -0.3}, 0.5}, {{10, 30, -0.1}, 1.2}, {{30, 20, 0.25}, 2.1}});
    const Comparison c = compare(result, part, {.gouge = 0.2, .excess = 0.3, .places = 10});
    EXPECT_EQ(c.gouges.size(), 1U);
    EXPECT_EQ(c.excesses.size(), 0U);
    EXPECT_DOUBLE_EQ(c.largest_excess, 0.25);
    const Comparison one = compare(result, part, {.gouge = 0.01, .excess = 0.01, .places = 1});
    EXPECT_EQ(one.gouges.size(), 1U);
    EXPECT_EQ(one.gouge_count, 2U);
}

TEST(Compare, tells_whose_triangles_a_place_is_made_of) {
    const Distance part(box({-10, -10, -5}, {50, 50, 0}));
    Mesh result = plate(40, {{{10, 10, -0.3}, 1.2}, {{30, 30, -0.2}, 0.5}});
    for (std::uint32_t t = 0; t < result.triangles.size(); ++t) result.tags[t] = centre(result, t).x < 9.2 ? 7 : 8;
    const Comparison c = compare(result, part);
    ASSERT_EQ(c.gouges.size(), 2U);
    ASSERT_EQ(c.gouges[0].shares.size(), 2U);
    EXPECT_EQ(c.gouges[0].shares[0].tag, 8U) << "the larger part";
    EXPECT_EQ(c.gouges[0].shares[1].tag, 7U);
    EXPECT_GT(c.gouges[0].shares[0].area, c.gouges[0].shares[1].area);
    EXPECT_NEAR(c.gouges[0].shares[0].area + c.gouges[0].shares[1].area, c.gouges[0].area, 1e-9);
    ASSERT_EQ(c.gouges[1].shares.size(), 1U);
    EXPECT_NEAR(c.gouges[1].shares[0].area, c.gouges[1].area, 1e-9);
    EXPECT_TRUE(compare(result, part, {.gouge = 0.01, .excess = 0.01, .places = 0}).gouges.empty());
}

TEST(Compare, one_triangle_may_lie_too_deep_and_too_high) {
    const Distance part(ball({0, 0, 0}, 1, 64));
    Mesh result;
    for (int i = 0; i < 3; ++i)
        result.vertices.push_back({1.3 * std::cos(2 * geom::pi * i / 3), 1.3 * std::sin(2 * geom::pi * i / 3), 0});
    result.triangles = {{0, 1, 2}};
    const Comparison c = compare(result, part);
    ASSERT_EQ(c.gouges.size() + c.excesses.size(), 2U);
    EXPECT_NEAR(c.gouges[0].deviation, -1, 0.01);
    EXPECT_NEAR(length(c.gouges[0].at), 0, 1e-9) << "its centre";
    EXPECT_NEAR(c.excesses[0].deviation, 0.3, 0.01);
    EXPECT_EQ(c.deviation[0], c.gouges[0].deviation);
}

TEST(Compare, with_nothing_is_infinite_and_of_nothing_empty) {
    const Comparison none = compare(box({0, 0, 0}, {1, 1, 1}), Distance(Mesh{}));
    EXPECT_TRUE(std::isinf(none.deviation[0]));
    EXPECT_TRUE(compare(Mesh{}, Distance(box({0, 0, 0}, {1, 1, 1}))).deviation.empty());
}

TEST(Compare, colours_grow_with_the_deviation) {
    const std::vector<double> d{0, 0.005, -0.005, -0.02, -0.5, -9, 0.02, 0.5, HUGE_VAL};
    const DeviationColours c = deviation_colours(d, {.gouge = 0.01, .excess = 0.01}, 0.51, 5);
    EXPECT_EQ(c.palette.size(), 11U);
    EXPECT_EQ(c.tags, (std::vector<std::uint32_t>{0, 0, 0, 1, 5, 5, 6, 10, 10}));
    EXPECT_EQ(c.palette[0], grey);
    EXPECT_EQ(c.palette[5], (Colour{176, 0, 24}));
}

}  // namespace
}  // namespace obrys::mesh
