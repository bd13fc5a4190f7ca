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
#include "cycles/levels.hpp"

namespace obrys::cycles {

namespace {

/// The spindle as the thread wants it before the tool goes in.
Turning read_tap(Course& c, const Situation& s) {
    const Turning t = read_turning(c, s);
    const int starts = c.whole(Role::starts_spindle, 0, 0, 2, "the start of the spindle");
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

void floating(Course& c, const Demand& demand, const Situation& s) {
    const Hole h = read_hole(c, s);
    const double factor = demand.find(Role::rpm_factor) ? c.positive(Role::rpm_factor) : 1;
    const Turning in = read_tap(c, s), out{in.speed * factor, -in.direction};
    const bool faster = factor != 1 && !std::isnan(s.feed);  // per revolution the feed follows by itself
    for (const Role role : {Role::dwell_bottom, Role::dwell, Role::dwell_top}) c.maybe_at_least(role, 0, 0);
    const bool whole_way = c.maybe(Role::feed_out, 0) != 0;
    const int axes = c.whole(Role::turned_axes, 0, 0, 2, "the order of the axes");
    if (!c.ready()) return;
    if (axes != 0) c.remark(Role::turned_axes, "the control feeds along the wrong axes when it taps in this plane");
    const bool pitched = demand.find(Role::pitch).has_value();
    const double pitch = pitched ? c.positive(Role::pitch) : 0;
    if (!c.ready()) return;
    const auto feed_to = [&](double w) { c.straight(turned({h.target.x, h.target.y, w}, axes), false); };
    approach(c, h);
    if (s.spindle_direction != in.direction) start_spindle(c, in);
    if (pitched) c.add(cl::Feed{pitch * in.speed, cl::FeedMode::per_minute});
    feed_to(h.bottom);
    dwell_if(c, demand, Role::dwell_bottom);
    stop_spindle(c, in);
    start_spindle(c, out);
    dwell_if(c, demand, Role::dwell);
    if (faster) c.add(cl::Feed{s.feed * factor, cl::FeedMode::per_minute});
    feed_to(whole_way ? h.end : h.retract);
    if (faster) c.add(cl::Feed{s.feed, cl::FeedMode::per_minute});
    dwell_if(c, demand, Role::dwell_top);
    stop_spindle(c, in);
    end_turning(c, demand, in);
    if (!whole_way) rapid_to_w(c, h.end);
}

double read_pitch(Course& c, const Demand& demand, const Situation& s, double speed) {
    if (demand.find(Role::pitch)) return c.positive(Role::pitch);
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
    bool restarts = false;
};

Rigid read_rigid(Course& c, const Demand& demand, const Situation& s) {
    Rigid r;
    r.hole = read_hole(c, s);
    r.in = read_turning(c, s);
    r.pitch = r.in.direction * read_pitch(c, demand, s, r.in.speed);
    const double factor = demand.find(Role::rpm_factor) ? c.positive(Role::rpm_factor) : 1;
    r.out = {r.in.speed * factor, -r.in.direction};
    for (const Role role : {Role::dwell_bottom, Role::dwell}) c.maybe_at_least(role, 0, 0);
    const double top = top_of(c, r.hole);
    r.restarts = s.spindle_direction != 0 && !demand.find(Role::spindle_direction);
    if (demand.get(Role::infeed, 0) != 0) {
        const bool said = demand.find(Role::chip_break_distance) || demand.find(Role::chip_break_turns) ||
                          demand.find(Role::stop_distance_first);
        if (!said)
            c.assume("how far a tap goes back between its steps is a parameter of the machine: it is taken as 1 mm");
        r.back = c.maybe_at_least(Role::chip_break_distance, 0, said ? 0 : 1);
        if (demand.find(Role::chip_break_turns)) r.back = c.positive(Role::chip_break_turns) * std::abs(r.pitch);
        r.stop = c.maybe_at_least(Role::stop_distance_first, 0, 0);
        const Infeeds infeeds = read_infeeds(c, false);
        if (c.ready()) r.levels = levels_of(c, top, r.hole.bottom, infeeds);
    }
    if (r.levels.empty()) r.levels.push_back(r.hole.bottom);
    return r;
}

/// Out after an infeed and in again to where the next one begins.
void break_chip(Course& c, const Demand& demand, const Rigid& r, double level) {
    dwell_if(c, demand, Role::dwell);
    start_spindle(c, r.out);
    c.thread_w(r.back > 0 ? std::min(level + r.back, r.hole.retract) : r.hole.retract, r.pitch, true);
    start_spindle(c, r.in);
    if (r.back <= 0) c.thread_w(std::min(level + r.stop, r.hole.retract), r.pitch, true);
}

void rigid(Course& c, const Demand& demand, const Situation& s) {
    const Rigid r = read_rigid(c, demand, s);
    if (!c.ready()) return;
    approach(c, r.hole);
    start_spindle(c, r.in);
    for (std::size_t i = 0; i < r.levels.size() && c.room(); ++i) {
        c.thread_w(r.levels[i], r.pitch, true);
        if (i + 1 < r.levels.size()) break_chip(c, demand, r, r.levels[i]);
    }
    dwell_if(c, demand, Role::dwell_bottom);
    dwell_if(c, demand, Role::dwell);
    start_spindle(c, r.out);
    c.thread_w(r.hole.retract, r.pitch, true);
    stop_spindle(c, r.in);
    if (r.restarts || demand.find(Role::spindle_after)) end_turning(c, demand, r.in);
    rapid_to_w(c, r.hole.end);
}

}  // namespace

void canned_tap(Course& c, const Demand& demand, const Situation& situation) {
    if (demand.kind == cl::CycleKind::canned_tap_rigid) return rigid(c, demand, situation);
    floating(c, demand, situation);
}

}  // namespace obrys::cycles
