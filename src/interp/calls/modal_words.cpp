/// G codes and their named relatives: what they change in the modal state.

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>
#include <utility>

#include "base/codes.hpp"
#include "base/text.hpp"
#include "base/whole.hpp"
#include "interp/calls/calls.hpp"
#include "interp/stream/path_stage.hpp"

namespace obrys::interp {

namespace codes = base::codes;

namespace {

void set_feed_mode(Reckoning& run, cl::FeedMode mode) {
    if (run.traits->needs_feed) run.feed_valid = false;  // also where the mode stays
    if (run.modal.feed_mode == mode) return;
    run.modal.feed_mode = mode;
    run.modal.tooth_feed.reset();  // SINUMERIK ONE, NC programming 12/2019, "Tooth feedrate": deleted as F is
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

}  // namespace

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
            hear(run, heard::FeedKind{cl::FeedMode::inverse_time});
            set_feed_mode(run, cl::FeedMode::inverse_time);
            return true;
        case Modal::feed_per_minute:
            hear(run, heard::FeedKind{cl::FeedMode::per_minute});
            plain_feed(run, cl::FeedMode::per_minute);
            return true;
        case Modal::feed_per_rev:
            hear(run, heard::FeedKind{cl::FeedMode::per_rev});
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

void modes_behind_motion(Calling& run) {
    const std::vector<Modal> modes = std::exchange(run.block.behind, {});
    const Modal motion = run.modal.motion;
    const bool moves = (run.block.present & linear_axes) != 0 || run.block.has(Code::polar_angle) ||
                       run.block.has(Code::polar_radius) || run.block.has(Code::pole_angle);
    for (const Modal m : modes) {
        const bool decides = m == Modal::feed_per_minute && run.modal.feed_mode == cl::FeedMode::per_rev;
        if (decides && moves && motion != Modal::rapid && !run.block.rapid)
            unchecked(
                run, codes::unknown_value, run.here(),
                "the feed is in mm per minute from the end of this block on: F of the block itself is taken in mm per "
                "revolution still",
                "write the M function in a block of its own before this one, and F behind it");
        static_cast<void>(apply_mode(run, m, 0));
    }
}

void modal_word(Calling& run, const program::Word& w) {
    const Modal m = program::modal_of(w);
    refuse_modal(run, w);
    repeated_group(run, w);
    run.modal.groups_said |= std::uint32_t{1} << static_cast<unsigned>(program::group_of(m));
    if (run.stopped || motion_word(run, m, w)) return;
    const std::span<const Modal> behind = run.traits->modes_behind_motion;
    if (std::find(behind.begin(), behind.end(), m) != behind.end()) return run.block.behind.push_back(m);
    if (apply_mode(run, m, program::modal_number(w)) || m < Modal::canned) return;
    // no reader may make a word that is not run here
    const base::Span where = run.unit().span(*run.statement, w);
    unchecked(run, base::codes::unsupported, where,
              std::string(base::trim(run.env.sources.text(where))) +
                  " is not run: what it changes on the control is not known here",
              "take it out, or say what it does by words that are run (docs/dialects)");
}

}  // namespace obrys::interp
