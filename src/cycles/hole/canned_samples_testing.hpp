#pragma once
/// Sound calls of the canned cycles, one of every kind.

#include "cycles/cycle_testing.hpp"

namespace obrys::cycles::test {

/// Every value in them is used.
inline std::vector<Sample> canned_samples() {
    const Values hole = {{Role::target_u, 3}, {Role::target_v, -4},     {Role::retract_plane, 2},
                         {Role::bottom, -20}, {Role::return_level, 50}, {Role::rise_first, 1}};
    const Values turning = {{Role::spindle_direction, 1}, {Role::dwell_bottom, 0.5}};
    const Values shift = {{Role::shift_u, 0.5}, {Role::shift_v, -0.25}};
    return {
        {Kind::canned_drill, with(hole, {{Role::dwell_bottom, 0.5}})},
        {Kind::canned_chip_break, with(hole, {{Role::infeed, 6},
                                              {Role::decrement, 1},
                                              {Role::min_infeed, 2},
                                              {Role::chip_break_distance, 0.254},
                                              {Role::retract_every, 8},
                                              {Role::stop_distance_first, 1},
                                              {Role::dwell_bottom, 0.5}})},
        {Kind::canned_peck, with(hole, {{Role::infeed, 6},
                                        {Role::length_unit, 1},
                                        {Role::stop_distance_first, 0.254},
                                        {Role::dwell_bottom, 0.5}})},
        {Kind::canned_deep, with(hole, {{Role::surface, 0},
                                        {Role::infeed, 6},
                                        {Role::decrement, 2},
                                        {Role::min_infeed, 1},
                                        {Role::infeed_factor, 1},
                                        {Role::stop_distance_first, 0.6},
                                        {Role::dwell, 0.1},
                                        {Role::dwell_top, 0.2},
                                        {Role::dwell_bottom, 0.5},
                                        {Role::feed_factor, 50}})},
        {Kind::canned_tap_floating, with(with(hole, turning), {{Role::dwell, 0.1},
                                                               {Role::dwell_top, 0.2},
                                                               {Role::starts_spindle, 1},
                                                               {Role::turned_axes, 0},
                                                               {Role::feed_out, 0}})},
        {Kind::canned_tap_rigid, with(with(hole, turning), {{Role::pitch, 1.25},
                                                            {Role::rpm_factor, 2},
                                                            {Role::infeed, 9},
                                                            {Role::chip_break_distance, 0},
                                                            {Role::stop_distance_first, 1}})},
        {Kind::canned_bore_feed, with(hole, {{Role::dwell_bottom, 0.5}, {Role::feed_out, 1}})},
        {Kind::canned_bore_stop, with(hole, turning)},
        {Kind::canned_bore_orient, with(with(hole, turning), shift)},
        {Kind::canned_back_bore,
         with(with(hole, shift),
              {{Role::spindle_direction, 1}, {Role::counterbore_top, -15}, {Role::dwell, 1}, {Role::feed_out, 1}})},
        {Kind::canned_bore_manual, with(with(hole, turning), {{Role::manual_retract, 1}})},
    };
}

}  // namespace obrys::cycles::test
