#pragma once
/// Threads tapped or cut below a surface: HEIDENHAIN's CYCL DEF 2, 17, 18, 206, 207, 209. As below_surface.hpp; what
/// the members do beyond their comments: tap.cpp.

#include "cycles/hole/below_surface.hpp"

namespace obrys::cycles {

/// tap-floating-simple (2)
struct OldFloatingTapping : OldDepth {
    static constexpr Kind kind = Kind::tap_floating_simple;
    Said feed_plunge;  ///< 0 and not said: the feed programmed last
    Said dwell;
};

/// tap-floating (206)
struct DepthFloatingTapping : BelowSurface {
    static constexpr Kind kind = Kind::tap_floating;
    double feed_plunge = unknown;
    Said dwell_bottom;
};

/// tap-rigid-simple (17)
struct OldRigidTapping : OldDepth {
    static constexpr Kind kind = Kind::tap_rigid_simple;
    double pitch = unknown;  ///< negative: left hand
};

/// tap-rigid (207)
struct DepthRigidTapping : BelowSurface {
    static constexpr Kind kind = Kind::tap_rigid;
    double pitch = unknown;  ///< negative: left hand
};

/// tap-chip-breaking (209)
struct ChipBreakTapping : BelowSurface {
    static constexpr Kind kind = Kind::tap_chip_breaking;
    double pitch = unknown;    ///< negative: left hand
    Said chip_break_depth;     ///< 0 and not said: in one go
    Said chip_break_distance;  ///< in pitches; 0 and not said: out of the hole
    Said rpm_factor;           ///< of the way out; 0 and not said: 1
    Said spindle_angle;        ///< says nothing here: where the thread begins does not matter to the path
};

/// thread-cut (18): one pass from where the tool stands
struct ThreadCutting {
    static constexpr Kind kind = Kind::thread_cut;
    static constexpr bool anywhere = false;
    double depth = unknown;  ///< its sign is the direction
    double pitch = unknown;
};

// --- The tables.

template <>
inline constexpr auto members_of<OldFloatingTapping> = joined<OldFloatingTapping>(
    members_of<OldDepth>, rows<OldFloatingTapping>({
                              {Role::feed_plunge, &OldFloatingTapping::feed_plunge, Must::be_feed_or_0},
                              {Role::dwell, &OldFloatingTapping::dwell, Must::be_at_least_0},
                          }));

template <>
inline constexpr auto members_of<DepthFloatingTapping> = joined<DepthFloatingTapping>(
    members_of<BelowSurface>, rows<DepthFloatingTapping>({
                                  {Role::feed_plunge, &DepthFloatingTapping::feed_plunge, Must::be_feed},
                                  {Role::dwell_bottom, &DepthFloatingTapping::dwell_bottom, Must::be_at_least_0},
                              }));

template <>
inline constexpr auto members_of<OldRigidTapping> =
    joined<OldRigidTapping>(members_of<OldDepth>, rows<OldRigidTapping>({
                                                      {Role::pitch, &OldRigidTapping::pitch, Must::be_other_than_0},
                                                  }));

template <>
inline constexpr auto members_of<DepthRigidTapping> = joined<DepthRigidTapping>(
    members_of<BelowSurface>, rows<DepthRigidTapping>({
                                  {Role::pitch, &DepthRigidTapping::pitch, Must::be_other_than_0},
                              }));

template <>
inline constexpr auto members_of<ChipBreakTapping> = joined<ChipBreakTapping>(
    members_of<BelowSurface>,
    rows<ChipBreakTapping>({
        {Role::pitch, &ChipBreakTapping::pitch, Must::be_other_than_0},
        {Role::chip_break_depth, &ChipBreakTapping::chip_break_depth, Must::be_at_least_0},
        {Role::chip_break_distance, &ChipBreakTapping::chip_break_distance, Must::be_at_least_0},
        {Role::rpm_factor, &ChipBreakTapping::rpm_factor, Must::be_at_least_0},
        {Role::spindle_angle, &ChipBreakTapping::spindle_angle, Must::be_asked_for},
    }));

template <>
inline constexpr auto members_of<ThreadCutting> = rows<ThreadCutting>({
    {Role::depth, &ThreadCutting::depth},
    {Role::pitch, &ThreadCutting::pitch, Must::be_other_than_0},
});

}  // namespace obrys::cycles
