#include "cycles/hole/hole_testing.hpp"

namespace obrys::cycles::test {
namespace {

const Values deep = {{Role::surface, 0},       {Role::retract_plane, 2}, {Role::bottom, -40},
                     {Role::return_level, 50}, {Role::infeed, 15},       {Role::stop_distance_first, 0.8}};

/// 15, 10, 5, 5, and the rest of 5 …: no infeed is above the one before, the last two are equal.
TEST(canned_deep, InfeedsFallToTheirDecrement) {
    EXPECT_EQ(run(Kind::canned_deep, with(deep, {{Role::decrement, 5}}), situation(50)),
              "R w2 L w-15 R w2 R w-14.2 L w-25 R w2 R w-24.2 L w-30 R w2 R w-29.2 L w-35 R w2 R w-34.2 L w-40 R w50");
    EXPECT_EQ(run(Kind::canned_deep, with(deep, {{Role::decrement, 8}, {Role::bottom, -33}}), situation(50)),
              "R w2 L w-15 R w2 R w-14.2 L w-23 R w2 R w-22.2 L w-28 R w2 R w-27.2 L w-33 R w50");
    const Demand d{Kind::canned_deep, with(deep, {{Role::decrement, 5}})};
    EXPECT_FALSE(expand_hole(d, situation(50)).assumption.empty());
}

TEST(canned_deep, InfeedsFallByAFactorToTheLeast) {
    EXPECT_EQ(run(Kind::canned_deep,
                  with(deep, {{Role::infeed_factor, 0.5}, {Role::min_infeed, 6}, {Role::bottom, -33}}), situation(2)),
              "L w-15 R w2 R w-14.2 L w-22.5 R w2 R w-21.7 L w-28.5 R w2 R w-27.7 L w-33 R w50");
}

TEST(canned_deep, DwellsAndASlowFirstInfeed) {
    Situation s = situation(50);
    s.feed = 200;
    Values v = with(deep, {{Role::dwell, 1}, {Role::dwell_top, 2}, {Role::dwell_bottom, 3}, {Role::feed_factor, 50}});
    EXPECT_EQ(run(Kind::canned_deep, with(v, {{Role::bottom, -25}}), s),
              "R w2 F100 L w-15 F200 D1 R w2 D2 R w-14.2 L w-25 D3 R w50");
    std::erase_if(v, [](const cl::CycleValue& c) { return c.role == Role::stop_distance_first; });
    EXPECT_EQ(run(Kind::canned_deep, with(v, {{Role::bottom, -25}, {Role::chip_break_distance, 1}}), s),
              "R w2 F100 L w-15 F200 D1 R w-14 L w-25 D3 R w50");
}

TEST(canned_deep, WhatItCannotDoIsSaid) {
    for (const Values& more : std::vector<Values>{{{Role::infeed, 0}},
                                                  {{Role::infeed, 1e-5}},
                                                  {{Role::infeed_factor, 1.5}},
                                                  {{Role::surface, 3}},
                                                  {{Role::surface, -50}},
                                                  {{Role::bottom, 10}},
                                                  {{Role::dwell, -1}}})
        EXPECT_FALSE(expand_hole({Kind::canned_deep, with(deep, more)}, situation(50)).ok());
}

}  // namespace
}  // namespace obrys::cycles::test
