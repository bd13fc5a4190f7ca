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
Heights heights_below_tool(Course& c, const OldDepth& d, const Situation& s) {
    const double top = c.known(s.at.z, "the tool's height"), surface = top - std::abs(d.clearance);
    return {.surface = surface, .clearance = top, .bottom = surface + d.depth, .end = top};
}

void tap_floating(Course& c, const Heights& h, double feed, double dwell, const Situation& s) {
    const double speed = turning(c, s);
    if (!c.ready()) return;
    c.rapid_w(h.clearance);
    c.move_w(h.bottom, feed);
    c.spindle(speed, -s.spindle_direction);
    c.dwell(dwell);
    c.move_w(h.clearance, feed);
    c.spindle(speed, s.spindle_direction);
    c.rapid_w(h.end);
}

double read_speed(Course& c, const Situation& s) {
    const double speed = c.spindle_speed(s);
    if (speed <= 0) c.fault("the spindle speed is 0", "program a speed with the tool");
    return speed;
}

void tap_rigid(Course& c, const Heights& h, double pitch, const Situation& s) {
    const double speed = read_speed(c, s);
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

}  // namespace

void write_steps(Course& c, const OldFloatingTapping& d, const Situation& s) {
    const Heights h = heights_below_tool(c, d, s);
    const double feed = c.feed_in_force_or(d.feed_plunge, Role::feed_plunge, s.feed);
    tap_floating(c, h, feed, d.dwell.value_or(0), s);
}

void write_steps(Course& c, const DepthFloatingTapping& d, const Situation& s) {
    tap_floating(c, heights_of(d), d.feed_plunge, d.dwell_bottom.value_or(0), s);
}

void write_steps(Course& c, const OldRigidTapping& d, const Situation& s) {
    tap_rigid(c, heights_below_tool(c, d, s), d.pitch, s);
}

void write_steps(Course& c, const DepthRigidTapping& d, const Situation& s) { tap_rigid(c, heights_of(d), d.pitch, s); }

void write_steps(Course& c, const ChipBreakTapping& d, const Situation& s) {
    const Heights h = heights_of(d);
    const double speed = read_speed(c, s), every = d.chip_break_depth.value_or(0);
    check_breaks(c, every, h.surface - h.bottom);
    // iTNC 530 cycles, cycle 209: "the TNC multiplies the pitch Q239 by the programmed value".
    const double distance = d.chip_break_distance.value_or(0) * std::abs(d.pitch);
    const double factor = unless_0(d.rpm_factor, 1);
    if (!c.ready()) return;
    const int in = d.pitch > 0 ? 1 : -1;
    c.rapid_w(h.clearance);
    c.spindle(speed, in);
    for (int k = 1; every > 0 && h.surface - k * every > h.bottom + same_depth; ++k) {
        const double level = h.surface - k * every;
        c.thread_w(level, d.pitch, true);
        c.spindle(speed * factor, -in);
        // Distance 0: out of the hole.
        c.thread_w(distance > 0 ? std::min(level + distance, h.clearance) : h.clearance, d.pitch, true);
        c.spindle(speed, in);
    }
    c.thread_w(h.bottom, d.pitch, true);
    c.spindle(speed * factor, -in);
    c.thread_w(h.clearance, d.pitch, true);
    c.spindle(0, 0);
    c.rapid_w(h.end);
}

/// One pass from where the tool stands, in the direction of the depth's sign; the spindle stops at its end.
void write_steps(Course& c, const ThreadCutting& d, const Situation& s) {
    const double from = c.known(s.at.z, "the tool's height");
    turning(c, s);
    if (d.depth == 0) return c.not_executed(Role::depth);
    if (!c.ready()) return;
    c.thread_w(from + d.depth, d.pitch, false);
    c.spindle(0, 0);
}

}  // namespace obrys::cycles
