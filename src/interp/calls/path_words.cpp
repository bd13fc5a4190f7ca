/// Words that choose the motion, its compensation, corners and path mode.

#include <cmath>
#include <limits>

#include "base/codes.hpp"
#include "base/whole.hpp"
#include "interp/calls/calls.hpp"
#include "interp/stream/path_stage.hpp"

namespace obrys::interp {

namespace {

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

}  // namespace

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

namespace {

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

}  // namespace

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
    state.compensation_given = given && b.has(Code::offset_d);
    state.compensation_orientation = -1;
    if (m == Modal::compensation_off && run.traits->compensation_holds_move) run.path->switch_off(run);
    if (m == Modal::compensation_off) switch_compensation_off(run);
    if (given && !take_orientation(run)) return;
    if (given && b.has(Code::offset_d)) state.compensation_radius = b.get(Code::offset_d) * unit / 2;
    if (!given && m != Modal::compensation_off) take_radius_number(run);
    const bool left = (state.compensation == Modal::compensation_left) != (state.compensation_radius < 0);
    hear(run, heard::Compensation{state.compensation == Modal::compensation_off ? heard::Side::off
                                  : left                                        ? heard::Side::left
                                                                                : heard::Side::right});
}

namespace {

/// G187 of Haas: so much is a corner rounded at most; without E by the machine's setting 85.
void set_corner_rounding(Moving& run) {
    const BlockWords& b = run.block;
    const double e = b.has(Code::p) ? std::abs(b.get(Code::p)) * length_unit(run.modal) : HUGE_VAL;
    run.modal.tolerance_by = b.has(Code::p) ? "the accuracy control with E" : "the accuracy control without E";
    run.modal.tolerance_cycle = std::isnan(e) ? HUGE_VAL : e;
}

}  // namespace

void set_path_mode(Moving& run, Modal m, int number) {
    if (m == Modal::path_blend && number == 187) return set_corner_rounding(run);
    ModalState& state = run.modal;
    const BlockWords& b = run.block;
    const double unit = length_unit(state);
    state.path_mode = m;
    state.blend = m == Modal::path_blend && b.has(Code::p) ? b.get(Code::p) * unit : 0;
    state.merge = m == Modal::path_blend && b.has(Code::q) ? b.get(Code::q) * unit : state.blend;
    state.blend_free = m == Modal::path_blend && !b.has(Code::p) && run.traits->blends_without_limit;
    hear(run, joining_in_force(run));
    tell_joining(run, false);
}

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
            hear(run, heard::NoMotion{});
            return true;
        case Modal::retract_initial:
        case Modal::retract_clearance:
            state.clear_to_retract_plane = m == Modal::retract_clearance;
            hear(run, heard::RetractLevel{state.clear_to_retract_plane});
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

void settle_motion(Moving& run) {
    if (run.block.motion_behind) run.modal.motion = *run.block.motion_behind;
    run.block.motion_behind.reset();
}

}  // namespace obrys::interp
