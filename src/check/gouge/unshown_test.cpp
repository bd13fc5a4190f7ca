#include "check/gouge/unshown.hpp"

#include <gtest/gtest.h>

#include "mesh/primitives.hpp"
#include "sim/milling/cutter.hpp"

namespace obrys::check {

namespace milling = sim::milling;

using geom::Vec3;

TEST(Unfollowed, only_what_lies_at_an_open_place_and_is_empty_is_left_out) {
    milling::Simulation s(milling::Box3{{0, 0, -20}, {60, 40, 0}},
                          *milling::make_lattice({{0, 0, -20}, {60, 40, 0}}, 1), 0.01, 1);
    milling::Cutter c;
    c.diameter = 10;
    c.cutting_length = 60;
    ASSERT_EQ(s.add({geom::Straight{{-20, 20, -5}, {80, 20, -5}}, {0, 0, 1}, s.add_tool(milling::shape_of(c).shape)}),
              milling::Taken::taken);
    s.flush();
    const mesh::Mesh surface;
    const mesh::Distance part(mesh::box({0, 0, -20}, {60, 40, -6}));
    const ThreadBands threads;
    const Machined machined{surface, s, part, threads, [](std::uint32_t) { return 0U; }, {}};
    const auto stays = [&](Vec3 at, double high, const milling::Box3& open) {
        mesh::Place place;
        place.at = at;
        place.deviation = high;
        std::vector<mesh::Place> places{place};
        drop_unfollowed(places, std::vector{open}, machined);
        return !places.empty();
    };
    const milling::Box3 there{{29, 19, -5}, {31, 21, -4}}, elsewhere{{10, 19, -5}, {11, 21, -4}};
    EXPECT_FALSE(stays({30, 20, -4}, 1, there));      // in the middle of the slot
    EXPECT_TRUE(stays({30, 20, -4}, 1, elsewhere));   // the surface is right there
    EXPECT_TRUE(stays({30, 20, -5}, 1, there));       // the slot's floor
    EXPECT_TRUE(stays({30, 20, -4.995}, 1, there));   // the same within the tolerance
    EXPECT_TRUE(stays({30, 20, -4.6}, 1, there));     // material not far below it
    EXPECT_FALSE(stays({30, 20, -4.6}, 0.5, there));  // farther than half of what is claimed
    EXPECT_TRUE(stays({30, 20, -5.5}, 0.5, there));   // in the material
}

}  // namespace obrys::check
