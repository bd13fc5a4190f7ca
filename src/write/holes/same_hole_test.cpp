#include "write/holes/same_hole.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace obrys::write {
namespace {

using cl::CycleKind;
using Role = cl::CycleRole;

cl::Cycle cycle(CycleKind kind, std::vector<cl::CycleValue> values) {
    cl::Cycle out;
    out.kind = kind;
    out.values = std::move(values);
    return out;
}

/// With a feed of 200 mm/min and the spindle clockwise.
motion::State cutting() {
    motion::State out;
    out.feed.value = 200;
    out.spindle = {500, cl::SpindleMode::rpm, 1, 0, {}};
    return out;
}

/// "drill clearance 2 depth -12 …", in the order of their words; nothing: there is none.
std::string shown(const std::vector<HoleWay>& ways) {
    std::string out;
    for (const HoleWay& way : ways) {
        out += std::string(cl::spelling(way.cycle.kind));
        std::vector<std::string> values;
        for (const cl::CycleValue& v : way.cycle.values) {
            std::string number = std::to_string(v.value);
            number.erase(number.find_last_not_of('0') + 1);
            if (number.back() == '.') number.pop_back();
            values.push_back(std::string(cl::spelling(v.role)) + " " + number);
        }
        std::sort(values.begin(), values.end());
        for (const std::string& value : values) out += ", " + value;
        if (way.feed) out += "; at " + std::to_string(std::lround(*way.feed));
    }
    return out;
}

std::string same(CycleKind kind, std::vector<cl::CycleValue> values) {
    return shown(same_hole(cycle(kind, std::move(values)), cutting()));
}

TEST(SameHole, PlaneAndBottomAreASurfaceAClearanceAndADepth) {
    EXPECT_EQ(
        same(CycleKind::canned_drill,
             {{Role::retract_plane, 2}, {Role::bottom, -12}, {Role::return_level, 50}, {Role::dwell_bottom, 0.5}}),
        "drill, clearance 2, depth -12, dwell-bottom 0.5, dwell-top 0, feed-plunge 200, infeed 12, "
        "second-clearance 50, surface 0");
    // A hole that does not pass 0: 2 mm of clearance, and where there is less, half of it.
    EXPECT_EQ(same(CycleKind::canned_bore_feed, {{Role::retract_plane, -3}, {Role::bottom, -12}}),
              "ream, clearance 2, depth -7, dwell-bottom 0, feed-plunge 200, feed-retract 0, second-clearance 2, "
              "surface -5");
    EXPECT_EQ(same(CycleKind::canned_tap_rigid, {{Role::retract_plane, 6},
                                                 {Role::bottom, 5},
                                                 {Role::surface, 5.5},
                                                 {Role::pitch, 1},
                                                 {Role::spindle_direction, -1}}),
              "canned-tap-rigid, bottom 5, pitch 1, retract-plane 6, spindle-direction -1, surface 5.5tap-rigid, "
              "clearance 0.5, depth -0.5, pitch -1, second-clearance 0.5, surface 5.5");
}

TEST(SameHole, ASurfaceAClearanceAndADepthAreAPlaneAndABottom) {
    const std::vector<cl::CycleValue> hole{{Role::clearance, 2}, {Role::depth, -12},       {Role::surface, 1},
                                           {Role::infeed, 12},   {Role::feed_plunge, 150}, {Role::second_clearance, 20},
                                           {Role::dwell_top, 0}, {Role::dwell_bottom, 0}};
    EXPECT_EQ(same(CycleKind::drill, hole),
              "canned-drill, bottom -11, retract-plane 3, return-level 21, surface 1; at 150");
    auto steps = hole;
    steps[3].value = 5;
    EXPECT_EQ(same(CycleKind::drill, steps),
              "canned-peck, bottom -11, infeed 5, retract-plane 3, return-level 21, stop-distance-first 2, surface 1; "
              "at 150");
    steps[6].value = 0.5;  // it stands after each infeed
    EXPECT_EQ(same(CycleKind::drill, steps), "");
    EXPECT_EQ(same(CycleKind::tap_floating,
                   {{Role::clearance, 2}, {Role::depth, -12}, {Role::surface, 0}, {Role::feed_plunge, 500}}),
              "canned-tap-floating, bottom -12, retract-plane 2, spindle-direction 1, surface 0; at 500");
}

TEST(SameHole, InfeedsWithALittleBack) {
    EXPECT_EQ(same(CycleKind::canned_chip_break,
                   {{Role::retract_plane, 2}, {Role::bottom, -6}, {Role::infeed, 4}, {Role::chip_break_distance, 1}}),
              "universal-peck, chip-break-depth 4, chip-break-distance 1, clearance 2, decrement 0, depth -6, "
              "dwell-bottom 0, feed-plunge 200, infeed 6, min-infeed 0, second-clearance 2, stop-distance-first 1, "
              "stop-distance-last 1, surface 0");
}

TEST(SameHole, WhatIsNotUnderstoodIsNoHole) {
    const std::vector<cl::CycleValue> hole{{Role::retract_plane, 2}, {Role::bottom, -12}};
    auto more = hole, unknown = hole;
    more.push_back({Role::min_infeed, 1});
    unknown[1].value = NAN;
    EXPECT_EQ(same(CycleKind::canned_drill, more), "");
    EXPECT_EQ(same(CycleKind::canned_drill, unknown), "");
    EXPECT_EQ(same(CycleKind::canned_drill, {{Role::retract_plane, -12}, {Role::bottom, 2}}), "");
    EXPECT_EQ(same(CycleKind::canned_peck, hole), "") << "no infeed";
    EXPECT_EQ(same(CycleKind::bore_mill, hole), "");
    motion::State per_turn = cutting();
    per_turn.feed.mode = cl::FeedMode::per_rev;
    EXPECT_TRUE(same_hole(cycle(CycleKind::canned_drill, hole), per_turn).empty());
    EXPECT_TRUE(same_hole(cycle(CycleKind::canned_drill, hole), {}).empty()) << "no feed";
}

}  // namespace
}  // namespace obrys::write
