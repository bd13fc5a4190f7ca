/// M70 … M73: modes, feed, spindle, coolant and overrides are kept and come back later.
/// Source: LinuxCNC, M-Codes, "M70 Save Modal State" to "M73 Save and Autorestore Modal State"; the order of what comes
/// back is that of its stand-alone interpreter.

#include "interp/calls/calls.hpp"

namespace obrys::interp {

void save_modes(Reckoning& run, bool for_call) {
    const Offsets& o = run.offsets;
    run.top().saved_modes = SavedModes{run.modal, run.feed, run.feed_valid, run.feed_number, run.spindle,  run.mist,
                                       run.flood, o.tool,   o.length,       o.length_tool,   run.overrides};
    run.top().restores_modes = for_call;
}

void forget_modes(Saying& run) {
    run.top().saved_modes.reset();
    run.top().restores_modes = false;
}

namespace {

void restore_spindle_mode(Telling& run, const ModalState& s) {
    if (s.surface_speed == run.modal.surface_speed) return;
    hear(run, heard::SpeedKind{s.surface_speed ? run.spindle.limit : 0});
    run.modal.surface_speed = s.surface_speed;
    run.modal.speed_word = s.speed_word;
}

/// In another kind of feed the one that was saved is not taken up again. The number of F comes back, not the feed: in
/// the unit that is in force then.
void restore_feed(Calling& run, const SavedModes& s) {
    constexpr Modal words[] = {Modal::feed_per_minute, Modal::feed_per_rev, Modal::feed_inverse_time};
    if (s.modal.feed_mode != run.modal.feed_mode) {
        static_cast<void>(apply_mode(run, words[static_cast<std::size_t>(s.modal.feed_mode)], 0));
        return;
    }
    if (!s.feed_valid || (run.feed_valid && run.feed_number == s.feed_number)) return;
    run.feed_number = s.feed_number;
    run.feed = s.feed_number * feed_factor(run);
    run.feed_valid = true;
    hear(run, heard::FeedNumber{s.feed_number});
    emit(run, cl::Feed{run.feed, run.modal.feed_mode});
}

void restore_spindle(Moving& run, const SpindleState& s) {
    const bool speed = s.speed != run.spindle.speed, turn = s.direction != run.spindle.direction;
    run.spindle = s;
    run.spindle.mode_changed = false;
    if (speed) hear(run, heard::SpeedNumber{s.speed});
    if (turn) hear(run, heard::SpindleTurn{s.direction});
    if (speed || turn) emit_spindle(run);
}

void restore_coolant(Telling& run, const SavedModes& s) {
    if (s.mist == run.mist && s.flood == run.flood) return;
    for (const int m : {9, 7, 8}) {
        const bool wanted = m == 9 ? (run.mist && !s.mist) || (run.flood && !s.flood) : m == 7 ? s.mist : s.flood;
        if (!wanted || (m == 7 && run.mist) || (m == 8 && run.flood)) continue;
        hear(run, heard::CoolantWord{m});
        coolant(run, m);
    }
}

void restore_lengths(Telling& run, const SavedModes& s) {
    Offsets& o = run.offsets;
    const bool same = o.length == s.length && o.length_tool == s.length_tool;
    o.length = s.length;
    o.length_tool = s.length_tool;
    tell_length(run, s.tool_offset);
    if (o.tool != s.tool_offset) set_tool_offset(run, s.tool_offset);
    if (!same) {
        judge_anew(o);
        take_tip(run);
    }
    if (run.modal.datum != s.modal.datum) set_datum(run, s.modal.datum);
}

void restore_path(Telling& run, const ModalState& s) {
    ModalState& m = run.modal;
    if (m.path_mode == s.path_mode && m.blend == s.blend && m.merge == s.merge) return;
    m.path_mode = s.path_mode;
    m.blend = s.blend;
    m.merge = s.merge;
    hear(run, joining_in_force(run));
    tell_joining(run, false);
}

void restore_words(Calling& run, const SavedModes& s) {
    const auto back = [&](bool differs, Modal m) {
        if (differs) static_cast<void>(apply_mode(run, m, 0));
    };
    const ModalState now = run.modal;
    if (now.plane != s.modal.plane) set_plane(run, s.modal.plane);
    back(now.diameter != s.modal.diameter,
         s.modal.diameter == DiameterMode::off ? Modal::diameter_off : Modal::diameter_on);
    if (now.compensation != s.modal.compensation) {
        back(true, s.modal.compensation);
        run.modal.compensation_radius = s.modal.compensation_radius;
        run.modal.compensation_given = s.modal.compensation_given;
        run.modal.compensation_orientation = s.modal.compensation_orientation;
    }
    restore_lengths(run, s);
    restore_path(run, s.modal);
    back(now.absolute != s.modal.absolute, s.modal.absolute ? Modal::absolute : Modal::incremental);
    back(now.centre_absolute != s.modal.centre_absolute,
         s.modal.centre_absolute ? Modal::arc_centre_absolute : Modal::arc_centre_incremental);
    back(now.clear_to_retract_plane != s.modal.clear_to_retract_plane,
         s.modal.clear_to_retract_plane ? Modal::retract_clearance : Modal::retract_initial);
}

/// As the words M48 (both), M49 (none), M50 (feed) and M51 (speed) leave them.
void restore_overrides(Telling& run, const Overrides& s) {
    if (run.overrides.feed != s.feed || run.overrides.speed != s.speed) {
        const bool none = !s.feed && !s.speed;
        if (s.feed || none) switch_override(run, cl::OverrideKind::feed, s.feed);
        if (s.speed || none) switch_override(run, cl::OverrideKind::spindle, s.speed);
    }
    if (run.overrides.hold != s.hold) switch_override(run, cl::OverrideKind::feed_hold, s.hold);
}

}  // namespace

void restore_modes(Calling& run) {
    if (!run.top().saved_modes) return;
    const SavedModes s = *run.top().saved_modes;
    const BlockWords block = std::move(run.block);  // what comes back stands in no block
    run.block = {};
    const bool complained = std::exchange(run.complained, false);
    if (s.modal.inch_geometry != run.modal.inch_geometry)
        static_cast<void>(apply_mode(run, s.modal.inch_geometry ? Modal::inch_all : Modal::metric_all, 0));
    restore_spindle_mode(run, s.modal);
    restore_feed(run, s);
    restore_spindle(run, s.spindle);
    restore_words(run, s);
    restore_coolant(run, s);
    restore_overrides(run, s.overrides);
    run.block = block;
    run.complained = complained;
}

}  // namespace obrys::interp
