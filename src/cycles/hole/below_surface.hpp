#pragma once
/// Cycles of one hole below a surface: HEIDENHAIN's CYCL DEF 1, 200 … 205, 208, 240, 241. They begin where the
/// tool stands in the plane. Lengths in mm, feeds in mm/min (infinity: rapid traverse), times in s. What the members of
/// a cycle do beyond their comments: drill.cpp, bore.cpp.

#include "cycles/heights.hpp"

namespace obrys::cycles {

/// Of the old forms: the tool stands at the clearance above the surface, and returns there.
struct OldDepth {
    static constexpr bool anywhere = false;
    double clearance = unknown;  ///< older programs write it with the depth's sign
    double depth = unknown;      ///< from the surface, negative
};

/// peck (1)
struct OldPecking : OldDepth {
    static constexpr Kind kind = Kind::peck;
    double infeed = unknown;  ///< older programs write it with the depth's sign
    Said dwell;
    Said feed_plunge;  ///< 0 and not said: the feed programmed last
};

/// drill (200)
struct DepthDrilling : BelowSurface {
    static constexpr Kind kind = Kind::drill;
    Said depth_reference;  ///< not 0: the depth is that of the full diameter, the point goes deeper
    double infeed = unknown;
    double feed_plunge = unknown;
    Said dwell_top, dwell_bottom;
};

/// universal-drill (203)
struct UniversalDrilling : BelowSurface {
    static constexpr Kind kind = Kind::universal_drill;
    Said depth_reference;  ///< as of DepthDrilling
    double infeed = unknown;
    Said decrement, min_infeed;
    double feed_plunge = unknown;
    Said feed_retract;  ///< 0 and not said: as plunging
    Said breaks_before_retract;
    Said chip_break_distance;
    Said dwell_top, dwell_bottom;
};

/// universal-peck (205)
struct UniversalPecking : BelowSurface {
    static constexpr Kind kind = Kind::universal_peck;
    Said depth_reference;  ///< as of DepthDrilling
    double infeed = unknown;
    Said decrement, min_infeed;
    double feed_plunge = unknown;
    Said stop_distance_first, stop_distance_last;  ///< the last not said: as the first
    Said chip_break_depth, chip_break_distance;
    Said dwell_bottom;
    Said deepened_start;  ///< below the surface, positive
    Said feed_position;   ///< to the deepened start
    Said feed_retract;    ///< 0 and not said: rapid
};

/// centre (240)
struct Centring {
    static constexpr Kind kind = Kind::centre;
    static constexpr bool anywhere = false;
    double surface = unknown;  ///< as of BelowSurface
    double clearance = unknown;
    Said centre_by_diameter;  ///< not 0: diameter counts, else depth
    Said diameter;            ///< the manual writes it negative
    Said depth;
    Said second_clearance;
    double feed_plunge = unknown;
    Said dwell_bottom;
};

/// single-lip (241)
struct SingleLipDrilling : BelowSurface {
    static constexpr Kind kind = Kind::single_lip;
    double feed_plunge = unknown;
    Said feed_retract;  ///< 0 and not said: as plunging
    Said dwell_bottom;
    Said deepened_start;           ///< below the surface, positive
    Said feed_position;            ///< to it
    Said spindle_direction;        ///< 3 M3, 4 M4, 5 standing in and out
    Said spindle_speed_position;   ///< 1/min, in and out
    Said spindle_speed;            ///< 1/min, drilling; not said: the one in force
    Said dwell_depth;              ///< says nothing here: the tool waits there, which is not run
    Said coolant_on, coolant_off;  ///< numbers of M functions
};

/// ream (201)
struct Reaming : BelowSurface {
    static constexpr Kind kind = Kind::ream;
    double feed_plunge = unknown;
    Said feed_retract;  ///< 0 and not said: as plunging
    Said dwell_bottom;
};

/// bore (202)
struct DepthBoring : BelowSurface {
    static constexpr Kind kind = Kind::bore;
    double feed_plunge = unknown;
    Said feed_retract;  ///< 0 and not said: as plunging
    Said dwell_bottom;
    double retract_direction = unknown;  ///< 0 none, 1 u-, 2 v-, 3 u+, 4 v+
    Said spindle_angle;                  ///< degrees; not said: where the machine is set to
};

/// back-bore (204)
struct Counterboring {
    static constexpr Kind kind = Kind::back_bore;
    static constexpr bool anywhere = false;
    double surface = unknown;  ///< as of BelowSurface
    double clearance = unknown;
    Said second_clearance;
    double counterbore_depth = unknown;  ///< from the underside, upwards positive
    double thickness = unknown;
    double off_centre = unknown, edge_height = unknown;
    double feed_position = unknown, feed_countersink = unknown;
    Said dwell;
    double retract_direction = unknown;  ///< 1 u-, 2 v-, 3 u+, 4 v+
    Said spindle_angle;                  ///< degrees; not said: where the machine is set to
};

/// bore-mill (208)
struct BoreMilling : BelowSurface {
    static constexpr Kind kind = Kind::bore_mill;
    double feed_plunge = unknown;
    double infeed_per_turn = unknown;
    double diameter = unknown;
    Said predrilled_diameter;
    Said direction;  ///< +1 climb, -1 up-cut
};

// --- The tables.

template <>
inline constexpr auto members_of<OldDepth> = rows<OldDepth>({
    {Role::clearance, &OldDepth::clearance},
    {Role::depth, &OldDepth::depth, Must::go_deep},
});

template <>
inline constexpr auto members_of<OldPecking> =
    joined<OldPecking>(members_of<OldDepth>, rows<OldPecking>({
                                                 {Role::infeed, &OldPecking::infeed, Must::be_other_than_0},
                                                 {Role::dwell, &OldPecking::dwell, Must::be_at_least_0},
                                                 {Role::feed_plunge, &OldPecking::feed_plunge, Must::be_feed_or_0},
                                             }));

template <>
inline constexpr auto members_of<DepthDrilling> = joined<DepthDrilling>(
    members_of<BelowSurface>, rows<DepthDrilling>({
                                  {Role::depth_reference, &DepthDrilling::depth_reference},
                                  {Role::infeed, &DepthDrilling::infeed, Must::be_above_0},
                                  {Role::feed_plunge, &DepthDrilling::feed_plunge, Must::be_feed},
                                  {Role::dwell_top, &DepthDrilling::dwell_top, Must::be_at_least_0},
                                  {Role::dwell_bottom, &DepthDrilling::dwell_bottom, Must::be_at_least_0},
                              }));

template <>
inline constexpr auto members_of<UniversalDrilling> = joined<UniversalDrilling>(
    members_of<BelowSurface>,
    rows<UniversalDrilling>({
        {Role::depth_reference, &UniversalDrilling::depth_reference},
        {Role::infeed, &UniversalDrilling::infeed, Must::be_above_0},
        {Role::decrement, &UniversalDrilling::decrement, Must::be_at_least_0},
        {Role::min_infeed, &UniversalDrilling::min_infeed, Must::be_at_least_0},
        {Role::feed_plunge, &UniversalDrilling::feed_plunge, Must::be_feed},
        {Role::feed_retract, &UniversalDrilling::feed_retract, Must::be_feed_or_0},
        {Role::breaks_before_retract, &UniversalDrilling::breaks_before_retract, Must::be_at_least_0},
        {Role::chip_break_distance, &UniversalDrilling::chip_break_distance, Must::be_at_least_0},
        {Role::dwell_top, &UniversalDrilling::dwell_top, Must::be_at_least_0},
        {Role::dwell_bottom, &UniversalDrilling::dwell_bottom, Must::be_at_least_0},
    }));

template <>
inline constexpr auto members_of<UniversalPecking> = joined<UniversalPecking>(
    members_of<BelowSurface>,
    rows<UniversalPecking>({
        {Role::depth_reference, &UniversalPecking::depth_reference},
        {Role::infeed, &UniversalPecking::infeed, Must::be_above_0},
        {Role::decrement, &UniversalPecking::decrement, Must::be_at_least_0},
        {Role::min_infeed, &UniversalPecking::min_infeed, Must::be_at_least_0},
        {Role::feed_plunge, &UniversalPecking::feed_plunge, Must::be_feed},
        {Role::stop_distance_first, &UniversalPecking::stop_distance_first, Must::be_at_least_0},
        {Role::stop_distance_last, &UniversalPecking::stop_distance_last, Must::be_at_least_0},
        {Role::chip_break_depth, &UniversalPecking::chip_break_depth, Must::be_at_least_0},
        {Role::chip_break_distance, &UniversalPecking::chip_break_distance, Must::be_at_least_0},
        {Role::dwell_bottom, &UniversalPecking::dwell_bottom, Must::be_at_least_0},
        {Role::deepened_start, &UniversalPecking::deepened_start, Must::be_at_least_0},
        {Role::feed_position, &UniversalPecking::feed_position, Must::be_asked_for},
        {Role::feed_retract, &UniversalPecking::feed_retract, Must::be_feed_or_0},
    }));

template <>
inline constexpr auto members_of<Centring> = rows<Centring>({
    {Role::surface, &Centring::surface},
    {Role::clearance, &Centring::clearance, Must::be_at_least_0},
    {Role::centre_by_diameter, &Centring::centre_by_diameter},
    {Role::diameter, &Centring::diameter, Must::be_asked_for},
    {Role::depth, &Centring::depth, Must::be_asked_for},
    {Role::second_clearance, &Centring::second_clearance, Must::be_at_least_0},
    {Role::feed_plunge, &Centring::feed_plunge, Must::be_feed},
    {Role::dwell_bottom, &Centring::dwell_bottom, Must::be_at_least_0},
});

template <>
inline constexpr auto members_of<SingleLipDrilling> = joined<SingleLipDrilling>(
    members_of<BelowSurface>,
    rows<SingleLipDrilling>({
        {Role::feed_plunge, &SingleLipDrilling::feed_plunge, Must::be_feed},
        {Role::feed_retract, &SingleLipDrilling::feed_retract, Must::be_feed_or_0},
        {Role::dwell_bottom, &SingleLipDrilling::dwell_bottom, Must::be_at_least_0},
        {Role::deepened_start, &SingleLipDrilling::deepened_start, Must::be_at_least_0},
        {Role::feed_position, &SingleLipDrilling::feed_position, Must::be_asked_for},
        {Role::spindle_direction, &SingleLipDrilling::spindle_direction},
        {Role::spindle_speed_position, &SingleLipDrilling::spindle_speed_position, Must::be_at_least_0},
        {Role::spindle_speed, &SingleLipDrilling::spindle_speed, Must::be_at_least_0},
        {Role::coolant_on, &SingleLipDrilling::coolant_on, Must::be_at_least_0},
        {Role::coolant_off, &SingleLipDrilling::coolant_off, Must::be_at_least_0},
        {Role::dwell_depth, &SingleLipDrilling::dwell_depth, Must::be_asked_for},
    }));

template <>
inline constexpr auto members_of<Reaming> =
    joined<Reaming>(members_of<BelowSurface>, rows<Reaming>({
                                                  {Role::feed_plunge, &Reaming::feed_plunge, Must::be_feed},
                                                  {Role::feed_retract, &Reaming::feed_retract, Must::be_feed_or_0},
                                                  {Role::dwell_bottom, &Reaming::dwell_bottom, Must::be_at_least_0},
                                              }));

template <>
inline constexpr auto members_of<DepthBoring> = joined<DepthBoring>(
    members_of<BelowSurface>, rows<DepthBoring>({
                                  {Role::feed_plunge, &DepthBoring::feed_plunge, Must::be_feed},
                                  {Role::feed_retract, &DepthBoring::feed_retract, Must::be_feed_or_0},
                                  {Role::dwell_bottom, &DepthBoring::dwell_bottom, Must::be_at_least_0},
                                  {Role::retract_direction, &DepthBoring::retract_direction},
                                  {Role::spindle_angle, &DepthBoring::spindle_angle},
                              }));

template <>
inline constexpr auto members_of<Counterboring> = rows<Counterboring>({
    {Role::surface, &Counterboring::surface},
    {Role::clearance, &Counterboring::clearance, Must::be_at_least_0},
    {Role::second_clearance, &Counterboring::second_clearance, Must::be_at_least_0},
    {Role::counterbore_depth, &Counterboring::counterbore_depth},
    {Role::thickness, &Counterboring::thickness, Must::be_above_0},
    {Role::off_centre, &Counterboring::off_centre, Must::be_above_0},
    {Role::edge_height, &Counterboring::edge_height, Must::be_at_least_0},
    {Role::feed_position, &Counterboring::feed_position, Must::be_feed},
    {Role::feed_countersink, &Counterboring::feed_countersink, Must::be_feed},
    {Role::dwell, &Counterboring::dwell, Must::be_at_least_0},
    {Role::retract_direction, &Counterboring::retract_direction},
    {Role::spindle_angle, &Counterboring::spindle_angle},
});

template <>
inline constexpr auto members_of<BoreMilling> = joined<BoreMilling>(
    members_of<BelowSurface>, rows<BoreMilling>({
                                  {Role::feed_plunge, &BoreMilling::feed_plunge, Must::be_feed},
                                  {Role::infeed_per_turn, &BoreMilling::infeed_per_turn, Must::be_above_0},
                                  {Role::diameter, &BoreMilling::diameter, Must::be_above_0},
                                  {Role::predrilled_diameter, &BoreMilling::predrilled_diameter, Must::be_at_least_0},
                                  {Role::direction, &BoreMilling::direction},
                              }));

}  // namespace obrys::cycles
