/// G codes and their named relatives: what they change in the modal state.

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/codes.hpp"
#include "base/text.hpp"
#include "base/whole.hpp"
#include "interp/path_stage.hpp"
#include "interp/run.hpp"

namespace obrys::interp {

using cl::SettingKind;

void set_plane(Moving& run, int plane) {
    tell(run, SettingKind::plane, plane);
    if (run.modal.plane == plane) return;
    run.block.changes_plane = true;
    flush_path(run);
    run.modal.plane = plane;
    forget_polar_angle(run.modal);
}

namespace {

void set_feed_mode(Reckoning& run, cl::FeedMode mode) {
    if (run.traits->needs_feed) run.feed_valid = false;  // also where the mode stays
    if (run.modal.feed_mode == mode) return;
    run.modal.feed_mode = mode;
    run.feed_dropped = true;
    run.feed_valid = false;  // an F of the old kind means nothing in the new one
}

/// G97 without S keeps the speed that G96 had reached at this X (Siemens, NC programming 12/2019, p. 99).
void keep_reached_speed(Reckoning& run) {
    SpindleState& s = run.spindle;
    s.surface = s.speed;
    const double x = std::abs(run.programmed_position.x);
    s.speed = s.surface * 1000 / (2 * geom::pi * x);
    if (s.limit > 0) s.speed = std::min(s.speed, s.limit);
    if (!std::isfinite(s.speed)) s.speed = s.limit > 0 && x == 0 ? s.limit : std::numeric_limits<double>::quiet_NaN();
}

/// G96 G961 G962 and G97 G971 G972 G973: `number` says which; the last digit pair decides the kind of feed.
void set_surface_speed(Moving& run, bool on, int number) {
    if (on != run.modal.surface_speed) {
        if (on)
            run.spindle.speed = run.spindle.surface;  // whether one was said before: the reader of S asks
        else
            keep_reached_speed(run);
        run.spindle.mode_changed = true;
    }
    run.modal.surface_speed = on;
    run.modal.speed_word = number;
    run.block.surface_word = on ? 96 : 97;
    if (!run.traits->feed_mode_ends_surface_speed) return;
    if (number == 96 || number == 97 || number == 973) set_feed_mode(run, cl::FeedMode::per_rev);
    if (number == 961 || number == 971) set_feed_mode(run, cl::FeedMode::per_minute);
}

/// G94 and G95 stand in one group with G96: they end it (SINUMERIK Programming Manual Fundamentals, G96). Easily
/// missed.
void plain_feed(Moving& run, cl::FeedMode mode) {
    if (!run.traits->feed_mode_ends_surface_speed) return set_feed_mode(run, mode);
    if (run.modal.surface_speed)
        assume(
            run, run.here(),
            "G94 and G95 end the constant cutting speed of G96 (same G group): the spindle keeps the speed it has here",
            "write G96 behind them if the cutting speed is to stay constant");
    set_surface_speed(run, false, 0);
    set_feed_mode(run, mode);
}

void change_plane(Moving& run, int plane) {
    if (plane != run.modal.plane) leave_compensation(run, "the working plane changes");
    run.modal.plane_said = true;
    if (!run.stopped) set_plane(run, plane);
}

/// G53 whose coordinates are ways (G91), where the control takes no notice of it.
void say_ignored_machine_position(Reckoning& run, const program::Word& w) {
    unchecked(run, base::codes::assumption, run.unit().span(*run.statement, w),
              "G53 with incremental coordinates is ignored by the control: the block moves from where the tool is",
              "write G90 before it, or absolute coordinates");
}

/// The block moves so, whatever is in force, and what is in force stays.
void move_once(Moving& run, Modal m) {
    if (!run.block.motion_behind) run.block.motion_behind = run.modal.motion;
    run.modal.motion = m;
}

/// `straight`: a straight block is a rapid then; else the block is an arc, or says so itself.
void rapid_block(Moving& run, bool straight) {
    if (straight && run.modal.motion == Modal::linear) return move_once(run, Modal::rapid);
    run.block.rapid = true;
}

/// `number` is 0 (Klartext: the block says all of it), or made of program::paraxial_… (DIN/ISO G07).
void paraxial_block(Moving& run, int number) {
    run.block.paraxial = Modal::paraxial;
    if (number == 0) return;
    move_once(run, (number & program::paraxial_rapid) != 0 ? Modal::rapid : Modal::linear);
    if ((number & program::paraxial_alone) == 0) run.block.paraxial = run.modal.paraxial;
}

/// Motion, plane and what acts in this block only. False where `m` is none of them.
bool motion_word(Moving& run, Modal m, const program::Word& w) {
    const bool of_path = m <= Modal::tap_retract || m == Modal::arc_same_sense;
    if (of_path && program::modal_number(w) == program::polar_path) run.block.polar_path = true;
    if (m <= Modal::tap_retract) {
        run.modal.motion = m;
        run.modal.rapid_by_cancel = false;
        run.modal.cartesian_path = program::modal_number(w) == program::cartesian_path;
        run.block.says_straight = run.block.says_straight || m <= Modal::linear;
        run.canned.active = false;
        if (m == Modal::arc_cw || m == Modal::arc_ccw) run.modal.last_sense = m;
        return true;
    }
    switch (m) {
        case Modal::dwell:
        case Modal::reference_point:
        case Modal::fixed_point:
        case Modal::pole_from_position:
        case Modal::pole_from_zero:
        case Modal::pole_from_pole:
        case Modal::pole_given:
        case Modal::cycle_position:
        case Modal::cycle_pattern: run.block.special = m; return true;
        case Modal::rapid_block: rapid_block(run, program::modal_number(w) == program::whole_block); return true;
        case Modal::paraxial: paraxial_block(run, program::modal_number(w)); return true;
        case Modal::paraxial_longer:
        case Modal::paraxial_shorter: compensate_along_axis(run, m); return true;
        case Modal::tool_along: aim_tool(run); return true;
        case Modal::program_stop: run.block.stops_run = true; return true;
        case Modal::corner_crossing:
        case Modal::corner_open: run.block.corner_end = m; return true;
        case Modal::look_ahead: run.modal.look_ahead = program::modal_number(w); return true;
        case Modal::retract_tool: run.block.retract = 1 + program::modal_number(w); return true;
        case Modal::arc_same_sense: run.modal.motion = run.modal.last_sense; return true;
        case Modal::suppress_all:
            if (program::modal_number(w) == program::position_ignored)
                return say_ignored_machine_position(run, w), true;
            [[fallthrough]];
        case Modal::suppress_frames: run.block.suppress = m; return true;
        case Modal::plane_xy: change_plane(run, 17); return true;
        case Modal::plane_zx: change_plane(run, 18); return true;
        case Modal::plane_yz: change_plane(run, 19); return true;
        default: return false;
    }
}

/// L of G41.1 and G42.1; without it the nose has no tip of its own.
bool take_orientation(Moving& run) {
    const BlockWords& b = run.block;
    const double l = b.has(Code::l) ? b.get(Code::l) : 0;
    const auto orientation = base::whole<int>(l, 0, 9);
    if (orientation) run.modal.compensation_orientation = *orientation;
    std::string fault;
    if (b.has(Code::l) && run.modal.plane != 18)
        fault = "L (orientation of a lathe tool) beside radius compensation is for the plane of G18";
    else if (!orientation)
        fault = "L, the orientation of the tool, must be a whole number from 0 to 9";
    if (fault.empty()) return true;
    alarm(run, base::codes::value_range, run.here(), std::move(fault));
    return false;
}

void set_compensation(Moving& run, Modal m) {
    ModalState& state = run.modal;
    state.paraxial = Modal::paraxial;
    refuse_other_side(run, m);
    if (run.stopped) return;
    if (m == Modal::compensation_off) state.look_ahead = 0;
    note_compensation(run, m);
    const BlockWords& b = run.block;
    const double unit = length_unit(state);
    const bool given = m == Modal::compensation_left_by || m == Modal::compensation_right_by;
    state.compensation = m == Modal::compensation_left_by    ? Modal::compensation_left
                         : m == Modal::compensation_right_by ? Modal::compensation_right
                                                             : m;
    state.compensation_radius = std::numeric_limits<double>::quiet_NaN();
    state.compensation_orientation = -1;
    if (m == Modal::compensation_off && run.traits->compensation_holds_move) run.path->switch_off(run);
    if (m == Modal::compensation_off) switch_compensation_off(run);
    if (given && !take_orientation(run)) return;
    if (given && b.has(Code::offset_d)) state.compensation_radius = b.get(Code::offset_d) * unit / 2;
    if (!given && m != Modal::compensation_off) take_radius_number(run);
    const bool left = (state.compensation == Modal::compensation_left) != (state.compensation_radius < 0);
    tell(run, SettingKind::compensation, state.compensation == Modal::compensation_off ? 0 : left ? 1 : 2);
}

/// G187 of Haas: so much is a corner rounded at most; without E by the machine's setting 85.
void set_corner_rounding(Moving& run) {
    const BlockWords& b = run.block;
    const double e = b.has(Code::p) ? std::abs(b.get(Code::p)) * length_unit(run.modal) : HUGE_VAL;
    run.modal.tolerance_by = b.has(Code::p) ? "the accuracy control with E" : "the accuracy control without E";
    run.modal.tolerance_cycle = std::isnan(e) ? HUGE_VAL : e;
}

void set_path_mode(Moving& run, Modal m, int number) {
    if (m == Modal::path_blend && number == 187) return set_corner_rounding(run);
    ModalState& state = run.modal;
    const BlockWords& b = run.block;
    const double unit = length_unit(state);
    state.path_mode = m;
    state.blend = m == Modal::path_blend && b.has(Code::p) ? b.get(Code::p) * unit : 0;
    state.merge = m == Modal::path_blend && b.has(Code::q) ? b.get(Code::q) * unit : state.blend;
    state.blend_free = m == Modal::path_blend && !b.has(Code::p) && run.traits->blends_without_limit;
    tell_path_mode(run);
    tell_joining(run, false);
}

bool names_axis(const Moving& run) {
    for (std::size_t k = 0; k < 9; ++k)
        if (run.block.has(axis_code(static_cast<int>(k)))) return true;
    return false;
}

/// Offsets and stored positions: they take the axis words of the block. False where `m` is none of them.
bool offset_word(Moving& run, Modal m, int number) {
    BlockWords& b = run.block;
    switch (m) {
        case Modal::tool_length_added:
            if (!b.has(Code::offset_h) && names_axis(run)) b.special = Modal::tool_length_by_axes;
            tool_length_words(run, m);
            return true;
        case Modal::tool_length_by_axes: b.special = m; [[fallthrough]];
        case Modal::tool_length:
        case Modal::tool_length_negative:
        case Modal::tool_length_off: tool_length_words(run, m); return true;
        case Modal::set_data:
            b.special = m;
            set_data(run, static_cast<program::DataTable>(number));
            return true;
        case Modal::position_becomes:
        case Modal::local_shift: b.special = m; [[fallthrough]];
        case Modal::position_reset:
        case Modal::position_suspend:
        case Modal::position_restore: shift_words(run, m); return true;
        case Modal::scaling_on:
        case Modal::scaling_off:
        case Modal::mirror_on:
        case Modal::mirror_off:
        case Modal::rotation_on:
        case Modal::rotation_off:
            b.special = m;
            transform_about_centre(run, m);
            return true;
        case Modal::home:
            b.special = m;
            b.special_number = number;
            return true;
        case Modal::home_store:
            b.special_number = number;
            store_home(run);
            return true;
        default: return false;
    }
}

/// Motion words whose number matters, and what goes with canned cycles. False where `m` is none of them.
bool numbered_motion_word(Moving& run, Modal m, int number) {
    ModalState& state = run.modal;
    switch (m) {
        case Modal::canned:
        case Modal::probe:
            if (state.motion != Modal::canned) state.before_cycle = state.motion;
            state.motion = m;
            state.motion_number = number;
            if (m == Modal::probe) run.canned.active = false;
            return true;
        case Modal::canned_off:
            run.canned.active = false;
            state.rapid_by_cancel = state.motion == Modal::canned && state.before_cycle != Modal::rapid;
            state.motion = run.traits->cancel_leaves_no_motion ? Modal::canned_off : Modal::rapid;
            tell(run, SettingKind::motion_off);
            return true;
        case Modal::retract_initial:
        case Modal::retract_clearance:
            state.clear_to_retract_plane = m == Modal::retract_clearance;
            tell(run, SettingKind::retract_clearance, state.clear_to_retract_plane);
            return true;
        case Modal::nurbs:
            if (state.motion != m || state.motion_number != number) run.curve.open = false;
            state.motion = m;
            state.motion_number = number;
            return true;
        case Modal::spline_cubic:
        case Modal::spline_quadratic:
        case Modal::nurbs_end:
        case Modal::rigid_tap:
        case Modal::circle_pocket:
        case Modal::turning_cycle:
            run.block.special = m;
            run.block.special_number = number;
            return true;
        default: return false;
    }
}

/// Tells a mode that has changed.
void tell_changed(Telling& run, SettingKind kind, bool before, bool now) {
    if (before != now) tell(run, kind, now);
}

/// Sources: FANUC B-63944EN/02 page 192: at the beginning of the program, not to be switched during it; Haas: must be
/// what Setting 9 says (96-8000, G20/G21).
/// HEIDENHAIN: the head says the unit of the whole program. `inside`: a G70 or G71 elsewhere.
void say_changed_unit(Telling& run, bool changes, bool inside) {
    const bool in_use = run.moved && (run.modal.unit_said || run.feed_valid);  // G28 before the first G21 is usual
    run.modal.unit_said = true;
    if (!changes || !in_use || (!inside && !run.traits->unit_before_motion)) return;
    unchecked(run, base::codes::unsupported, run.here(),
              "the unit of length changes behind moves, which this control does not allow: what its offsets then mean "
              "is not known",
              "say the unit at the beginning of the program, before it moves");
}

/// Units, absolute and incremental, diameters. False where `m` is none of them.
bool dimension_word(Telling& run, Modal m, int number) {
    ModalState& state = run.modal;
    switch (m) {
        case Modal::arc_centre_absolute:
        case Modal::arc_centre_incremental:
            tell_changed(run, SettingKind::centre_incremental, !state.centre_absolute,
                         m == Modal::arc_centre_incremental);
            state.centre_absolute = m == Modal::arc_centre_absolute;
            return true;
        case Modal::inch_geometry: state.inch_geometry = true; return true;
        case Modal::metric_geometry: state.inch_geometry = state.metric_feed = false; return true;
        case Modal::inch_all:
            say_changed_unit(run, !state.inch_geometry, number == program::unit_inside);
            state.inch_geometry = state.inch_feed = true;
            tell(run, SettingKind::unit, 1);
            return true;
        case Modal::metric_all:
            say_changed_unit(run, state.inch_geometry, number == program::unit_inside);
            state.inch_geometry = state.inch_feed = false;
            state.metric_feed = true;
            tell(run, SettingKind::unit, 0);
            return true;
        case Modal::absolute:
        case Modal::incremental:
            tell_changed(run, SettingKind::incremental, !state.absolute, m == Modal::incremental);
            state.absolute = m == Modal::absolute;
            return true;
        case Modal::diameter_on:
        case Modal::diameter_off:
            tell_changed(run, SettingKind::diameter, state.diameter == DiameterMode::on, m == Modal::diameter_on);
            state.diameter = m == Modal::diameter_on ? DiameterMode::on : DiameterMode::off;
            return true;
        case Modal::diameter_absolute_only: state.diameter = DiameterMode::absolute_only; return true;
        default: return false;
    }
}

}  // namespace

namespace {

/// A zero offset that is kept in parameters.
void select_kept_datum(Telling& run, std::uint32_t number) {
    const int place = static_cast<int>(place_of_datum(number));
    if (run.modal.datum == number) return tell(run, SettingKind::datum_kept, place);
    flush_path(run);
    run.modal.datum = number;
    run.offsets.length_judged = false;
    load_datum(run);
    take_tip(run);
    tell(run, SettingKind::datum, place, run.offsets.datum);
    tell(run, SettingKind::shift, 0, run.offsets.shift);
    tell(run, SettingKind::datum_rotation, 0, {run.offsets.rotation});
    update_frame(run);
}

}  // namespace

void set_datum(Telling& run, std::uint32_t number) {
    if (run.modal.datum != number) run.datum_complained = false;
    if (keeps_offsets(run)) return select_kept_datum(run, number);
    if (run.modal.datum == number) return;
    flush_path(run);
    run.modal.datum = number;
    if (!run.moved && run.reference_datum == 500) run.reference_datum = number;
    update_frame(run);
}

bool apply_mode(Calling& run, Modal m, int number) {
    ModalState& state = run.modal;
    if (dimension_word(run, m, number)) return true;
    if (m >= Modal::canned && (offset_word(run, m, number) || numbered_motion_word(run, m, number))) return true;
    switch (m) {
        case Modal::compensation_off:
        case Modal::compensation_left:
        case Modal::compensation_right:
        case Modal::compensation_left_by:
        case Modal::compensation_right_by: set_compensation(run, m); return true;
        case Modal::compensation_in_plane:
        case Modal::compensation_in_frame: state.compensation_in_frame = m == Modal::compensation_in_frame; return true;
        case Modal::compressor_on:
        case Modal::compressor_off: state.compressor = m == Modal::compressor_on; return true;
        case Modal::exact_stop:
        case Modal::continuous:
            state.smoothing = m == Modal::continuous ? number : 0;
            tell_joining(run, true);
            return true;
        case Modal::path_exact:
        case Modal::path_stop:
        case Modal::path_blend: set_path_mode(run, m, number); return true;
        case Modal::save_modal:
        case Modal::save_modal_for_call: save_modes(run, m == Modal::save_modal_for_call); return true;
        case Modal::forget_saved_modal: forget_modes(run); return true;
        case Modal::restore_modal: restore_modes(run); return true;
        case Modal::polar_face:
        case Modal::cylinder_face:
        case Modal::interpolation_off: set_surface(run, m); return true;
        case Modal::datum: set_datum(run, static_cast<std::uint32_t>(number)); return true;
        case Modal::feed_inverse_time:
            tell(run, SettingKind::feed_mode, 93);
            set_feed_mode(run, cl::FeedMode::inverse_time);
            return true;
        case Modal::feed_per_minute:
            tell(run, SettingKind::feed_mode, 94);
            plain_feed(run, cl::FeedMode::per_minute);
            return true;
        case Modal::feed_per_rev:
            tell(run, SettingKind::feed_mode, 95);
            plain_feed(run, cl::FeedMode::per_rev);
            return true;
        case Modal::surface_speed_on: set_surface_speed(run, true, number); return true;
        case Modal::surface_speed_off: set_surface_speed(run, false, number); return true;
        case Modal::approach_normal:
        case Modal::approach_contour: state.approach = m; return true;
        case Modal::corner_arc:
        case Modal::corner_intersection: state.corner = m; return true;
        case Modal::feed_at_contour:
        case Modal::feed_at_tool:
        case Modal::feed_at_inside:
            state.feed_reference = m;
            shape_feed_from_here(run);
            return true;
        case Modal::plunge_feed:
            state.plunge_part = number == 0 ? 1 : number * 1e-4;
            shape_feed_from_here(run);
            return true;
        default: return false;  // exact stop and continuous path of other controls: no effect on the path itself
    }
}

void settle_motion(Moving& run) {
    if (run.block.motion_behind) run.modal.motion = *run.block.motion_behind;
    run.block.motion_behind.reset();
}

void hold_plane(Reckoning& run) {
    if (run.traits->compensation_holds_plane.empty() || run.modal.compensation == Modal::compensation_off) return;
    alarm(run, base::codes::compensation, run.here(),
          "the plane changes while radius compensation is on" + of_alarm(run.traits->compensation_holds_plane),
          "write G40 before it");
}

void modal_word(Calling& run, const program::Word& w) {
    const Modal m = program::modal_of(w);
    refuse_modal(run, w);
    repeated_group(run, w);
    run.modal.groups_said |= std::uint32_t{1} << static_cast<unsigned>(program::group_of(m));
    if (run.stopped || motion_word(run, m, w)) return;
    if (apply_mode(run, m, program::modal_number(w)) || m < Modal::canned) return;
    // no reader may make a word that is not run here
    const base::Span where = run.unit().span(*run.statement, w);
    unchecked(run, base::codes::unsupported, where,
              std::string(base::trim(run.env.sources.text(where))) +
                  " is not run: what it changes on the control is not known here",
              "take it out, or say what it does by words that are run (docs/dialects)");
}

}  // namespace obrys::interp
