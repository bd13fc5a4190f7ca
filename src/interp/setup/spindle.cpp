/// The spindle: S, M3, M4, M5, M19, SPOS and what else stops it; other spindles and which one S and M3 are for.

#include <algorithm>
#include <cmath>

#include "base/codes.hpp"
#include "base/whole.hpp"
#include "interp/setup/setup.hpp"

namespace obrys::interp {

namespace codes = base::codes;
using program::ControlValue;

namespace {

bool in_block(const Moving& run, int m) {
    return std::find(run.block.m.begin(), run.block.m.end(), m) != run.block.m.end();
}

void stop_spindle(Moving& run) {
    run.spindle.direction = 0;
    run.spindle.direction_known = true;
    run.spindle.held.reset();
    emit_spindle(run);
}

/// Degrees of SPOS, of M19 where its R says so, or what a cycle has set for M19 (CYCL DEF 13); of M19 alone the machine
/// knows. Nothing: the block holds no spindle.
std::optional<double> held_at(const Moving& run) {
    if (run.block.has(Code::spindle_position)) return run.block.peek(Code::spindle_position);
    if (!in_block(run, 19)) return std::nullopt;
    return run.block.has(Code::radius) ? run.block.peek(Code::radius) : run.spindle.orientation;
}

/// S; true where it changed something.
bool speed_word(Moving& run) {
    const BlockWords& b = run.block;
    if (!b.has(Code::spindle) || dwells_by_words(run)) return false;
    const double s = b.get(Code::spindle);
    if (std::isnan(s)) {
        unchecked(run, codes::unknown_value, run.here(),
                  "the spindle speed depends on a value that is not known: it is not judged until the next S");
        run.spindle.speed = s;
        run.spindle.speed_known = false;
        return run.spindle.direction != 0;
    }
    if (s < 0) return alarm(run, codes::value_range, run.here(), "the spindle speed S is negative"), false;
    const bool feet = run.modal.surface_speed && run.modal.inch_geometry;  // cutting speed in ft/min
    run.spindle.speed = s * (feet ? 0.3048 : 1);
    run.spindle.speed_known = true;
    return true;
}

/// M3 and M4.
bool turn_words(Moving& run) {
    if (in_block(run, 3) && in_block(run, 4))
        unchecked(run, codes::repeated_word, run.here(),
                  "M3 and M4 stand in one block: which of them acts is not certain, the later one is run",
                  "write one of them");
    bool changed = false;
    for (const int m : run.block.m) {
        if (m != 3 && m != 4) continue;
        run.spindle.direction = run.spindle.last = m == 3 ? 1 : -1;
        run.spindle.doubtful = false;
        run.spindle.direction_known = true;
        changed = true;
    }
    return changed;
}

/// Function m by the control's own list of those that stop the spindle.
void stop_by_list(Moving& run, int m, bool before_motion) {
    for (const program::SpindleStop& s : run.traits->spindle_stops) {
        if (s.function != m || s.before_motion != before_motion) continue;
        if (!s.certain) run.spindle.doubtful = true;
        if (s.certain) run.spindle.direction_known = true;
        if (s.certain && run.spindle.direction != 0) stop_spindle(run);
        if (s.coolant && run.coolant_on) coolant(run, 9);
        if (s.does_more) emit(run, cl::Auxiliary{'M', s.function});
    }
}

/// LIMS, G92 S of lathes, G50 S. False where the control stops.
bool take_speed_limit(Moving& run) {
    const double limit = run.block.get(Code::speed_limit);
    if (limit < 0)
        return alarm(run, codes::value_range, run.here(), "the limit of the spindle speed is negative"), false;
    if (std::isnan(limit))
        unchecked(run, codes::unknown_value, run.here(),
                  "the limit of the spindle speed depends on a value that is not known: the last one is kept");
    else
        run.spindle.limit = limit;
    return true;
}

}  // namespace

bool dwells_by_words(const Moving& run) { return run.block.special == Modal::dwell && run.traits->dwell_in_feed_words; }

void emit_spindle(Moving& run) {
    control_sets(run, {ControlValue::spindle_state});
    cl::Spindle s;
    s.speed = run.spindle.direction == 0 && std::isnan(run.spindle.speed) ? 0 : run.spindle.speed;
    s.mode = run.modal.surface_speed ? cl::SpindleMode::surface : cl::SpindleMode::rpm;
    s.direction = static_cast<std::int8_t>(run.spindle.direction);
    s.limit = run.modal.surface_speed ? run.spindle.limit : 0;
    if (const auto held = held_at(run)) run.spindle.held = held;
    if (s.direction != 0) run.spindle.held.reset();
    s.held = run.spindle.held;
    emit(run, s);
}

void stop_for_change(Moving& run, bool same) {
    const bool by_control = run.traits->tool_change_stops_spindle;
    const bool stops = run.env.machine.tool_change_stops_spindle.value_or(by_control || run.env.machine.kind ==
                                                                                            shop::MachineKind::mill);
    if (!stops || (same && !by_control)) return;
    run.spindle.direction_known = true;
    if (run.spindle.direction != 0) stop_spindle(run);
}

bool spindle_words(Moving& run) {
    const BlockWords& b = run.block;
    bool changed = false;
    if (run.spindle.mode_changed) {
        run.spindle.mode_changed = false;
        changed = run.spindle.direction != 0 || !b.has(Code::spindle);
    }
    changed = speed_word(run) || changed;
    if (run.stopped) return false;
    if (b.has(Code::speed_limit)) {
        if (!take_speed_limit(run)) return false;
        changed = true;
    }
    changed = turn_words(run) || changed;
    if (b.has(Code::spindle_position)) {
        b.use(Code::spindle_position);
        run.spindle.direction = 0;
        run.spindle.direction_known = true;
        changed = true;
    }
    if (std::isnan(run.spindle.speed) && run.spindle.speed_known && changed)
        assume(run, run.here(),
               "the spindle keeps the speed that G96 gave it, and where X stands is not known here: the speed is not "
               "judged until the next S",
               "position X before, or program S");
    return changed;
}

void stop_function(Moving& run, int m, bool before_motion) {
    if (before_motion == run.traits->stops_before_motion) {
        if (m == 5 || m == 19) stop_spindle(run);
        if (m == 9) coolant(run, m);
    }
    stop_by_list(run, m, before_motion);
}

void other_spindle(Reckoning& run, Code word, double number, double value) {
    const auto n = base::whole<int>(number, 1, 999);
    if (!n || std::isnan(value)) return;
    OtherSpindles::Other& other = run.spindles.others[*n];
    if (word == Code::spindle) other.speed = value;
    if (word == Code::spindle_position) other.direction = 0;
    if (word == Code::m && (value == 3 || value == 4)) other.direction = value == 3 ? 1 : -1;
    if (word == Code::m && (value == 5 || value == 19 || value == 70)) other.direction = 0;
}

void select_master(Moving& run, std::optional<double> number) {
    const auto n = number ? base::whole<int>(*number, 1, 999) : std::optional(1);
    if (!n)
        return unchecked(run, codes::unknown_value, run.here(),
                         "which spindle SETMS makes the one of S, M3, G95 and G96 is not known");
    OtherSpindles& all = run.spindles;
    if (*n != 1)
        unchecked(run, codes::unsupported, run.here(),
                  "SETMS(" + std::to_string(*n) + "): S, M3, M4, M5, G95 and G96 are those of spindle " +
                      std::to_string(*n) + " from here on; which of the spindles turns tool or workpiece is not known",
                  "SETMS without a number comes back to the first one");
    if (*n == all.master) return;
    all.others[all.master] = {run.spindle.speed, run.spindle.direction};
    const OtherSpindles::Other now = all.others[*n];
    all.others.erase(*n);
    all.master = *n;
    run.spindle.speed = now.speed;
    run.spindle.direction = now.direction;
    emit_spindle(run);
}

void judge_stop(Reckoning& run) {
    run.spindle.doubtful = false;
    if (run.spindle.direction == 0) return;
    assume(run, run.here(),
           "the stop of the program before it may stop the spindle, as machine and operator have it: it is taken to "
           "turn on, no M3 or M4 stands behind",
           "write M3 behind the stop");
}

}  // namespace obrys::interp
