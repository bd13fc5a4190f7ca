#include "geom/clearing.hpp"

#include <gtest/gtest.h>

#include <cstdio>

#include "geom/nearest.hpp"
#include "geom/offset.hpp"
#include "geom/random_cases_testing.hpp"

namespace obrys::geom {
namespace {

using testing::disc;
using testing::distance_to;
using testing::lattice_region;
using testing::Random;
using testing::rectangle;

#ifdef NDEBUG
constexpr unsigned many_clearings = 3000;
#else
constexpr unsigned many_clearings = 200;
#endif

TEST(Nearest, OfEdges) {
    EXPECT_NEAR(nearest_points(Edge{{0, 0}, {4, 0}}, Edge{{2, 1}, {3, 5}}).length, 1, 1e-12);
    const Edge low{{-1, 0}, {1, 0}, -1}, high{{-1, 5}, {1, 5}, 1};  // half circles that bulge towards each other
    const Gap g = nearest_points(low, high);
    EXPECT_NEAR(g.length, 3, 1e-12);
    EXPECT_NEAR(g.a.y, 1, 1e-12);
    EXPECT_NEAR(g.b.y, 4, 1e-12);
    EXPECT_NEAR(nearest_points(Edge{{-5, 3}, {5, 3}}, low).length, 2, 1e-12);
    // One circle in the other, their arcs on the side where they are nearest.
    const Edge inner = arc_about({1, 0}, 1, -1, 2), outer = arc_about({0, 0}, 5, -1, 2);
    EXPECT_NEAR(nearest_points(inner, outer).length, 3, 1e-12);
    EXPECT_NEAR(nearest_points(outer, inner).length, 3, 1e-12);
}

TEST(Nearest, OfAPointAtTheCentreLiesOnTheArc) {
    for (unsigned number = 0; number < 2000; ++number) {
        Random random(number);
        const Vec2 centre = random.point(-500, 500);
        const Edge e = arc_about(centre, random.between(0.1, 300), random.between(0, 6), random.between(-5, 5));
        EXPECT_LT(distance(e, nearest(e, circle(e).centre)), 1e-9) << number;
        EXPECT_LT(distance(e, nearest(e, centre + 1e-13 * random.point(-1, 1))), 1e-9) << number;
    }
}

TEST(Nearest, OfRandomEdgesAgainstSamples) {
    for (unsigned number = 0; number < 2000 && !HasFailure(); ++number) {
        SCOPED_TRACE(number);
        Random random(number);
        constexpr double bulges[] = {0, 0.3, -0.3, 1, -1, 0.8};
        const Edge e{random.point(0, 4), random.point(0, 4), random.one_of(bulges)};
        const Edge f{random.point(5, 9), random.point(0, 9), random.one_of(bulges)};
        if (crossings(e, f, 1e-9).count > 0) continue;
        double least = 1e9;
        for (int i = 0; i <= 200; ++i) least = std::min(least, distance(f, point_at(e, i / 200.0)));
        const Gap g = nearest_points(e, f);
        EXPECT_LE(g.length, least + 1e-9);
        EXPECT_GE(g.length, least - 1e-2 * (length(e) + 1));
        EXPECT_NEAR(distance(e, g.a), 0, 1e-9);
        EXPECT_NEAR(distance(f, g.b), 0, 1e-9);
    }
}

TEST(Clearing, OfARectangle) {
    const Clearing c = clearing_rings({{rectangle(0, 0, 20, 10)}}, {.radius = 2, .stepover = 2});
    ASSERT_EQ(c.fault, ClearingFault::none);
    ASSERT_EQ(c.rings.size(), 2U);  // 16 x 6, 12 x 2
    EXPECT_NEAR(area(c.rings[0].path), 96, 1e-9);
    EXPECT_NEAR(area(c.rings[1].path), 24, 1e-9);
    const auto tours = clearing_tours(c);
    ASSERT_EQ(tours.size(), 1U);
    // Both rings, and from the inner corner to the outer ring.
    EXPECT_NEAR(length(tours[0]), 44 + 28 + 2, 1e-9);
    EXPECT_FALSE(tours[0].closed);
}

/// The innermost ring's two sides would only just meet.
TEST(Clearing, PassesOverlap) {
    for (const double stepover : {5.0, 10.0}) {
        const Clearing c = clearing_rings({{rectangle(0, 0, 60, 30)}}, {.radius = 5, .stepover = stepover});
        ASSERT_EQ(c.fault, ClearingFault::none);
        double nearest = INFINITY;  // of the middle
        for (const Ring& ring : c.rings)
            for (const Edge& e : edges(ring.path))
                nearest = std::min(nearest, distance(geom::nearest(e, {30, 15}), {30, 15}));
        EXPECT_LE(nearest, 4.9 + 1e-9) << stepover;
    }
}

TEST(Clearing, StepoverBeyondTheRadiusGetsItsCornersAndMiddle) {
    const Clearing c = clearing_rings({{rectangle(0, 0, 40, 40)}}, {.radius = 2, .stepover = 3.9});
    std::size_t added = 0;
    for (const Ring& r : c.rings) added += r.added;
    EXPECT_GE(added, 16U);  // four corners a level
    const Clearing round = clearing_rings({{disc(0, 0, 10)}}, {.radius = 4, .stepover = 5.9});
    ASSERT_EQ(round.rings.size(), 2U);  // of 6 and of 0.1, which covers the middle
    EXPECT_EQ(clearing_rings({{disc(0, 0, 9.9)}}, {.radius = 4, .stepover = 7}).rings.size(), 2U);
}

TEST(Clearing, FaultsAreValues) {
    const Region r{{rectangle(0, 0, 20, 10)}};
    EXPECT_EQ(clearing_rings(r, {.radius = 5.1, .stepover = 1}).fault, ClearingFault::no_room);
    EXPECT_EQ(clearing_rings({}, {.radius = 1, .stepover = 1}).fault, ClearingFault::no_room);
    EXPECT_EQ(clearing_rings(r, {.radius = 0, .stepover = 1}).fault, ClearingFault::bad_input);
    EXPECT_EQ(clearing_rings(r, {.radius = 1, .stepover = 0}).fault, ClearingFault::bad_input);
    EXPECT_EQ(clearing_rings(r, {.radius = 1, .stepover = std::nan("")}).fault, ClearingFault::bad_input);
    EXPECT_EQ(clearing_rings(r, {.radius = 1, .allowance = -2, .stepover = 1}).fault, ClearingFault::bad_input);
    EXPECT_EQ(clearing_rings(r, {.radius = 1, .stepover = 1e-7}).fault, ClearingFault::too_many);
    Region broken = r;
    broken.contours[0].vertices[0].p.x = std::nan("");
    EXPECT_EQ(clearing_rings(broken, {.radius = 1, .stepover = 1}).fault, ClearingFault::bad_input);
}

struct Totals {
    std::size_t cases = 0, rings = 0, added = 0, covered = 0;
};

void expect_clear_of_the_contour(const Region& r, const std::vector<Contour>& tours, double least) {
    for (const Contour& t : tours)
        for (const Edge& e : edges(t))
            for (const double at : {0.0, 0.25, 0.5, 0.75, 1.0}) {
                const Vec2 p = point_at(e, at);
                EXPECT_GE(distance(r, p), least - 1e-6) << p.x << ' ' << p.y;
                EXPECT_TRUE(contains(r, p) || least < 1e-6) << p.x << ' ' << p.y;
            }
}

void expect_covered(const Region& r, const Clearing& c, const std::vector<Contour>& tours, double radius,
                    Random& random, Totals& totals) {
    std::vector<Edge> way, rings;
    for (const Contour& t : tours)
        for (const Edge& e : edges(t)) way.push_back(e);
    for (const Ring& ring : c.rings) {
        if (ring.path.vertices.size() == 1) rings.push_back({ring.path.vertices[0].p, ring.path.vertices[0].p});
        for (const Edge& e : edges(ring.path)) rings.push_back(e);
    }
    const Box b = box(r);
    for (int i = 0; i < 60; ++i) {
        const Vec2 p{random.between(b.lo.x, b.hi.x), random.between(b.lo.y, b.hi.y)};
        if (!contains(c.room, p) && distance(c.room, p) > radius) continue;  // out of the tool's reach
        ++totals.covered;
        EXPECT_LE(distance_to(rings, p), radius + 2e-6) << p.x << ' ' << p.y;
        EXPECT_LE(distance_to(way, p), radius + 2e-6) << p.x << ' ' << p.y;
    }
}

void expect_tours_run_all_rings(const Clearing& c, const std::vector<Contour>& tours) {
    std::vector<Edge> way;
    for (const Contour& t : tours)
        for (const Edge& e : edges(t)) way.push_back(e);
    for (const Ring& ring : c.rings)
        for (const Edge& e : edges(ring.path)) EXPECT_LT(distance_to(way, point_at(e, 0.37)), 1e-8);
    EXPECT_EQ(c.links.size() + tours.size(), c.rings.size()) << "links make a tree of each part";
}

TEST(ClearingRandom, NoGougeNoRidgeOnePathEach) {
    Totals totals;
    for (unsigned number = 0; number < many_clearings && !HasFailure(); ++number) {
        SCOPED_TRACE(number);
        Random random(number);
        const Region r = lattice_region(random, 10);
        if (r.empty()) continue;
        ClearingOptions o;
        o.radius = random.between(0.1, 1.2);
        o.stepover = o.radius * random.between(0.4, 2.3);
        o.allowance = random.below(2) ? random.between(0, 0.3) : 0;
        o.rounding = random.below(4) ? 0 : random.between(0, 0.5);
        const Clearing c = clearing_rings(r, o);
        if (c.fault == ClearingFault::no_room) {
            EXPECT_TRUE(offset(r, -o.radius - o.allowance).empty());
            continue;
        }
        ASSERT_EQ(c.fault, ClearingFault::none);
        ++totals.cases;
        totals.rings += c.rings.size();
        for (const Ring& ring : c.rings) totals.added += ring.added;
        const auto tours = clearing_tours(c, random.below(2) != 0);
        expect_tours_run_all_rings(c, tours);
        expect_clear_of_the_contour(r, tours, o.radius + o.allowance);
        expect_covered(r, c, tours, o.radius, random, totals);
    }
    std::printf("seeds 0..%u: %zu pockets, %zu rings, %zu of them added, %zu points covered\n", many_clearings - 1,
                totals.cases, totals.rings, totals.added, totals.covered);
}

}  // namespace
}  // namespace obrys::geom
