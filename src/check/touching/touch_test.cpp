/// Places of a body that are looked at are the body's own, whichever way it goes.

#include "check/touching/touch.hpp"

#include <gtest/gtest.h>

#include <random>

#include "base/seed_testing.hpp"
#include "sim/milling/cutter.hpp"

namespace obrys::check {

namespace milling = sim::milling;

using geom::Vec3;

/// A tool that goes back on the way it has cut, along its leaning axis or across it, touches nothing.
TEST(Touch, BackOnTheWayThatWasCutNothingTouches) {
    const std::uint32_t seed = base::testing_seed();
    std::mt19937 random(seed);
    const auto in = [&](double low, double high) { return std::uniform_real_distribution(low, high)(random); };
    for (int n = 0; n < 30; ++n) {
        SCOPED_TRACE("seed " + std::to_string(seed) + ", case " + std::to_string(n));
        const milling::Stock stock = milling::Box3{{0, 0, -20}, {60, 40, 0}};
        milling::Simulation s(stock, *milling::make_lattice(milling::box_of(stock), 1), 0.01, 1);
        milling::Cutter c;
        c.diameter = in(2, 12);
        c.cutting_length = 60;
        const std::uint32_t tool = s.add_tool(milling::shape_of(c).shape);
        Vec3 axis{in(-0.5, 0.5), in(-0.5, 0.5), 1};
        axis = (1 / geom::length(axis)) * axis;
        const Vec3 low{in(10, 50), in(10, 30), in(-15, -5)};
        const Vec3 high = n % 2 == 0 ? low + 40.0 * axis : Vec3{in(10, 50), in(10, 30), in(-15, -5)};
        const geom::Straight cut{high, low};
        ASSERT_EQ(s.add({cut, axis, tool}), milling::Taken::taken);
        s.flush();
        Cleared left(stock, 0.001, 1);
        left.advance(s, 1);
        const std::vector<std::vector<geom::Vec2>> profiles{{{c.diameter / 2, 0}, {c.diameter / 2, 60}}};
        const geom::PathElement back = geom::Straight{low, high};
        EXPECT_LE(touch(left, {back, axis, profiles, {-100, 100}, 2}).depth, 1e-6);
        // A little deeper it does.
        const geom::PathElement deeper = geom::Straight{low - 0.1 * axis, high};
        EXPECT_GT(touch(left, {deeper, axis, profiles, {-100, 100}, 2}).depth, 0.01);
    }
}

}  // namespace obrys::check
