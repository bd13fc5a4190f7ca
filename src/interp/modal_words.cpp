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

void set_datum(Run& run, std::uint32_t number) {
    if (run.modal.datum == number) return;
    flush_path(run);
    run.modal.datum = number;
    if (!run.moved && run.reference_datum == 500) run.reference_datum = number;
    update_frame(run);
}

void set_motion(Run& run, Modal m) {
    run.modal.motion = m;
    run.block.motion_word = true;
}

/// Units, kinds of feed, G90/G91, G96/G97, diameters; false for other words.
bool units_and_feed(Run& run, const program::Word& w) {
    ModalState& state = run.modal;
    switch (program::modal_of(w)) {
        case Modal::inch_geometry:
            state.inch_geometry = true;
            return true;
        case Modal::metric_geometry:
            state.inch_geometry = state.metric_feed = false;
            return true;
        case Modal::inch_all:
            state.inch_geometry = state.inch_feed = true;
            return true;
        case Modal::metric_all:
            state.inch_geometry = state.inch_feed = false;
            state.metric_feed = true;
            return true;
        case Modal::absolute:
            state.absolute = true;
            return true;
        case Modal::incremental:
            state.absolute = false;
            return true;
        case Modal::feed_inverse_time:
            set_feed_mode(run, cl::FeedMode::inverse_time);
            return true;
        case Modal::feed_per_minute:
            set_surface_speed(run, false, 0);
            set_feed_mode(run, cl::FeedMode::per_minute);
            return true;
        case Modal::feed_per_rev:
            set_surface_speed(run, false, 0);
            set_feed_mode(run, cl::FeedMode::per_rev);
            return true;
        case Modal::surface_speed_on:
            set_surface_speed(run, true, program::modal_number(w));
            return true;
        case Modal::surface_speed_off:
            set_surface_speed(run, false, program::modal_number(w));
            return true;
        case Modal::diameter_on:
            state.diameter = DiameterMode::on;
            return true;
        case Modal::diameter_off:
            state.diameter = DiameterMode::off;
            return true;
        case Modal::diameter_absolute_only:
            state.diameter = DiameterMode::absolute_only;
            return true;
        default:
            return false;
    }
}

}  // namespace

void modal_word(Run& run, const program::Word& w) {
    const Modal m = program::modal_of(w);
    ModalState& state = run.modal;
    if (units_and_feed(run, w)) return;
    switch (m) {
        case Modal::rapid:
        case Modal::linear:
        case Modal::arc_cw:
        case Modal::arc_ccw:
        case Modal::arc_via:
        case Modal::arc_tangent:
        case Modal::thread:
        case Modal::thread_rising:
        case Modal::thread_falling:
        case Modal::tap:
        case Modal::tap_retract:
            set_motion(run, m);
            return;
        case Modal::dwell:
        case Modal::reference_point:
        case Modal::fixed_point:
        case Modal::pole_from_position:
        case Modal::pole_from_zero:
        case Modal::pole_from_pole:
            run.block.special = m;
            return;
        case Modal::plane_xy:
            set_plane(run, 17);
            return;
        case Modal::plane_zx:
            set_plane(run, 18);
            return;
        case Modal::plane_yz:
            set_plane(run, 19);
            return;
        case Modal::compensation_off:
        case Modal::compensation_left:
        case Modal::compensation_right:
            state.compensation = m;
            return;
        case Modal::datum:
            set_datum(run, static_cast<std::uint32_t>(program::modal_number(w)));
            return;
        case Modal::suppress_frames:
        case Modal::suppress_all:
            run.block.suppress = m;
            return;
        case Modal::exact_stop:
        case Modal::exact_stop_block:
        case Modal::continuous:
        case Modal::exact_window:
            return;
        case Modal::approach_normal:
        case Modal::approach_contour:
            state.approach = m;
            return;
        case Modal::corner_arc:
        case Modal::corner_intersection:
            state.corner = m;
            return;
        case Modal::feed_at_contour:
        case Modal::feed_at_tool:
        case Modal::feed_at_inside:
            state.feed_reference = m;
            return;
        default:
            return;
    }
}

}  // namespace obrys::interp
