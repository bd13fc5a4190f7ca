/// Tapping by canned cycles (G74, G84). Sources: cycles/hole/canned.hpp.
///
/// Checked with LinuxCNC 2.9 itself: outside G17 its G74 and G84 feed to a place whose coordinates belong to other axes
/// (turned_axes 1 in G18, 2 in G19), and it takes the tool to be at the end of the hole afterwards.
///
/// Both kinds: spindle_direction +1 right-hand, -1 left-hand thread; starts_spindle 1: the cycle turns it on; 2: this
/// is listed.
///   canned_tap_floating  Without starts_spindle the spindle must turn in that direction already. At the bottom:
///                        dwell_bottom, spindle stop and reversal, dwell; feed out (feed_out); at the end of the feed
///                        dwell_top, spindle stop and reversal, rest of the way. LinuxCNC: feed_out 1, dwell 0 or P.
///                        rpm_factor for the way out: spindle and feed (Acramatic J). pitch: the feed follows from it
///                        and the speed.
///   canned_tap_rigid     pitch in mm (not written: feed by speed); dwell_bottom; rpm_factor for the way out. With
///                        infeed in steps, from the surface, where it is not 0: chip_break_distance above 0 that
///                        far back after each, or chip_break_turns of the thread, else out to the retract plane and
///                        down to stop_distance_first above the depth reached; none of these: a parameter, 1 mm. dwell:
///                        before each reversal. Where no spindle_direction is written it turns behind the cycle as
///                        before.

#include <algorithm>
#include <cmath>

#include "cycles/hole/canned.hpp"
#include "cycles/hole/families.hpp"
#include "cycles/levels.hpp"

