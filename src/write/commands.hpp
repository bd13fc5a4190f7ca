#pragma once
/// What posts have templates for.

#include <cstdint>
#include <span>
#include <string_view>

namespace obrys::write {

/// What a template is for.
enum class Command : std::uint8_t {
    file_begin,
    file_end,
    rapid,
    linear,
    arc_cw,
    arc_ccw,
    arc_in_space,  ///< by its end and a point that it passes
    helix_cw,      ///< where it is written otherwise than an arc in the plane
    helix_ccw,
    thread,
    thread_rising,  ///< whose pitch grows with every revolution
    thread_falling,
    tap,
    tap_back,      ///< its way out of the hole, where that is a word of its own
    seek_contact,  ///< by a probe: to where it touches
    seek_contact_or_end,
    seek_release,
    seek_release_or_end,
    spline,
    spline_xy,
    spline_zx,
    spline_yz,
    plane_xy,
    plane_zx,
    plane_yz,
    feed_per_minute,
    feed_per_rev,
    feed_inverse_time,
    feed_mode_per_minute,  ///< in a block of its own before the first move that has it
    feed_mode_per_rev,
    feed_rapid,               ///< of arcs
    feed_surface_per_minute,  ///< while the cutting speed is constant, where that is said in one word with the feed
    feed_surface_per_rev,
    spindle_cw,
    spindle_ccw,
    spindle_stop,
    leave_surface,  ///< before a speed that is no cutting speed
    surface_cw,     ///< constant cutting speed
    surface_ccw,
    surface_stop,
    spindle_held,
    spindle_other,  ///< what another spindle is told
    tool_change,
    tool_next,      ///< the tool that will be wanted
    tool_data,      ///< what the program itself says a tool is
    tool_edge,      ///< another edge of the tool in the spindle
    tool_standing,  ///< a tool that is in the spindle already
    tool_none,
    tool_by_name,
    length_on,
    length_subtracted,
    length_by,  ///< by values
    length_off,
    machine_coordinates,
    machine_linear,      ///< the same at feed
    machine_tip,         ///< the tool's tip goes there
    machine_linear_tip,  ///< the same at feed
    machine_home,
    machine_retract,  ///< Z alone, where other reference points have no words
    machine_second,   ///< the second reference point
    machine_fixed,
    coolant_off,
    coolant_flood,
    coolant_mist,
    coolant_both,
    dwell_seconds,
    dwell_revolutions,
    stop_program,
    stop_optional,
    stop_pallets,  ///< with which pallets are exchanged
    stop_end,
    stop_end_pallets,
    stop_end_stays,  ///< behind which the program may stay where it is
    stop_again,      ///< the program begins anew, without end
    comment,
    message,
    terminal,
    path_exact,
    path_exact_stop,
    path_free,
    path_within,
    tolerance_set,
    tolerance_reset,
    function,
    function_extended,  ///< whose address has a number of its own (H2=5)
    output_on,
    output_off,
    output_value,
    output_on_moving,  ///< with the next move
    output_off_moving,
    output_value_moving,
    override_feed,  ///< what the operator may change
    override_feed_off,
    override_spindle,
    override_spindle_off,
    override_adaptive,
    override_adaptive_off,
    override_hold,
    override_hold_off,
    axis,           ///< named by a letter
    axis_numbered,  ///< "C2"
    compensation_left,
    compensation_right,
    compensation_left_by,  ///< the radius that the program says
    compensation_right_by,
    compensation_off,
    compensation_off_alone,  ///< where no move follows to end it with
    corner_chamfer,
    corner_chamfer_leg,
    corner_rounding,
    onto_tangent_line,  ///< ways onto a contour and off it that the control makes
    onto_normal_line,
    onto_tangent_arc,
    onto_arc_and_line,
    off_tangent_line,
    off_normal_line,
    off_tangent_arc,
    off_arc_and_line,
    cycle_begin,
    cycle_end,
    cycle_again,  ///< at a further place, where nothing else differs
    shift,
    shift_off,
    rotation,
    rotation_off,
    mirror,
    mirror_off,
    scaling,
    scaling_off,
    plane,
    plane_off,
    plane_turn,  ///< the rotary axes turn in the same block, the linear ones stand
    plane_turn_off,
    plane_move,  ///< the same, a place before the tip, or it, staying where it is on the workpiece
    plane_move_off,
    programmed,
    programmed_off,
    count,
};
/// "motion.arc-cw": table and key in the file.
[[nodiscard]] std::string_view name_of(Command c);

struct CommandName {
    Command command;
    std::string_view table, key, name;
};
/// In the order of the commands; those of one table stand together.
[[nodiscard]] std::span<const CommandName> command_names();

}  // namespace obrys::write
