#pragma once
/// Cycles at one hole: their arguments in order.
///
/// Sources: lists of NX Post Builder's SINUMERIK help and of Autodesk's siemens-840d post, which agree for CYCLE81 to
/// CYCLE89; CYCLE840: Programming Guide Cycles 11.02, 2.1.7. Behind the lists of the 840D stand those of the 840D sl:
/// geometry, plane and how arguments count (_GMODE, _DMODE, _AMODE). Of the latter those values are known that posts
/// write for what the older lists mean.

#include <array>
#include <cstdint>
#include <string_view>

#include "program/trait_parts.hpp"

namespace obrys::dialect::sinumerik {

namespace hole_arguments {

using enum program::HoleArgument;
using List = program::HoleArgument;

inline constexpr std::array<List, 9> drill{return_plane,   reference_plane, clearance, bottom, depth,
                                           dwell_or_turns, unknown,         plane,     modes};
inline constexpr std::array<List, 20> deep{return_plane, reference_plane, clearance,  bottom,         depth,
                                           first_bottom, first_depth,     degression, dwell_or_turns, dwell_first,
                                           feed_factor,  way_out,         axis,       least_infeed,   way_back,
                                           dwell_last,   stop_distance,   unknown,    plane,          modes};
inline constexpr std::array<List, 24> tap_rigid{
    return_plane, reference_plane, clearance, bottom,    depth,   dwell,      direction_after, size,
    pitch,        spindle_angle,   speed_in,  speed_out, axis,    pitch_unit, ignored,         steps,
    infeed,       way_back,        ignored,   ignored,   ignored, unknown,    plane,           modes};
inline constexpr std::array<List, 14> tap_floating{return_plane,   reference_plane, clearance, bottom, depth, dwell,
                                                   direction_back, direction_after, encoder,   size,   pitch, axis,
                                                   pitch_unit,     ignored};
inline constexpr std::array<List, 11> bore_feed{return_plane, reference_plane, clearance, bottom, depth, dwell,
                                                feed_in,      feed_out,        unknown,   plane,  modes};
inline constexpr std::array<List, 14> bore_orient{return_plane,  reference_plane, clearance, bottom,  depth,
                                                  dwell,         direction,       shift_u,   shift_v, shift_w,
                                                  spindle_angle, unknown,         plane,     modes};
inline constexpr std::array<List, 6> bore_stop{return_plane, reference_plane, clearance, bottom, depth, direction};
inline constexpr std::array<List, 7> bore_dwell_stop{return_plane, reference_plane, clearance, bottom,
                                                     depth,        dwell,           direction};
inline constexpr std::array<List, 9> bore_dwell{return_plane, reference_plane, clearance, bottom, depth,
                                                dwell,        unknown,         plane,     modes};

inline constexpr std::array dwell_in_seconds{10};
inline constexpr std::array deep_modes{10, 110, 1110, 1'001'110};
inline constexpr std::array tap_modes{1'001'002, 1'002'002};

}  // namespace hole_arguments

inline constexpr std::array<program::CalledHole, 10> called_holes{{
    {"CYCLE81", program::HoleShape::drill, hole_arguments::drill, hole_arguments::dwell_in_seconds},
    {"CYCLE82", program::HoleShape::drill, hole_arguments::drill, hole_arguments::dwell_in_seconds},
    {"CYCLE83", program::HoleShape::deep_drill, hole_arguments::deep, hole_arguments::deep_modes},
    {"CYCLE84", program::HoleShape::tap_rigid, hole_arguments::tap_rigid, hole_arguments::tap_modes},
    {"CYCLE840", program::HoleShape::tap_floating, hole_arguments::tap_floating},
    {"CYCLE85", program::HoleShape::bore_feed, hole_arguments::bore_feed, hole_arguments::dwell_in_seconds},
    {"CYCLE86", program::HoleShape::bore_orient, hole_arguments::bore_orient, hole_arguments::dwell_in_seconds},
    {"CYCLE87", program::HoleShape::bore_stop, hole_arguments::bore_stop, {}, true},
    {"CYCLE88", program::HoleShape::bore_stop, hole_arguments::bore_dwell_stop, {}, true},
    {"CYCLE89", program::HoleShape::bore_feed, hole_arguments::bore_dwell, hole_arguments::dwell_in_seconds},
}};

/// Index of the cycle in the table; its end where it has none of that name.
constexpr std::uint16_t form_of(std::string_view name) {
    std::uint16_t i = 0;
    while (i < called_holes.size() && called_holes[i].name != name) ++i;
    return i;
}

}  // namespace obrys::dialect::sinumerik
