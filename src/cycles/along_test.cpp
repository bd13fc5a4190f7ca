#include "cycles/along.hpp"

#include <gtest/gtest.h>

#include <random>

#include "geom/contour.hpp"
#include "geom/offset.hpp"
#include "geom/region.hpp"

namespace obrys::cycles {
namespace {

using geom::Contour;
using geom::Edge;
using geom::Vec2;

/// Of an equidistant every edge lies along the element that it was made from, arcs about corners along one that ends
/// there: found by looking at all elements.
TEST(Along, EveryEdgeOfAnEquidistantHasTheElementBesideIt) {
    for (unsigned seed = 1; seed <= 40; ++seed) {
        SCOPED_TRACE("seed " + std::to_string(seed));
        std::mt19937 random(seed);
        std::uniform_real_distribution<double> some(-1, 1);
        Contour c{{}, false};
        Vec2 p{0, 0};
        for (int i = 0; i < 60; ++i) {
            c.vertices.push_back({p, i % 3 == 0 ? 0.4 * some(random) : 0});
            p = p + Vec2{20 + 10 * some(random), 15 * some(random)};
        }
        c.vertices.push_back({p});
        const std::vector<Edge> elements = geom::edges(c);
        const Along along(elements);
        std::size_t last = 0;
        for (const double by : {3.0, -3.0}) {
            last = 0;
            for (const Contour& beside : geom::equidistants(c, by))
                for (const Edge& e : geom::edges(beside)) {
                    if (geom::length(e) < 1e-3) continue;
                    const auto found = along.find(e);
                    ASSERT_TRUE(found);
                    EXPECT_NEAR(geom::distance(elements[*found], geom::point_at(e, 0.5)), 3, 1e-5);
                    EXPECT_GE(*found, last);
                    last = *found;
                }
            EXPECT_GT(last, 55U);
        }
    }
}

TEST(Along, WaysToAndFromTheContourHaveNone) {
    const Along along({{{0, 0}, {10, 0}}, {{10, 0}, {10, 10}}});
    EXPECT_EQ(along.find({{2, -3}, {8, -3}}), std::optional<std::size_t>(0));
    EXPECT_EQ(along.find({{13, 1}, {13, 9}}), std::optional<std::size_t>(1));
    EXPECT_EQ(along.find({{10, -3}, {13, 0}, std::tan(geom::pi / 8)}), std::optional<std::size_t>(0));  // the corner
    EXPECT_FALSE(along.find({{2, -3}, {8, -4}}));                                                       // not parallel
    EXPECT_FALSE(along.find({{-9, -3}, {1, -3}}));  // begins before the contour does
    EXPECT_FALSE(along.find({{2, -3}, {2, -3}}));   // straight down
    EXPECT_FALSE(along.find({{NAN, -3}, {2, -3}}));
    EXPECT_FALSE(Along({}).find({{2, -3}, {8, -3}}));
}

}  // namespace
}  // namespace obrys::cycles
