/// Tapping. Source: HEIDENHAIN iTNC 530 cycle programming, chapter on tapping (206, 207, 209) and cycle 18; the old
/// forms 2 and 17: TNC 407 conversational, simple fixed cycles.

#include <algorithm>
#include <cmath>

#include "cycles/hole/families.hpp"
#include "cycles/levels.hpp"

namespace obrys::cycles {

namespace {

/// Speed of the spindle; a standing one is a complaint where the program must have started it.
double turning(Course& c, const Situation& s) {
    const double speed = c.spindle_speed(s);
    if (s.spindle_direction == 0 || speed == 0)
        c.fault("the spindle does not turn", "program M3 or M4 before the call");
    return speed;
}

/// Where the tool enters and what it goes through: the old forms start where the tool stands.
Heights old_heights(Course& c, const Situation& s) {
    Heights h;
    h.clearance = h.end = c.known(s.at.z, "the tool's height");
    h.surface = h.clearance - std::abs(c.need(Role::clearance));
    h.bottom = h.surface + c.depth();
    return h;
}

void floating(Course& c, const Situation& s, bool old_form) {
    const Heights h = old_form ? old_heights(c, s) : read_heights(c);
    const double speed = turning(c, s);
    const double feed = old_form ? c.feed_or_programmed(Role::feed_plunge, s.feed) : c.feed(Role::feed_plunge);
    const double dwell = c.maybe_at_least(old_form ? Role::dwell : Role::dwell_bottom, 0, 0);
    if (!c.ready()) return;
    c.rapid_w(h.clearance);
    c.move_w(h.bottom, feed);
    c.spindle(speed, -s.spindle_direction);
    c.dwell(dwell);
    c.move_w(h.clearance, feed);
    c.spindle(speed, s.spindle_direction);
    c.rapid_w(h.end);
}

double read_pitch(Course& c) {
    const double pitch = c.need(Role::pitch);
    if (pitch == 0) c.fault(Role::pitch, "the thread pitch must not be 0");
    return pitch;
}

double read_speed(Course& c, const Situation& s) {
    const double speed = c.spindle_speed(s);
    if (speed <= 0) c.fault("the spindle speed is 0", "program a speed with the tool");
    return speed;
}

void rigid(Course& c, const Situation& s, bool old_form) {
    const Heights h = old_form ? old_heights(c, s) : read_heights(c);
    const double pitch = read_pitch(c), speed = read_speed(c, s);
    if (!c.ready()) return;
    const int in = pitch > 0 ? 1 : -1;  // the control turns the spindle itself
    c.rapid_w(h.clearance);
    c.spindle(speed, in);
    c.thread_w(h.bottom, pitch, true);
    c.spindle(speed, -in);
    c.thread_w(h.clearance, pitch, true);
    c.spindle(0, 0);
    c.rapid_w(h.end);
}

void chip_breaking(Course& c, const Situation& s) {
    const Heights h = read_heights(c);
    const double pitch = read_pitch(c), speed = read_speed(c, s);
    const double every = read_break_depth(c, h.surface - h.bottom);
    // iTNC 530 cycles, cycle 209: "the TNC multiplies the pitch Q239 by the programmed value".
    const double distance = c.maybe_at_least(Role::chip_break_distance, 0, 0) * std::abs(pitch);
    double factor = c.maybe_at_least(Role::rpm_factor, 0, 1);
    if (factor == 0) factor = 1;
    if (!c.ready()) return;
    const int in = pitch > 0 ? 1 : -1;
    c.rapid_w(h.clearance);
    c.spindle(speed, in);
    for (int k = 1; every > 0 && h.surface - k * every > h.bottom + same_depth; ++k) {
        const double level = h.surface - k * every;
        c.thread_w(level, pitch, true);
        c.spindle(speed * factor, -in);
        // Distance 0: out of the hole.
        c.thread_w(distance > 0 ? std::min(level + distance, h.clearance) : h.clearance, pitch, true);
        c.spindle(speed, in);
    }
    c.thread_w(h.bottom, pitch, true);
    c.spindle(speed * factor, -in);
    c.thread_w(h.clearance, pitch, true);
    c.spindle(0, 0);
    c.rapid_w(h.end);
}

/// One pass from where the tool stands, in the direction of the depth's sign; the spindle stops at its end.
void thread_cut(Course& c, const Situation& s) {
    const double from = c.known(s.at.z, "the tool's height");
    const double depth = c.need(Role::depth), pitch = read_pitch(c);
    turning(c, s);
    if (depth == 0) return c.not_executed(Role::depth);
    if (!c.ready()) return;
    c.thread_w(from + depth, pitch, false);
    c.spindle(0, 0);
}

}  // namespace

void expand_tap(Course& c, const Demand& demand, const Situation& situation) {
    switch (demand.kind) {
        case Kind::tap_floating_simple: return floating(c, situation, true);
        case Kind::tap_rigid_simple: return rigid(c, situation, true);
        case Kind::tap_rigid: return rigid(c, situation, false);
        case Kind::tap_chip_breaking: return chip_breaking(c, situation);
        case Kind::thread_cut: return thread_cut(c, situation);
        default: return floating(c, situation, false);
    }
}

}  // namespace obrys::cycles
