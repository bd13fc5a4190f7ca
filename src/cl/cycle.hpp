#pragma once
/// Machining cycles by meaning: what a cycle does and what each of its parameters says, whatever control spells it.
/// A reader turns numbers and Q parameters into these, cycles/cycle.hpp expands them, CycleBegin tells them.

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>

namespace obrys::cl {

enum class CycleKind : std::uint8_t {
    // Holes.
    peck,             ///< full retract after every infeed, advanced stop from the control's own rule (old form)
    drill,            ///< infeeds with retract to the clearance
    ream,             ///< one feed motion down, feed motion up
    bore,             ///< as ream, oriented spindle stop, sideways disengagement
    universal_drill,  ///< infeeds with decrement, chip break or retract
    back_bore,        ///< counterbore from below
    universal_peck,   ///< infeeds with decrement, chip break, advanced stop distances, deepened start
    bore_mill,        ///< helix
    centre,           ///< to a depth or a diameter
    single_lip,       ///< single-lip deep hole
    // Threads.
    tap_floating_simple,  ///< old form: depth, dwell, feed
    tap_floating,
    tap_rigid_simple,  ///< old form: depth, pitch
    tap_rigid,
    tap_chip_breaking,
    thread_cut,  ///< one synchronised pass from where the tool stands
    thread_mill,
    thread_mill_countersink,
    thread_mill_drill,
    thread_mill_helix,
    thread_mill_outside,
    // Canned cycles of one hole (RS-274, Fanuc, Haas).
    canned_drill,         ///< feed down, rapid out; with a dwell also counterboring
    canned_chip_break,    ///< infeeds, after each a little back
    canned_peck,          ///< infeeds, after each out to the retract plane
    canned_deep,          ///< infeeds that fall by an amount or a factor, with dwells; a little back or out after each
    canned_tap_floating,  ///< feed in, spindle reversed, feed out
    canned_tap_rigid,     ///< axis and spindle coupled
    canned_bore_feed,     ///< feed down, feed out
    canned_bore_stop,     ///< feed down, spindle stop, rapid out
    canned_bore_orient,   ///< feed down, oriented stop, sideways, rapid out
    canned_back_bore,     ///< through the hole beside its axis, counterbore from below
    canned_bore_manual,   ///< feed down, spindle stop, the operator retracts
    // Milling by one block (Haas G12, G13).
    canned_circular_pocket,  ///< out of the middle, circle by circle, back to it; level by level
    // Turning (cycles/turn/turning.hpp).
    lathe_finish_offset,      ///< along a contour in passes at falling distance
    lathe_rough_along,        ///< cuts parallel to the axis down to a contour at a distance
    lathe_rough_across,       ///< as above, cuts at right angles to the axis
    lathe_thread_degressive,  ///< thread in passes whose depth falls by a power
    lathe_finish,             ///< along a contour once
    lathe_remove_along,       ///< stock removal parallel to the axis, contour with allowances
    lathe_remove_across,      ///< as above, at right angles to the axis
    lathe_repeat_pattern,     ///< a contour several times, each time nearer
    lathe_peck_along,         ///< pecks along the axis, step by step across
    lathe_peck_across,        ///< pecks across the axis (grooving), step by step along
    lathe_thread_passes,      ///< thread in passes of equal area, with finishing passes
    lathe_box_along,          ///< one cut along the axis: in, cut, out, back
    lathe_box_thread,         ///< as above, the cut is a thread
    lathe_box_across,         ///< one cut across the axis
    // Pockets, slots, studs.
    slot_simple,
    rectangular_pocket_simple,
    circular_pocket_simple,
    slot_reciprocating,
    round_slot_reciprocating,
    rectangular_pocket_finish,
    rectangular_stud_finish,
    circular_pocket_finish,
    circular_stud_finish,
    rectangular_pocket,
    circular_pocket,
    slot,
    round_slot,
    rectangular_stud,
    circular_stud,
    // Patterns.
    pattern_circle,
    pattern_lines,
    // Contours.
    contour_definition,  ///< the labels or programs that hold the contours
    contour_data,
    pilot_drill,
    rough_out,
    floor_finish,
    side_finish,
    contour_train,
    contour_train_data,
    pilot_drill_simple,  ///< old forms: with their own depths
    rough_out_simple,
    contour_mill_simple,
    cylinder_surface,
    cylinder_slot,
    cylinder_ridge,
    cylinder_contour,
    // Surfaces.
    multipass,
    ruled_surface,
    face_mill,
    point_data,  ///< digitised points from a file
    // Coordinates and the rest.
    datum_shift,
    mirror,
    rotation,
    scaling,
    axis_scaling,
    working_plane,
    preset,
    dwell,
    program_call,
    orientation,
    tolerance,
    global_values,  ///< of parameters that later cycles refer to (GLOBAL DEF)
    probe,
};

/// Meaning of a parameter. Lengths in mm, angles in degrees as written, feeds in mm/min, times in seconds.
/// u and v are the axes of the working plane, w is the tool axis, upwards positive.
enum class CycleRole : std::uint8_t {
    // Heights.
    surface,           ///< w of the workpiece surface
    clearance,         ///< above the surface; positive
    second_clearance,  ///< above the surface; no collision with clamps
    clearance_height,  ///< absolute w (contour cycles)
    depth,             ///< from the surface, downwards negative
    end_surface,       ///< absolute w to which a face is milled
    infeed,            ///< per step; positive
    min_infeed,
    decrement,  ///< the infeed becomes smaller by this with every step
    chip_break_distance,
    chip_break_depth,
    breaks_before_retract,
    stop_distance_first,
    stop_distance_last,
    deepened_start,  ///< below the surface; positive
    allowance_side,
    allowance_floor,
    allowance_left,  ///< of the side, left by this cycle
    allowance_u,
    finish_infeed,
    hole_depth,  ///< of the whole hole, downwards negative
    countersink_depth,
    front_depth,
    front_offset,
    countersink_order,
    dwell_depth,
    counterbore_depth,  ///< from the underside, upwards positive
    thickness,
    off_centre,
    edge_height,
    depth_reference,
    // Feeds, times, speeds.
    feed_plunge,
    feed_mill,
    feed_position,
    feed_retract,
    feed_countersink,
    feed_finish,
    feed_step,
    feed_reciprocate,
    feed_approach,
    feed_factor,
    feed_reference,
    dwell_top,
    dwell_bottom,
    dwell,
    spindle_direction,
    spindle_speed_position,
    spindle_speed,
    rpm_factor,
    coolant_on,
    coolant_off,
    // Sizes.
    pitch,
    diameter,
    radius,
    first_radius,  ///< of the first of several circles
    predrilled_diameter,
    blank_diameter,
    centre_by_diameter,
    infeed_per_turn,
    threads_per_step,
    length,
    width,
    blank_length,
    blank_width,
    corner_radius,
    rounding_radius,
    cylinder_radius,
    slot_width,
    side_clearance,
    tolerance,
    tolerance_angle,
    tolerance_mode,
    // Places in the plane.
    centre_u,
    centre_v,
    start_u,
    start_v,
    start_w,
    second_u,
    second_v,
    second_w,
    third_u,
    third_v,
    third_w,
    fourth_u,
    fourth_v,
    fourth_w,
    end_u,
    end_v,
    pitch_circle,
    start_angle,
    end_angle,
    angle_step,
    angle_length,
    rotation,
    spacing_u,
    spacing_v,
    columns,
    rows,
    count,
    passes,
    position,
    approach_position,
    // Ways of doing it.
    direction,          ///< +1 climb, -1 up-cut; old forms: DR+ 1, DR- -1
    retract_direction,  ///< 0 none, 1 u-, 2 v-, 3 u+, 4 v+
    spindle_angle,
    operation,  ///< 0 roughing and finishing, 1 roughing, 2 finishing
    overlap,
    plunge,
    strategy,
    move_at_clearance,
    traverse,
    approach,
    compensation,
    approach_radius,
    approach_angle,
    auxiliary_distance,
    coarse_tool,
    pilot_tool,
    dimension_kind,
    plunge_angle,
    // Transformations.
    axis_x,
    axis_y,
    axis_z,
    axis_a,
    axis_b,
    axis_c,
    axis_u,
    axis_v,
    axis_w,
    centre_x,
    centre_y,
    centre_z,
    datum_number,
    preset_number,
    angle,
    factor,
    contour_label,
    program_name,
    setup_distance,
    probe_input,  ///< of a probing cycle: not looked at
    // Canned cycles; w as everywhere: absolute in the working plane's coordinates.
    target_u,  ///< the hole, in a demand; the stream's brackets tell it by their place, as rise_first by the moves
               ///< before
    target_v,
    retract_plane,  ///< w to which the tool goes at rapid (R)
    bottom,         ///< w of the hole's end (Z)
    return_level,   ///< w where the cycle ends; below the retract plane: the retract plane
    rise_first,     ///< 1: a tool below the retract plane rises to it before it moves in the plane; 2: as it moves
    shift_u,        ///< from the axis of the hole, where an oriented tool goes in and out
    shift_v,
    counterbore_top,  ///< w where boring from below ends
    feed_out,         ///< 1: feed over the whole way out; 0: to the retract plane, from there rapid
    length_unit,      ///< mm per unit in which the control adds up infeeds as binary numbers; none: it adds exactly
    retract_every,    ///< depth after which chip breaking goes out to the retract plane
    starts_spindle,   ///< 1: the cycle turns the spindle on by itself; 2: that it does is assumed
    manual_retract,   ///< 1: the path holds the operator's move out
    // Turning: u along the axis (Z), v the radius (X); all lengths in X are radii.
    escape,    ///< how far the tool goes away after a cut or a peck
    pockets,   ///< 0 all, 1 leaves them, 2 only them; stock removal: 1 allows them
    offset_u,  ///< shift of the whole contour
    offset_v,
    allowance_first,  ///< distance to the contour of the first pass
    allowance_last,
    allowance_v,
    relief_u,  ///< shift of the first pass against the last
    relief_v,
    stepover,      ///< from peck to peck
    relief,        ///< sideways at the bottom of a groove
    crest_offset,  ///< from where the tool stands to the crest of the thread; negative: outside thread
    first_depth,   ///< of a thread's first pass
    thread_depth,
    degression,        ///< depth of pass n: first depth times n to the power 1 / degression
    infeed_angle,      ///< degrees between the infeed and the radius
    spring_passes,     ///< at full depth after the first that reaches it
    finish_passes,     ///< of a thread, at least 1
    finish_allowance,  ///< of a thread, left for the finishing passes
    taper_length,      ///< along the axis, of a thread's entry and exit
    taper_ends,        ///< 0 none, 1 entry, 2 exit, 3 both
    taper_u,           ///< start of the cut less its end
    taper_v,
    runout,            ///< along the axis, where a thread leaves the material at 45 degrees
    runout_leads,      ///< as above, in leads of the thread
    infeed_method,     ///< of a thread: 1 equal areas on one flank, 2 on both; 3 equal depths on one flank, 4 on both
    first_infeed,      ///< of canned pecking whose first two infeeds are larger than the others
    second_infeed,     ///< as above; not written: the first holds once
    peck_to_surface,   ///< 1: pecking goes out to the surface, not to the retract plane
    chip_break_turns,  ///< of a rigid tap: back by so many pitches after each infeed
    kept,              ///< not looked at by this cycle, held for the next of its series: no part of what it says
    infeed_factor,     ///< each infeed is the one before times this; below 1
    spindle_after,     ///< how the spindle turns behind the cycle: +1, -1, 0 it stands
    stops_program,     ///< 1: the program stops at the bottom of the hole, as at M0
    shift_w,           ///< beside shift_u and shift_v, along the tool's axis
    turned_axes,       ///< fault of a control, tapping: 1 feeds to (v, w, u) of the place it means, 2 to (w, u, v)
};

/// Words of the stream's text form: "universal-drill", "chip-break-distance".
[[nodiscard]] std::string_view spelling(CycleKind kind);
[[nodiscard]] std::string_view spelling(CycleRole role);
[[nodiscard]] std::optional<CycleKind> cycle_kind_spelt(std::string_view word);
[[nodiscard]] std::optional<CycleRole> cycle_role_spelt(std::string_view word);

struct CycleValue {
    CycleRole role = CycleRole::depth;
    double value = 0;  ///< NaN: written, but not known
    bool operator==(const CycleValue&) const = default;
};

}  // namespace obrys::cl
