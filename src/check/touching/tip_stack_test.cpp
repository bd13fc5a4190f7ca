/// Material over the tip of a tool is as high as it stands there, however faces slant and whatever was cut before.

#include "check/touching/tip_stack.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "base/seed_testing.hpp"
#include "check/left/cut_world_testing.hpp"

namespace obrys::check {

namespace milling = sim::milling;

using geom::Vec3;
using testing::CutWorld;

namespace {

constexpr milling::Heights edges{0, 60};

Vec3 leaning(double degrees, double about) {
    const double lean = geom::radians(degrees);
    return {std::sin(lean) * std::cos(about), std::sin(lean) * std::sin(about), std::cos(lean)};
}

}  // namespace

TEST(TipStack, over_a_point_in_a_face_it_is_the_depth_by_the_cosine_of_its_lean) {
    const std::uint32_t seed = base::testing_seed();
    std::mt19937 random(seed);
    const auto in = [&](double low, double high) { return std::uniform_real_distribution(low, high)(random); };
    for (int n = 0; n < 30; ++n) {
        SCOPED_TRACE("seed " + std::to_string(seed) + ", case " + std::to_string(n));
        CutWorld w;
        w.simulation.flush();
        const double degrees = in(0, 60), depth = in(0.01, 2);
        const Vec3 axis = leaning(degrees, in(0, 6.28));
        const geom::PathElement way =
            geom::Straight{{in(10, 50), in(10, 30), -depth}, {in(10, 50), in(10, 30), -depth}};
        const TipStack found = highest_over_tip(w.simulation, {w.passes, way, axis, edges});
        EXPECT_NEAR(found.height, depth / std::cos(geom::radians(degrees)), 2e-4);
        EXPECT_NEAR(found.foot.z, -depth, 2e-4);
    }
}

TEST(TipStack, its_highest_place_on_the_way_is_found) {
    CutWorld w;
    w.simulation.flush();
    // Down to 1 mm in the middle, beside that up again.
    const geom::PathElement down = geom::Straight{{10, 20, 3}, {30.3, 20, -1}};
    const TipStack found = highest_over_tip(w.simulation, {0, down, {0, 0, 1}, edges});
    EXPECT_NEAR(found.height, 1, 1e-3);
    EXPECT_NEAR(found.foot.x, 30.3, 0.01);
}

TEST(TipStack, what_was_cut_before_is_not_there_and_what_is_cut_after_is) {
    CutWorld w;
    const std::uint32_t mill = w.tool(10);
    w.cut(mill, testing::straight({-20, 20, -3}, {80, 20, -3}));
    w.cut(mill, testing::straight({-20, 20, -5}, {80, 20, -5}));
    w.simulation.flush();
    const geom::PathElement way = geom::Straight{{20, 20, -4}, {40, 20, -4}};
    const auto height = [&](std::uint32_t before) {
        return highest_over_tip(w.simulation, {before, way, {0, 0, 1}, edges}).height;
    };
    EXPECT_NEAR(height(0), 4, 1e-3);
    EXPECT_NEAR(height(1), 1, 1e-3);
    EXPECT_EQ(height(2), 0);
}

TEST(TipStack, above_and_beside_the_stock_there_is_none) {
    CutWorld w;
    w.simulation.flush();
    for (const Vec3& at : {Vec3{20, 20, 0.001}, Vec3{-0.001, 20, -5}, Vec3{20, 50, -5}}) {
        const geom::PathElement way = geom::Straight{at, at};
        EXPECT_EQ(highest_over_tip(w.simulation, {0, way, {0, 0, 1}, edges}).height, 0);
    }
}

}  // namespace obrys::check
