#include "sim/turning/turning.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <fstream>
#include <sstream>

#include "geom/boolean.hpp"
#include "geom/random_contours_testing.hpp"

namespace obrys::sim::turning {
namespace {

using geom::Contour;
using geom::Region;

Contour rectangle(double z0, double x0, double z1, double x1) {
    return {{{{z0, x0}}, {{z1, x0}}, {{z1, x1}}, {{z0, x1}}}, true};
}
Move straight(double z0, double x0, double z1, double x1) { return {{z0, x0}, {z1, x1}, {}, 0}; }

TEST(Turning, PlungeTakesTheBladesWidth) {
    Workpiece w({{rectangle(0, 0, 100, 50)}});
    const Cut c = w.cut(rectangle(0, 0, 3, 400), straight(20, 60, 20, 40));
    EXPECT_NEAR(c.area, 30, 1e-9);
    EXPECT_NEAR(c.volume, geom::pi * (2500 - 1600) * 3, 1e-6);
    EXPECT_NEAR(c.depth_x, 10, 1e-9);
    EXPECT_NEAR(c.contact_length, 3, 1e-6);
    EXPECT_NEAR(w.area(), 4970, 1e-9);
    EXPECT_EQ(w.cut(rectangle(0, 0, 3, 400), straight(20, 60, 20, 40)).area, 0);
}

TEST(Turning, PartingOffLeavesTwoPieces) {
    Workpiece w({{rectangle(0, 0, 100, 50)}});
    w.cut(rectangle(0, 0, 3, 400), straight(60, 60, 60, -1));
    EXPECT_EQ(geom::pieces(w.region()).size(), 2U);
    EXPECT_NEAR(w.area(), 4850, 1e-9);
}

TEST(Turning, ArcMoveOfASquareToolCutsAnArc) {
    // The lower left corner runs a quarter circle of radius 10 about (50, 50), from (40, 50) to (50, 40).
    Workpiece w({{rectangle(0, 0, 50, 50)}});
    const Cut c = w.cut(rectangle(0, 0, 100, 100), {{40, 50}, {50, 40}, {50, 50}, geom::pi / 2});
    EXPECT_NEAR(c.area, geom::pi * 25, 1e-9);
}

TEST(Turning, RoundToolAlongAnArcLeavesConcentricArcs) {
    const Contour nose{{{{-1, 0}, 1}, {{1, 0}, 1}}, true};
    Workpiece w({{rectangle(-50, 0, 50, 50)}});
    const Cut c = w.cut(nose, {{-10, 20}, {10, 20}, {0, 20}, geom::pi});
    EXPECT_NEAR(c.area, geom::pi * (121 - 81) / 2 + geom::pi, 1e-8);
}

TEST(Depth, OfABladeInTheFlankOfAGroove) {
    // Flank from (0, 10) up to (10, 20); a 3 mm blade stands with its lower right corner at (3, 5) in the body below
    // it.
    const Region kept{{{{{{0, 0}}, {{10, 0}}, {{10, 20}}, {{0, 10}}}, true}}};
    const auto d = depth_inside({{rectangle(2, 11, 5, 40)}}, kept, 1e-4);
    ASSERT_TRUE(d);
    EXPECT_NEAR(d->area, 0.5 * (1 + 4) * 3, 1e-9);
    EXPECT_NEAR(d->along_x, 4, 1e-6);
    EXPECT_NEAR(d->normal, 4 / std::sqrt(2.0), 1e-3);
    EXPECT_NEAR(d->deepest.x, 5, 1e-9);
    EXPECT_NEAR(d->deepest.y, 11, 1e-9);
    EXPECT_FALSE(depth_inside({{rectangle(2, 15, 5, 40)}}, kept, 1e-4));
    EXPECT_FALSE(depth_inside({{rectangle(2, 14.9999, 5, 40)}}, kept, 1e-3));
}

TEST(Depth, OfAThroughCutTheAxisIsNoContour) {
    const Region kept{{rectangle(0, 0, 100, 20)}};
    const auto d = depth_inside({{rectangle(50, -1, 53, 30)}}, kept, 1e-4);
    ASSERT_TRUE(d);
    EXPECT_NEAR(d->normal, 20, 1e-3);
    EXPECT_NEAR(d->along_x, 20, 1e-6);
    EXPECT_NEAR(d->volume, geom::pi * 400 * 3, 1e-6);
}

TEST(Depth, OfAPieceThatIsNotConvexIsTakenInThePiece) {
    // A U-shaped piece of a 10 x 10 part: 1 mm along three sides. Between its legs the part is deeper, but was not cut.
    const Region part{{{{{{0, 10}, 0}, {{10, 10}, 0}, {{10, 20}, 0}, {{0, 20}, 0}}, true}}};
    const Region u{{{{{{0, 10}, 0},
                      {{10, 10}, 0},
                      {{10, 20}, 0},
                      {{9, 20}, 0},
                      {{9, 11}, 0},
                      {{1, 11}, 0},
                      {{1, 20}, 0},
                      {{0, 20}, 0}},
                     true}}};
    const auto d = depth_inside(u, part, 1e-6);
    ASSERT_TRUE(d.has_value());
    EXPECT_NEAR(d->normal, 1, 1e-3);
}

TEST(Depth, InsideATubeIsHalfItsWall) {
    const Region kept{{rectangle(0, 10, 100, 20)}};
    const auto d = depth_inside(kept, kept, 1e-4);
    ASSERT_TRUE(d);
    EXPECT_NEAR(d->normal, 5, 1e-3);
    EXPECT_NEAR(d->along_x, 5, 1e-6);
}

TEST(Depth, PiecesLeftAboveThePart) {
    const Region wanted{{rectangle(0, 0, 100, 20)}};
    const Region left =
        geom::unite(wanted, geom::unite({{rectangle(10, 20, 20, 22)}}, {{rectangle(50, 20, 60, 20.001)}}));
    const auto pieces = pieces_outside(left, wanted, 0.01);
    ASSERT_EQ(pieces.size(), 1U);
    EXPECT_NEAR(pieces[0].area, 20, 1e-9);
    EXPECT_NEAR(pieces[0].normal, 2, 1e-3);
    EXPECT_NEAR(pieces[0].along_x, 2, 1e-6);
}

TEST(Depth, OfARingRoundAHoleIsTakenInTheRing) {
    // A skin of 0.02 mm all round a part that does not reach the axis: its middle is part, not rest.
    const Region wanted{{rectangle(0, 10, 50, 20)}}, left{{rectangle(-0.02, 9.98, 50.02, 20.02)}};
    const auto pieces = pieces_outside(left, wanted, 0.01);
    ASSERT_EQ(pieces.size(), 1U);
    EXPECT_NEAR(pieces[0].normal, 0.02 * std::sqrt(2.0), 1e-4);
    EXPECT_TRUE(pieces_outside({{rectangle(-1e-4, 9.9999, 50.0001, 20.0001)}}, wanted, 0.001).empty());
}

TEST(Depth, OfAFilmOnAFlatArc) {
    // 100 mm of a circle of 150 m: a chord a milliradian long leaves it by 0.019 mm.
    for (const double radius : {1e3, 1.5e5, 1e7}) {
        const auto body = [&](double top) {
            const double half = std::asin(50 / radius), s = radius * (1 - std::cos(half));
            return Region{
                {{{{{-50, 0}, 0}, {{50, 0}, 0}, {{50, top - s}, std::tan(half / 2)}, {{-50, top - s}, 0}}, true}}};
        };
        EXPECT_TRUE(pieces_outside(body(20.0001), body(20), 0.001).empty()) << radius;
        const auto thick = pieces_outside(body(20.02), body(20), 0.01);
        ASSERT_EQ(thick.size(), 1U) << radius;
        EXPECT_NEAR(thick[0].normal, 0.02, 5e-5) << radius;
    }
}

TEST(Depth, ASkinBetweenTwoCutsIsNoRest) {
    const Region wanted{{rectangle(0, 0, 100, 10)}};
    const auto with = [&](const Contour& c) { return pieces_outside(geom::unite(wanted, {{c}}), wanted, 0.01); };
    EXPECT_TRUE(with(rectangle(40, 10, 40.0001, 10.019)).empty());  // 1e-4 thick, 0.019 mm high
    EXPECT_TRUE(with(rectangle(100, 0, 105, 0.0001)).empty());      // a thread of 2e-4 on the axis
    EXPECT_EQ(with(rectangle(40, 10, 40.002, 15)).size(), 1U);
}

TEST(Turning, WhatPassesTheAxisCutsTheOtherSide) {
    Workpiece w({{rectangle(0, 5, 30, 20)}});
    // The tip at X 6, the insert 12 mm long: 6 mm past the axis.
    const Cut c = w.cut(rectangle(0, -12, 3, 0), straight(32, 6, 10, 6));
    EXPECT_NEAR(c.area, 20, 1e-9);
    EXPECT_NEAR(geom::area(c.across), 0, 1e-9);
    const Cut d = w.cut(rectangle(0, -13.5, 3, 0), straight(32, 6, 10, 6));
    EXPECT_NEAR(d.area, 1.5 * 20, 1e-9);
    EXPECT_NEAR(geom::area(d.across), 1.5 * 20, 1e-9);
    EXPECT_NEAR(w.area(), 15 * 30 - 20 - 30, 1e-9);
    // Of an insert that is not known to go on behind its tip nothing passes the axis.
    EXPECT_EQ(w.cut(rectangle(0, -18, 3, 0), straight(32, 6, 10, 6), rectangle(0, -0.1, 3, 0)).area, 0);
    EXPECT_NEAR(geom::area(w.met(rectangle(0, -18, 3, 0), straight(32, 6, 10, 6))), 4.5 * 20, 1e-9);
}

TEST(Turning, FacingPastTheAxisTakesNothingMore) {
    const Contour insert{{{{0.5, 12}, 0}, {{0, 0.8}, std::tan(geom::pi / 8)}, {{0.8, 0}, 0}, {{12, 1}, 0}}, true};
    Workpiece w({{rectangle(0, 0, 30, 20)}});
    const Cut past = w.cut(insert, straight(29, 25, 29, -0.8));
    EXPECT_NEAR(past.area, 20, 1e-9);
    EXPECT_NEAR(geom::area(past.across), 0, 1e-12);
    EXPECT_EQ(w.cut(insert, straight(29, -0.8, 35, -0.8)).area, 0);
    // From there into the bar: the nose cuts on its side of the axis.
    EXPECT_GT(geom::area(w.cut(insert, straight(35, -8, 20, -8)).across), 7);
}

void replay(const std::string& name) {
    std::ifstream file(std::string(OBRYS_SOURCE_DIR) + "/../shared/programs/groove/expected/" + name);
    if (!file) GTEST_SKIP() << "needs ../shared";
    Workpiece w({{{{{{0, 0}}, {{300, 0}}, {{300, 226}}, {{0, 106}}}, true}}});
    const Contour blade = rectangle(0, 0, 3, 400);
    const double start = w.area();
    double total = 0, expected_total = 0;
    int coarse = 0;
    std::string line;
    std::optional<geom::Vec2> at;
    while (std::getline(file, line)) {
        std::vector<std::string> field;
        std::stringstream s(line);
        for (std::string f; std::getline(s, f, ',');) field.push_back(f);
        if (field.size() < 8 || field[5].empty() || field[6].empty() || field[0] == "i") continue;
        const geom::Vec2 to{std::stod(field[6]), std::stod(field[5])};
        if (at && !field[7].empty()) {
            const double expected = std::stod(field[7]);
            const Cut c = w.cut(blade, {*at, to, {}, 0});
            const double got = c.area;
            // The sampled oracle places a wall to one column of its 0.01 mm cells, as high as the cut is deep.
            const double column = 0.01 * c.depth_x;
            EXPECT_NEAR(got, expected, std::max({0.02, 0.01 * expected, column})) << name << ' ' << line;
            if (std::abs(got - expected) > std::max(0.02, 0.01 * expected)) ++coarse;
            total += got;
            expected_total += expected;
        }
        at = to;
    }
    EXPECT_GT(total, 1000);
    EXPECT_NEAR(total, expected_total, 0.001 * expected_total);
    EXPECT_NEAR(w.area(), start - total, 1e-6);
    EXPECT_LE(coarse, 6);
    ::testing::Test::RecordProperty("area_mm2", std::to_string(total));
}
TEST(TurningGroove, ReplaysThePublishedProgram) { replay("kod1_moves.csv"); }
TEST(TurningGroove, ReplaysTheFaultyVariant) { replay("both_R3_80_moves.csv"); }

RC_GTEST_PROP(TurningProperty, StockBeforeIsStockAfterAndRemoved, ()) {
    Workpiece w(*geom::testing::lattice_region(12, 10));
    const Contour tool = *rc::gen::element(rectangle(0, 0, 1, 3), Contour{{{{0, 0}, 1}, {{2, 0}, 1}}, true},
                                           Contour{{{{0, 0}}, {{2, 1}}, {{1, 3}}}, true});
    for (int k = 0; k < 20; ++k) {
        const double jitter = *rc::gen::element(0.0, 0.0, 1e-12, 1e-10, 1e-9, 3e-9, 1e-7);
        const double before = w.area();
        const auto lattice = [] { return static_cast<double>(*rc::gen::inRange(0, 12)); };
        const Move m = straight(lattice() + jitter, lattice(), lattice(), lattice() - jitter);
        const Cut c = w.cut(tool, m);
        RC_ASSERT(std::abs(before - w.area() - c.area) < 1e-6);
        RC_ASSERT(w.area() <= before + 1e-7);
        RC_ASSERT(w.cut(tool, m).area < 1e-6);
    }
}

}  // namespace
}  // namespace obrys::sim::turning
