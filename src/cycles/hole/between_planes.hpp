#pragma once
/// Cycles of one hole between a retract plane and a bottom: the canned cycles of RS-274, Fanuc and Haas (G73, G74, G76,
/// G81 … G89) and of SINUMERIK (CYCLE81 … CYCLE89). Heights are absolute w in mm, feeds that are not said the one in
/// force. What the members of a cycle do beyond their comments: canned.cpp, canned_tap.cpp, canned_bore.cpp,
/// canned_deep.cpp.

#include "cycles/typed.hpp"

namespace obrys::cycles {

struct HolePlanes {
    /// They say their place themselves, and go there first.
    static constexpr bool anywhere = true;

    Said target_u, target_v;         ///< mm; neither is said: where the tool stands, without a move
    Said surface;                    ///< where infeeds count from; not said: the retract plane
    double retract_plane = unknown;  ///< to which the tool goes at rapid
    double bottom = unknown;
    Said return_level;  ///< where the cycle ends; not said: at the retract plane
    Said rise_first;    ///< 1: a tool below the retract plane rises to it before it moves in the plane; 2: as it moves
};

/// canned-drill (G81, G82)
struct Drilling : HolePlanes {
    static constexpr Kind kind = Kind::canned_drill;
    Said dwell_bottom;   ///< s
    Said finish_infeed;  ///< mm: the last bit of the way
    Said feed_factor;    ///< of it, %
};

/// What pecking and chip breaking share.
struct PeckInfeeds : HolePlanes {
    double infeed = unknown;           ///< mm
    Said decrement;                    ///< mm: each infeed is so much smaller than the one before
    Said min_infeed;                   ///< mm
    Said first_infeed, second_infeed;  ///< mm; larger than the others
    Said length_unit;                  ///< mm per unit in which the control adds up infeeds as binary numbers
    Said peck_to_surface;              ///< 1: out to the surface, not to the retract plane
    Said dwell_bottom;                 ///< s
};

/// canned-chip-break (G73)
struct ChipBreakDrilling : PeckInfeeds {
    static constexpr Kind kind = Kind::canned_chip_break;
    double chip_break_distance = unknown;  ///< mm, back after each infeed
    Said retract_every;                    ///< mm of depth, after which the tool goes out to the retract plane
    Said stop_distance_first;              ///< mm above the depth reached, where rapid down then ends
};

/// canned-peck (G83)
struct PeckDrilling : PeckInfeeds {
    static constexpr Kind kind = Kind::canned_peck;
    double stop_distance_first = unknown;  ///< mm above the depth reached, where rapid down ends
};

/// canned-deep (SINUMERIK CYCLE83): infeeds that fall
struct DeepDrilling : HolePlanes {
    static constexpr Kind kind = Kind::canned_deep;
    double infeed = unknown;   ///< mm: the first
    Said chip_break_distance;  ///< mm back after each infeed; not said: out to the retract plane
    Said stop_distance_first;  ///< mm above the depth reached, where rapid down ends
    Said decrement;            ///< mm: each infeed is so much smaller than the one before
    Said infeed_factor;        ///< each infeed is the one before times this; at most 1
    Said min_infeed;           ///< mm
    Said dwell;                ///< s, after each infeed
    Said dwell_top;            ///< s
    Said dwell_bottom;         ///< s
    Said feed_factor;          ///< of the first infeed, %
};

/// The spindle of a cycle that turns it.
struct HoleSpindle : HolePlanes {
    Said spindle_direction;  ///< +1, -1; not said: the one in force
    Said spindle_speed;      ///< 1/min; not said: the one in force
};

/// What both ways of tapping share.
struct Tapping : HoleSpindle {
    Said pitch;           ///< mm; not said: feed by speed
    Said starts_spindle;  ///< 1: the cycle turns the spindle on; 2: this is assumed
    Said rpm_factor;      ///< of the way out
    Said dwell_bottom;    ///< s
    Said dwell;           ///< s, at each reversal
    Said spindle_after;   ///< +1, -1, 0: how the spindle turns behind the cycle; not said: as before
};

/// canned-tap-floating (G74, G84)
struct FloatingTapping : Tapping {
    static constexpr Kind kind = Kind::canned_tap_floating;
    Said dwell_top;    ///< s
    Said feed_out;     ///< 1: feed over the whole way out
    Said turned_axes;  ///< fault of a control outside G17: 1 feeds to (v, w, u), 2 to (w, u, v)
};

/// canned-tap-rigid (G84 with M29, G331)
struct RigidTapping : Tapping {
    static constexpr Kind kind = Kind::canned_tap_rigid;
    Said infeed;               ///< mm; 0 and not said: in one go
    Said chip_break_distance;  ///< mm back after each infeed
    Said chip_break_turns;     ///< the same in pitches
    Said stop_distance_first;  ///< mm above the depth reached, behind a way out
};

/// canned-bore-feed (G85, G89)
struct FeedBoring : HolePlanes {
    static constexpr Kind kind = Kind::canned_bore_feed;
    Said dwell_bottom;  ///< s
    Said feed_out;      ///< 1: feed over the whole way out
    Said feed_plunge;   ///< mm/min; not said: the feed in force
    Said feed_retract;  ///< mm/min; not said: the feed in force
};

/// canned-bore-stop (G86)
struct StopBoring : HoleSpindle {
    static constexpr Kind kind = Kind::canned_bore_stop;
    Said stops_program;   ///< 1: the program stops at the bottom
    Said starts_spindle;  ///< 1: the cycle turns the spindle on
    Said spindle_after;   ///< +1, -1, 0: how the spindle turns behind the cycle; not said: as before
    Said dwell_bottom;    ///< s
};

/// canned-bore-orient (G76)
struct OrientedBoring : HoleSpindle {
    static constexpr Kind kind = Kind::canned_bore_orient;
    Said starts_spindle;       ///< 1: the cycle turns the spindle on
    Said spindle_after;        ///< +1, -1, 0: how the spindle turns behind the cycle; not said: as before
    Said dwell_bottom;         ///< s
    double shift_u = unknown;  ///< mm, sideways at the bottom
    double shift_v = unknown;
    Said shift_w;        ///< mm, along the tool
    Said spindle_angle;  ///< degrees; not said: where the machine is set to
};

/// canned-back-bore (G87). Its retract plane may be missing: it goes in from where the tool is.
struct BackBoring {
    static constexpr Kind kind = Kind::canned_back_bore;
    static constexpr bool anywhere = true;
    Said target_u, target_v;  ///< as of HolePlanes
    Said surface;             ///< says nothing here
    Said retract_plane;       ///< said only where the tool stops there first
    double bottom = unknown;  ///< where the tool comes on the axis again, below the material
    Said return_level;
    Said rise_first;
    double shift_u = unknown;  ///< mm: from the axis, where the tool goes in and out
    double shift_v = unknown;
    double counterbore_top = unknown;  ///< where boring from below ends
    Said spindle_direction, spindle_speed;
    Said feed_out;  ///< 1: back down at feed before the tool leaves the axis
    Said dwell;     ///< s, at the top of the counterbore
};

/// canned-bore-manual (G88)
struct ManualBoring : HoleSpindle {
    static constexpr Kind kind = Kind::canned_bore_manual;
    Said dwell_bottom;    ///< s
    Said manual_retract;  ///< 1: the path holds the operator's move out
};

// --- The tables.

template <>
inline constexpr auto members_of<HolePlanes> = rows<HolePlanes>({
    {Role::target_u, &HolePlanes::target_u},
    {Role::target_v, &HolePlanes::target_v},
    {Role::surface, &HolePlanes::surface, Must::be_asked_for},
    {Role::retract_plane, &HolePlanes::retract_plane},
    {Role::bottom, &HolePlanes::bottom},
    {Role::return_level, &HolePlanes::return_level},
    {Role::rise_first, &HolePlanes::rise_first},
});

template <>
inline constexpr auto members_of<Drilling> =
    joined<Drilling>(members_of<HolePlanes>, rows<Drilling>({
                                                 {Role::dwell_bottom, &Drilling::dwell_bottom, Must::be_at_least_0},
                                                 {Role::finish_infeed, &Drilling::finish_infeed, Must::be_at_least_0},
                                                 {Role::feed_factor, &Drilling::feed_factor, Must::be_asked_for},
                                             }));

template <>
inline constexpr auto members_of<PeckInfeeds> = joined<PeckInfeeds>(
    members_of<HolePlanes>, rows<PeckInfeeds>({
                                {Role::peck_to_surface, &PeckInfeeds::peck_to_surface},
                                {Role::length_unit, &PeckInfeeds::length_unit},
                                {Role::infeed, &PeckInfeeds::infeed, Must::be_above_0},
                                {Role::decrement, &PeckInfeeds::decrement, Must::be_at_least_0},
                                {Role::min_infeed, &PeckInfeeds::min_infeed, Must::be_at_least_0},
                                {Role::first_infeed, &PeckInfeeds::first_infeed, Must::be_at_least_0},
                                {Role::second_infeed, &PeckInfeeds::second_infeed, Must::be_at_least_0},
                            }));

template <>
inline constexpr auto members_of<ChipBreakDrilling> = joined<ChipBreakDrilling>(
    members_of<PeckInfeeds>,
    rows<ChipBreakDrilling>({
        {Role::chip_break_distance, &ChipBreakDrilling::chip_break_distance, Must::be_at_least_0},
        {Role::retract_every, &ChipBreakDrilling::retract_every, Must::be_at_least_0},
        {Role::stop_distance_first, &ChipBreakDrilling::stop_distance_first, Must::be_asked_for},
        {Role::dwell_bottom, &ChipBreakDrilling::dwell_bottom, Must::be_at_least_0},
    }));

template <>
inline constexpr auto members_of<PeckDrilling> = joined<PeckDrilling>(
    members_of<PeckInfeeds>, rows<PeckDrilling>({
                                 {Role::stop_distance_first, &PeckDrilling::stop_distance_first, Must::be_at_least_0},
                                 {Role::dwell_bottom, &PeckDrilling::dwell_bottom, Must::be_at_least_0},
                             }));

template <>
inline constexpr auto members_of<DeepDrilling> = joined<DeepDrilling>(
    members_of<HolePlanes>, rows<DeepDrilling>({
                                {Role::infeed, &DeepDrilling::infeed, Must::be_above_0},
                                {Role::stop_distance_first, &DeepDrilling::stop_distance_first, Must::be_asked_for},
                                {Role::chip_break_distance, &DeepDrilling::chip_break_distance, Must::be_at_least_0},
                                {Role::decrement, &DeepDrilling::decrement, Must::be_at_least_0},
                                {Role::infeed_factor, &DeepDrilling::infeed_factor, Must::be_above_0},
                                {Role::min_infeed, &DeepDrilling::min_infeed, Must::be_at_least_0},
                                {Role::dwell, &DeepDrilling::dwell, Must::be_at_least_0},
                                {Role::dwell_top, &DeepDrilling::dwell_top, Must::be_at_least_0},
                                {Role::dwell_bottom, &DeepDrilling::dwell_bottom, Must::be_at_least_0},
                                {Role::feed_factor, &DeepDrilling::feed_factor, Must::be_above_0},
                            }));

template <>
inline constexpr auto members_of<FloatingTapping> = joined<FloatingTapping>(
    members_of<HolePlanes>, rows<FloatingTapping>({
                                {Role::rpm_factor, &FloatingTapping::rpm_factor, Must::be_above_0},
                                {Role::spindle_speed, &FloatingTapping::spindle_speed, Must::be_at_least_0},
                                {Role::spindle_direction, &FloatingTapping::spindle_direction},
                                {Role::starts_spindle, &FloatingTapping::starts_spindle},
                                {Role::pitch, &FloatingTapping::pitch, Must::be_above_0},
                                {Role::dwell_bottom, &FloatingTapping::dwell_bottom, Must::be_at_least_0},
                                {Role::dwell, &FloatingTapping::dwell, Must::be_at_least_0},
                                {Role::dwell_top, &FloatingTapping::dwell_top, Must::be_at_least_0},
                                {Role::spindle_after, &FloatingTapping::spindle_after},
                                {Role::feed_out, &FloatingTapping::feed_out},
                                {Role::turned_axes, &FloatingTapping::turned_axes},
                            }));

template <>
inline constexpr auto members_of<RigidTapping> = joined<RigidTapping>(
    members_of<HolePlanes>, rows<RigidTapping>({
                                {Role::pitch, &RigidTapping::pitch, Must::be_above_0},
                                {Role::spindle_direction, &RigidTapping::spindle_direction},
                                {Role::starts_spindle, &RigidTapping::starts_spindle},
                                {Role::spindle_speed, &RigidTapping::spindle_speed, Must::be_at_least_0},
                                {Role::rpm_factor, &RigidTapping::rpm_factor, Must::be_above_0},
                                {Role::dwell_bottom, &RigidTapping::dwell_bottom, Must::be_at_least_0},
                                {Role::dwell, &RigidTapping::dwell, Must::be_at_least_0},
                                {Role::spindle_after, &RigidTapping::spindle_after},
                                {Role::infeed, &RigidTapping::infeed, Must::be_asked_for},
                                {Role::chip_break_distance, &RigidTapping::chip_break_distance, Must::be_asked_for},
                                {Role::chip_break_turns, &RigidTapping::chip_break_turns, Must::be_asked_for},
                                {Role::stop_distance_first, &RigidTapping::stop_distance_first, Must::be_asked_for},
                            }));

template <>
inline constexpr auto members_of<FeedBoring> =
    joined<FeedBoring>(members_of<HolePlanes>, rows<FeedBoring>({
                                                   {Role::dwell_bottom, &FeedBoring::dwell_bottom, Must::be_at_least_0},
                                                   {Role::feed_out, &FeedBoring::feed_out},
                                                   {Role::feed_plunge, &FeedBoring::feed_plunge, Must::be_above_0},
                                                   {Role::feed_retract, &FeedBoring::feed_retract, Must::be_above_0},
                                               }));

template <>
inline constexpr auto members_of<HoleSpindle> = joined<HoleSpindle>(
    members_of<HolePlanes>, rows<HoleSpindle>({
                                {Role::spindle_speed, &HoleSpindle::spindle_speed, Must::be_at_least_0},
                                {Role::spindle_direction, &HoleSpindle::spindle_direction},
                            }));

template <>
inline constexpr auto members_of<StopBoring> = joined<StopBoring>(
    members_of<HolePlanes>, rows<StopBoring>({
                                {Role::stops_program, &StopBoring::stops_program},
                                {Role::spindle_speed, &StopBoring::spindle_speed, Must::be_at_least_0},
                                {Role::spindle_direction, &StopBoring::spindle_direction},
                                {Role::starts_spindle, &StopBoring::starts_spindle},
                                {Role::spindle_after, &StopBoring::spindle_after},
                                {Role::dwell_bottom, &StopBoring::dwell_bottom, Must::be_at_least_0},
                            }));

template <>
inline constexpr auto members_of<OrientedBoring> = joined<OrientedBoring>(
    members_of<HoleSpindle>, rows<OrientedBoring>({
                                 {Role::starts_spindle, &OrientedBoring::starts_spindle},
                                 {Role::spindle_after, &OrientedBoring::spindle_after},
                                 {Role::dwell_bottom, &OrientedBoring::dwell_bottom, Must::be_at_least_0},
                                 {Role::shift_u, &OrientedBoring::shift_u},
                                 {Role::shift_v, &OrientedBoring::shift_v},
                                 {Role::shift_w, &OrientedBoring::shift_w},
                                 {Role::spindle_angle, &OrientedBoring::spindle_angle},
                             }));

template <>
inline constexpr auto members_of<BackBoring> = rows<BackBoring>({
    {Role::target_u, &BackBoring::target_u},
    {Role::target_v, &BackBoring::target_v},
    {Role::surface, &BackBoring::surface, Must::be_asked_for},
    {Role::retract_plane, &BackBoring::retract_plane},
    {Role::bottom, &BackBoring::bottom},
    {Role::return_level, &BackBoring::return_level},
    {Role::rise_first, &BackBoring::rise_first},
    {Role::counterbore_top, &BackBoring::counterbore_top},
    {Role::shift_u, &BackBoring::shift_u},
    {Role::shift_v, &BackBoring::shift_v},
    {Role::feed_out, &BackBoring::feed_out},
    {Role::spindle_speed, &BackBoring::spindle_speed, Must::be_at_least_0},
    {Role::spindle_direction, &BackBoring::spindle_direction},
    {Role::dwell, &BackBoring::dwell, Must::be_at_least_0},
});

template <>
inline constexpr auto members_of<ManualBoring> = joined<ManualBoring>(
    members_of<HoleSpindle>, rows<ManualBoring>({
                                 {Role::manual_retract, &ManualBoring::manual_retract},
                                 {Role::dwell_bottom, &ManualBoring::dwell_bottom, Must::be_at_least_0},
                             }));

}  // namespace obrys::cycles
