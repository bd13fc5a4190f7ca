#include <gtest/gtest.h>

#include <cstdio>

#include "geom/offset.hpp"
#include "geom/random_cases_testing.hpp"

namespace obrys::geom {
namespace {

using testing::distance_to;
using testing::lattice_loop;
using testing::Random;

#ifdef NDEBUG
constexpr unsigned many_equidistants = 10'000;
#else
constexpr unsigned many_equidistants = 1'000;
#endif

Contour chain(std::vector<Vertex> v) { return {std::move(v), false}; }

TEST(Equidistant, OfALine) {
    const Contour line = chain({{{0, 0}}, {{10, 0}}});
    EXPECT_EQ(equidistants(line, 2), std::vector<Contour>{chain({{{0, 2}}, {{10, 2}}})});
    EXPECT_EQ(equidistants(line, -2), std::vector<Contour>{chain({{{0, -2}}, {{10, -2}}})});
    EXPECT_EQ(equidistants(line, 0), std::vector<Contour>{line});
    EXPECT_TRUE(equidistants(Contour{}, 1).empty());
    EXPECT_TRUE(equidistants(chain({{{3, 4}}}), 1).empty());
    EXPECT_NEAR(area(band(line, 2)), 40 + pi * 4, 1e-9);
}

TEST(Equidistant, OuterCornersAreRoundedInnerOnesCut) {
    const Contour corner = chain({{{0, 0}}, {{10, 0}}, {{10, 8}}});
    const auto inner = equidistants(corner, 1), outer = equidistants(corner, -1);
    ASSERT_EQ(inner.size(), 1U);
    EXPECT_EQ(inner[0], chain({{{0, 1}}, {{9, 1}}, {{9, 8}}}));
    ASSERT_EQ(outer.size(), 1U);
    ASSERT_EQ(outer[0].vertices.size(), 4U);
    EXPECT_NEAR(length(outer[0]), 18 + pi / 2, 1e-12);
    EXPECT_NEAR(outer[0].vertices[1].bulge, std::tan(pi / 8), 1e-12);
}

TEST(Equidistant, AChannelTooNarrowIsLeftOut) {
    // Down, 3 across, up again: a circle of radius 2 does not get in.
    const Contour c = chain({{{0, 0}}, {{10, 0}}, {{10, -6}}, {{13, -6}}, {{13, 0}}, {{23, 0}}});
    const auto left = equidistants(c, 2);
    ASSERT_EQ(left.size(), 1U);
    // Around both corners of the mouth, cut where the arcs meet.
    const double angle = std::acos(1.5 / 2);
    EXPECT_NEAR(length(left[0]), 20 + 2 * 2 * (pi / 2 - angle), 1e-9);
}

TEST(Equidistant, ALoopGivesSeveralChains) {
    // Along x, a full turn to the right, on along x: the circle's inside is on the right.
    const Contour c = chain({{{0, 0}}, {{10, 0}, -1}, {{10, -8}, -1}, {{10, 0}}, {{20, 0}}});
    const auto right = equidistants(c, -1), left = equidistants(c, 1);
    ASSERT_EQ(right.size(), 3U);
    EXPECT_FALSE(right[0].closed);
    EXPECT_TRUE(right[1].closed);
    EXPECT_NEAR(area(right[1]), -pi * 9, 1e-9);
    EXPECT_FALSE(right[2].closed);
    // On the left past the loop, and around the loop from one side of the line to the other.
    ASSERT_EQ(left.size(), 2U);
    EXPECT_NEAR(length(left[0]), 20, 1e-9);
    EXPECT_NEAR(length(left[1]), 5 * 2 * (pi - std::acos(3.0 / 5)), 1e-9);
}

TEST(Equidistant, OfClosedContours) {
    const Contour box = testing::rectangle(0, 0, 10, 6);
    const auto left = equidistants(box, 1), right = equidistants(box, -1);
    ASSERT_EQ(left.size(), 1U);
    ASSERT_EQ(right.size(), 1U);
    EXPECT_TRUE(left[0].closed && right[0].closed);
    EXPECT_NEAR(area(left[0]), 8 * 4, 1e-12);
    EXPECT_NEAR(area(right[0]), 60 + 32 + pi, 1e-12);
    EXPECT_NEAR(area(equidistants(reversed(box), 1)[0]), -60 - 32 - pi, 1e-12);
    EXPECT_TRUE(equidistants(box, 3).empty());
    // An eight: its left is inside of one half and outside of the other.
    const Contour eight{{{{0, 0}}, {{6, 6}}, {{12, 0}}, {{12, 6}}, {{6, 0}}, {{0, 6}}}, true};
    EXPECT_GE(equidistants(eight, 0.5).size(), 2U);
}

TEST(Equidistant, ATipThatTurnsBack) {
    // A line, then an arc that returns above it: its tip is an outer corner on the right, an inner one on the left.
    const Contour c = chain({{{0, 0}}, {{10, 0}, 0.5}, {{10, 8}, 1}, {{10, 0.0}}});
    for (const double by : {-0.5, 0.5})
        for (const Contour& k : equidistants(c, by))
            for (const Edge& e : edges(k)) EXPECT_NEAR(distance_to(edges(c), point_at(e, 0.5)), 0.5, 1e-9);
}

/// On which side of the chain the point lies, by the edges it is next to: 1 left, -1 right, 0 not to be told.
int side_of(const std::vector<Edge>& chain_edges, Vec2 p, double d) {
    int side = 0;
    for (std::size_t i = 0; i < chain_edges.size(); ++i) {
        const Edge& e = chain_edges[i];
        if (distance(e, p) > d + 1e-7) continue;
        const double t = parameter(e, p);
        if (t < 1e-6 || t > 1 - 1e-6) return 0;
        const int here = cross(tangent_at(e, t), p - nearest(e, p)) > 0 ? 1 : -1;
        if (side != 0 && side != here) return 0;
        side = here;
    }
    return side;
}

struct Count {
    unsigned points = 0, sided = 0, expected = 0;
};

void expect_equidistant(const Contour& c, double by, Count& count) {
    const double d = std::abs(by);
    const std::vector<Edge> source = edges(c);
    const std::vector<Contour> found = equidistants(c, by);
    std::vector<Edge> all;
    for (const Contour& k : found)
        for (const Edge& e : edges(k)) all.push_back(e);
    for (const Edge& e : all)
        for (const double t : {0.0, 0.31, 0.77}) {
            const Vec2 p = point_at(e, t);
            ++count.points;
            EXPECT_NEAR(distance_to(source, p), d, 2e-7) << p.x << ' ' << p.y;
            if (t == 0) continue;
            const int side = side_of(source, p, d);
            count.sided += side != 0;
            EXPECT_TRUE(side == 0 || side == (by > 0 ? 1 : -1)) << p.x << ' ' << p.y;
        }
    // And nothing is missing: a point beside an edge and nowhere nearer lies on a chain. Not so single points, and gaps
    // just as wide as the circle, which count as closed.
    const auto free_beside = [&](const Edge& e, double t, double away) {
        const Vec2 n = (by / d) * left_of(tangent_at(e, t));
        return distance_to(source, point_at(e, t) + (d + away) * n) > d + 0.1 * away - 1e-6;
    };
    for (const Edge& e : source)
        for (const double t : {0.13, 0.5, 0.83}) {
            if (is_arc(e) && std::abs(circle(e).radius - d) < 1e-3) continue;  // shrinks to a point
            if (!free_beside(e, t, 0) || !free_beside(e, t, 1e-4)) continue;
            if (!free_beside(e, t - 0.01, 0) || !free_beside(e, t + 0.01, 0)) continue;
            const Vec2 p = point_at(e, t) + by * left_of(tangent_at(e, t));
            ++count.expected;
            EXPECT_LT(distance_to(all, p), 2e-3) << p.x << ' ' << p.y;
        }
}

TEST(EquidistantRandom, AtTheDistanceOnItsSideAndNothingMissing) {
    constexpr double distances[] = {0.05, 0.4, 0.5, 1, 1.25, 2};
    Count count;
    for (unsigned number = 0; number < many_equidistants && !HasFailure(); ++number) {
        SCOPED_TRACE(number);
        Random random(number);
        const Contour loop = random.below(2) ? lattice_loop(random, 6) : lattice_loop(random, 12);
        const double angle = random.below(2) ? random.between(0, 6) : 0;
        const double d = random.below(3) ? random.one_of(distances) : random.between(0.001, 2);
        Contour placed = testing::turned({{loop}}, angle, {}).contours[0];
        placed.closed = random.below(3) == 0;
        if (!placed.closed) placed.vertices.back().bulge = 0;
        if (edges(placed).size() < 2) continue;
        expect_equidistant(placed, d, count);
        expect_equidistant(placed, -d, count);
    }
    std::printf("seeds 0..%u: %u points on equidistants, side told of %u, %u expected points found\n",
                many_equidistants - 1, count.points, count.sided, count.expected);
    EXPECT_GT(count.expected, 10 * many_equidistants / 5);
}

}  // namespace
}  // namespace obrys::geom