namespace obrys::cycles {

namespace {

/// The spindle as the thread wants it before the tool goes in.
Turning turning_of_tap(Course& c, const FloatingTapping& d, const Situation& s) {
    const Turning t = turning_of(c, d.spindle_speed, d.spindle_direction, s);
    const int starts = c.whole(Role::starts_spindle, d.starts_spindle, 0, 0, 2, "the start of the spindle");
    if (starts == 2 && s.spindle_direction == 0)
        c.assume(
            "the spindle does not turn before the tapping cycle: without rigid tapping (M29) the control wants M3 "
            "or M4 before it; it is taken to start the spindle by itself");
    if (starts != 0 || !c.ready()) return t;
    if (s.spindle_direction == 0)
        c.fault("the spindle does not turn", "program M3 or M4 before the cycle");
    else if (s.spindle_direction != t.direction)
        c.fault(t.direction > 0 ? "the spindle turns counter-clockwise, the thread is right-hand"
                                : "the spindle turns clockwise, the thread is left-hand");
    return t;
}

/// What the control makes of a place above the hole: right, or with the coordinates given to the wrong axes.
geom::Vec3 turned(geom::Vec3 p, int how) {
    return how == 1 ? geom::Vec3{p.y, p.z, p.x} : how == 2 ? geom::Vec3{p.z, p.x, p.y} : p;
}

/// What is not said follows from feed and speed.
double pitch_of(Course& c, const Said& pitch, const Situation& s, double speed) {
    if (pitch) return *pitch;
    const double feed = c.known(s.feed, "the feed rate");
    if (feed <= 0) c.fault("Feed rate is missing", "program a feed rate F");
    if (speed <= 0) c.fault("the spindle speed is 0", "program a speed S");
    return feed / speed;
}

struct Rigid {
    Hole hole;
    Turning in, out;
    double pitch = 0;
    std::vector<double> levels;
    double back = 0, stop = 0;
};

/// Of tapping in steps: how far back, and where the next one begins behind a way out.
void take_steps(Course& c, const RigidTapping& d, double top, Rigid& r) {
    const bool said = d.chip_break_distance || d.chip_break_turns || d.stop_distance_first;
    if (!said) c.assume("how far a tap goes back between its steps is a parameter of the machine: it is taken as 1 mm");
    r.back = asked_or(c, d, &RigidTapping::chip_break_distance, Must::be_at_least_0, said ? 0 : 1);
    if (d.chip_break_turns) r.back = asked(c, d, &RigidTapping::chip_break_turns, Must::be_above_0) * std::abs(r.pitch);
    r.stop = asked_or(c, d, &RigidTapping::stop_distance_first, Must::be_at_least_0, 0);
    const double infeed = asked(c, d, &RigidTapping::infeed, Must::be_above_0);
    if (c.ready()) r.levels = levels_of(c, top, r.hole.bottom, {.first = infeed});
}

Rigid rigid_of(Course& c, const RigidTapping& d, const Situation& s) {
    Rigid r;
    r.hole = hole_of(c, d, s);
    r.in = turning_of(c, d.spindle_speed, d.spindle_direction, s);
    r.pitch = r.in.direction * pitch_of(c, d.pitch, s, r.in.speed);
    r.out = {r.in.speed * d.rpm_factor.value_or(1), -r.in.direction};
    const double top = top_of(c, d);
    if (d.infeed.value_or(0) != 0) take_steps(c, d, top, r);
    if (r.levels.empty()) r.levels.push_back(r.hole.bottom);
    return r;
}

/// Out after an infeed and in again to where the next one begins.
void break_chip(Course& c, const RigidTapping& d, const Rigid& r, double level) {
    dwell_if(c, d.dwell);
    start_spindle(c, r.out);
    c.thread_w(r.back > 0 ? std::min(level + r.back, r.hole.retract) : r.hole.retract, r.pitch, true);
    start_spindle(c, r.in);
    if (r.back <= 0) c.thread_w(std::min(level + r.stop, r.hole.retract), r.pitch, true);
}

}  // namespace

void write_steps(Course& c, const FloatingTapping& d, const Situation& s) {
    const Hole h = hole_of(c, d, s);
    const double factor = d.rpm_factor.value_or(1);
    const Turning in = turning_of_tap(c, d, s), out{in.speed * factor, -in.direction};
    const bool faster = factor != 1 && !std::isnan(s.feed);  // per revolution the feed follows by itself
    const bool whole_way = d.feed_out.value_or(0) != 0;
    const int axes = c.whole(Role::turned_axes, d.turned_axes, 0, 0, 2, "the order of the axes");
    if (!c.ready()) return;
    if (axes != 0) c.remark(Role::turned_axes, "the control feeds along the wrong axes when it taps in this plane");
    const auto feed_to = [&](double w) { c.straight(turned({h.target.x, h.target.y, w}, axes), false); };
    approach(c, h);
    if (s.spindle_direction != in.direction) start_spindle(c, in);
    if (d.pitch) c.add(cl::Feed{*d.pitch * in.speed, cl::FeedMode::per_minute});
    feed_to(h.bottom);
    dwell_if(c, d.dwell_bottom);
    stop_spindle(c, in);
    start_spindle(c, out);
    dwell_if(c, d.dwell);
    if (faster) c.add(cl::Feed{s.feed * factor, cl::FeedMode::per_minute});
    feed_to(whole_way ? h.end : h.retract);
    if (faster) c.add(cl::Feed{s.feed, cl::FeedMode::per_minute});
    dwell_if(c, d.dwell_top);
    stop_spindle(c, in);
    end_turning(c, d.spindle_after, in);
    if (!whole_way) rapid_to_w(c, h.end);
}

void write_steps(Course& c, const RigidTapping& d, const Situation& s) {
    const Rigid r = rigid_of(c, d, s);
    if (!c.ready()) return;
    approach(c, r.hole);
    start_spindle(c, r.in);
    for (std::size_t i = 0; i < r.levels.size() && c.room(); ++i) {
        c.thread_w(r.levels[i], r.pitch, true);
        if (i + 1 < r.levels.size()) break_chip(c, d, r, r.levels[i]);
    }
    dwell_if(c, d.dwell_bottom);
    dwell_if(c, d.dwell);
    start_spindle(c, r.out);
    c.thread_w(r.hole.retract, r.pitch, true);
    stop_spindle(c, r.in);
    const bool restarts = s.spindle_direction != 0 && !d.spindle_direction;
    if (restarts || d.spindle_after) end_turning(c, d.spindle_after, r.in);
    rapid_to_w(c, r.hole.end);
}

}  // namespace obrys::cycles
