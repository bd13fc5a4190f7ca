/// G codes and their named relatives: what they change in the modal state.

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/codes.hpp"
#include "interp/run.hpp"

namespace obrys::interp {

namespace {

void set_plane(Run& run, int plane) {
    if (run.modal.plane == plane) return;
    flush_path(run);
    run.modal.plane = plane;
    forget_polar_angle(run.modal);
}

void set_feed_mode(Run& run, cl::FeedMode mode) {
    if (run.modal.feed_mode == mode) return;
    run.modal.feed_mode = mode;
    run.feed_dropped = true;
    run.feed_valid = false;  // an F of the old kind means nothing in the new one
}

/// G97 without S keeps the speed that G96 had reached at this X (Siemens, NC programming 12/2019, p. 99).
void keep_reached_speed(Run& run) {
    SpindleState& s = run.spindle;
    s.surface = s.speed;
    const double x = std::abs(run.programmed_position.x);
    s.speed = s.surface * 1000 / (2 * geom::pi * x);
    if (s.limit > 0) s.speed = std::min(s.speed, s.limit);
    if (!std::isfinite(s.speed)) s.speed = s.limit > 0 && x == 0 ? s.limit : std::numeric_limits<double>::quiet_NaN();
}

/// G96 G961 G962 and G97 G971 G972 G973: `number` says which; the last digit pair decides the kind of feed.
void set_surface_speed(Run& run, bool on, int number) {
    if (on != run.modal.surface_speed) {
        if (on)
            run.spindle.speed = run.spindle.surface;
        else
            keep_reached_speed(run);
        run.spindle.mode_changed = true;
    }
    run.modal.surface_speed = on;
    run.modal.speed_word = number;
    if (number == 96 || number == 97 || number == 973) set_feed_mode(run, cl::FeedMode::per_rev);
    if (number == 961 || number == 971) set_feed_mode(run, cl::FeedMode::per_minute);
}

/// G94 and G95 stand in one group with G96: they end it (SINUMERIK Programming Manual Fundamentals, G96). Easily
/// missed.
void plain_feed(Run& run, cl::FeedMode mode) {
    if (run.modal.surface_speed)
        assume(
            run, run.here(),
            "G94 and G95 end the constant cutting speed of G96 (same G group): the spindle keeps the speed it has here",
            "write G96 behind them if the cutting speed is to stay constant");
    set_surface_speed(run, false, 0);
    set_feed_mode(run, mode);
}

/// Motion, plane and what acts in this block only. False where `m` is none of them.
bool motion_word(Run& run, Modal m, const program::Word& w) {
    if (m <= Modal::tap_retract) {
        run.modal.motion = m;
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
        case Modal::paraxial:
        case Modal::paraxial_longer:
        case Modal::paraxial_shorter: run.block.paraxial = m; return true;
        case Modal::corner_crossing:
        case Modal::corner_open: run.block.corner_end = m; return true;
        case Modal::look_ahead: run.modal.look_ahead = program::modal_number(w); return true;
        case Modal::arc_same_sense: run.modal.motion = run.modal.last_sense; return true;
        case Modal::suppress_frames:
        case Modal::suppress_all: run.block.suppress = m; return true;
        case Modal::plane_xy: set_plane(run, 17); return true;
        case Modal::plane_zx: set_plane(run, 18); return true;
        case Modal::plane_yz: set_plane(run, 19); return true;
        default: return false;
    }
}

/// Units, absolute and incremental, diameters. False where `m` is none of them.
bool dimension_word(ModalState& state, Modal m) {
    switch (m) {
        case Modal::inch_geometry: state.inch_geometry = true; return true;
        case Modal::metric_geometry: state.inch_geometry = state.metric_feed = false; return true;
        case Modal::inch_all: state.inch_geometry = state.inch_feed = true; return true;
        case Modal::metric_all:
            state.inch_geometry = state.inch_feed = false;
            state.metric_feed = true;
            return true;
        case Modal::absolute: state.absolute = true; return true;
        case Modal::incremental: state.absolute = false; return true;
        case Modal::diameter_on: state.diameter = DiameterMode::on; return true;
        case Modal::diameter_off: state.diameter = DiameterMode::off; return true;
        case Modal::diameter_absolute_only: state.diameter = DiameterMode::absolute_only; return true;
        default: return false;
    }
}

}  // namespace

void set_datum(Run& run, std::uint32_t number) {
    if (run.modal.datum == number) return;
    flush_path(run);
    run.modal.datum = number;
    if (!run.moved && run.reference_datum == 500) run.reference_datum = number;
    update_frame(run);
}

void modal_word(Run& run, const program::Word& w) {
    const Modal m = program::modal_of(w);
    ModalState& state = run.modal;
    if (motion_word(run, m, w) || dimension_word(state, m)) return;
    switch (m) {
        case Modal::compensation_off:
        case Modal::compensation_left:
        case Modal::compensation_right: state.compensation = m; return;
        case Modal::datum: set_datum(run, static_cast<std::uint32_t>(program::modal_number(w))); return;
        case Modal::feed_inverse_time: set_feed_mode(run, cl::FeedMode::inverse_time); return;
        case Modal::feed_per_minute: plain_feed(run, cl::FeedMode::per_minute); return;
        case Modal::feed_per_rev: plain_feed(run, cl::FeedMode::per_rev); return;
        case Modal::surface_speed_on: set_surface_speed(run, true, program::modal_number(w)); return;
        case Modal::surface_speed_off: set_surface_speed(run, false, program::modal_number(w)); return;
        case Modal::approach_normal:
        case Modal::approach_contour: state.approach = m; return;
        case Modal::corner_arc:
        case Modal::corner_intersection: state.corner = m; return;
        case Modal::feed_at_contour:
        case Modal::feed_at_tool:
        case Modal::feed_at_inside: state.feed_reference = m; return;
        default: return;  // exact stop and continuous path: no effect on the path itself
    }
}

}  // namespace obrys::interp
