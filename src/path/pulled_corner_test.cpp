#include "path/pulled_corner.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "path/path_testing.hpp"

namespace obrys::path {
namespace {

/// Round the corner (0, 0) of a contour that comes along +y and leaves along +x, the tool of 5 mm left of it.
Element square_corner() { return arc({-5, 0}, {0, 0}, -geom::pi / 2); }

TEST(PulledCorner, TouchesBothParallelsAndItsMiddleLiesWhereItIsAsked) {
    for (const double part : {0.1, 0.5, 0.9}) {
        const std::vector<Element> way = pulled_corner(square_corner(), part);
        ASSERT_GT(way.size(), 1u);
        EXPECT_EQ(way.front().from, (geom::Vec2{-5, 0}));
        EXPECT_NEAR(geom::distance(way.back().to, {0, 5}), 0, 1e-12);
        EXPECT_NEAR(start_direction(way.front()).x, 0, 0.02) << "along +y, as the parallel";
        EXPECT_NEAR(end_direction(way.back()).y, 0, 0.02);
        const double arc_at = 5, crossing_at = 5 * std::sqrt(2.0);
        double farthest = 0;
        for (std::size_t i = 0; i < way.size(); ++i) {
            if (i > 0) {
                EXPECT_NEAR(geom::distance(way[i].from, way[i - 1].to), 0, 1e-12);
            }
            farthest = std::max(farthest, geom::length(way[i].to));
            for (const double t : {0.0, 0.3, 0.7, 1.0}) {
                const geom::Vec2 p = point_at(way[i], t);
                EXPECT_GE(geom::length(p), 5 - 1e-3) << "never nearer to the corner than the tool's radius";
                EXPECT_GE(p.x, -5 - 1e-3);
                EXPECT_LE(p.y, 5 + 1e-3);
            }
        }
        EXPECT_NEAR(farthest, arc_at + part * (crossing_at - arc_at), 1e-3);
    }
}

TEST(PulledCorner, NoneIsTheArcAndAllAreTheParallels) {
    EXPECT_EQ(pulled_corner(square_corner(), 0).size(), 1u);
    const std::vector<Element> all = pulled_corner(square_corner(), 1);
    ASSERT_EQ(all.size(), 2u);
    EXPECT_NEAR(geom::distance(all[0].to, {-5, 5}), 0, 1e-9);
    EXPECT_EQ(pulled_corner(arc({-5, 0}, {0, 0}, -geom::pi), 0.5).size(), 1u) << "parallels that do not meet";
}

}  // namespace
}  // namespace obrys::path
