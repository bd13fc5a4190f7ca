/// Boring by canned cycles (G76, G85 … G89). Sources: cycles/hole/canned.hpp.
///
///   canned_bore_feed    (G85, G89) dwell_bottom; feed_out. LinuxCNC: G85 feed_out 0, G89 feed_out 1. feed_plunge and
///                       feed_retract: in and out at other feeds than the one in force (SINUMERIK).
///   canned_bore_stop    (G86) dwell_bottom; spindle stop, with stops_program the program's, rapid out, spindle start.
///   canned_bore_orient  (G76) dwell_bottom; spindle stop, M19, shift_u, shift_v and shift_w at rapid, rapid out, back
///                       over the hole, spindle start.
/// Both: starts_spindle 1 turns the spindle on before the tool goes in; spindle_after: how it turns behind the cycle.
///   canned_back_bore    (G87) shift_u, shift_v; bottom: where the tool comes on the axis again below the material;
///                       counterbore_top; retract_plane only where the tool stops there first (LinuxCNC; Fanuc goes in
///                       from where it is); dwell: at the top of the counterbore; feed_out 1: back down at feed before
///                       the tool leaves the axis (LinuxCNC), 0: it leaves it at the top (Fanuc).
///   canned_bore_manual  (G88) dwell_bottom; spindle stop, program stop, spindle start. LinuxCNC writes no move for
///                       the operator's retraction and takes the tool to be at the end afterwards. manual_retract 1:
///                       a rapid move to the retract plane stands for it, after the spindle start one to the end.
/// spindle_direction: how the spindle turns afterwards; not written: as before, and it must turn.

#include <algorithm>
#include <cmath>

#include "cycles/hole/canned.hpp"
#include "cycles/hole/families.hpp"

namespace obrys::cycles {

namespace {

/// The tool stands in a known direction: the shift goes by it. Not said: the machine knows the angle.
void orient(Course& c, const Turning& t, const Said& angle = {}) {
    c.add(cl::Spindle{.speed = t.speed, .direction = 0, .held = angle.value_or(NAN)});
}

void in_plane(Course& c, geom::Vec2 to) { c.straight({to.x, to.y, c.at().z}, true); }

/// The heights of a back bore, which need no retract plane.
Hole hole_of_back_bore(Course& c, const BackBoring& d, const Situation& s) {
    if (d.retract_plane) {
        HolePlanes planes;
        planes.target_u = d.target_u, planes.target_v = d.target_v;
        planes.retract_plane = *d.retract_plane, planes.bottom = d.bottom;
        planes.return_level = d.return_level, planes.rise_first = d.rise_first;
        return hole_of(c, planes, s);
    }
    Hole h;
    h.target = target_of(c, d.target_u, d.target_v, s);
    h.bottom = d.bottom;
    h.end = c.known(d.return_level.value_or(s.at.z), "the height where the cycle ends");
    return h;
}

}  // namespace

void write_steps(Course& c, const FeedBoring& d, const Situation& s) {
    const Hole h = hole_of(c, d, s);
    if (!c.ready()) return;
    approach(c, h);
    feed_of(c, d.feed_plunge);
    feed_w(c, h.bottom);
    dwell_if(c, d.dwell_bottom);
    feed_of(c, d.feed_retract);
    feed_out(c, h, d.feed_out.value_or(0) != 0);
}

void write_steps(Course& c, const StopBoring& d, const Situation& s) {
    const Hole h = hole_of(c, d, s);
    const Turning t = turning_of(c, d.spindle_speed, d.spindle_direction, s);
    if (!c.ready()) return;
    approach(c, h);
    begin_turning(c, d.starts_spindle, s, t);
    feed_w(c, h.bottom);
    dwell_if(c, d.dwell_bottom);
    stop_spindle(c, t);
    if (d.stops_program.value_or(0) == 1) c.add(cl::Stop{cl::StopKind::program});
    rapid_to_w(c, h.end);
    end_turning(c, d.spindle_after, t);
}

void write_steps(Course& c, const OrientedBoring& d, const Situation& s) {
    const Hole h = hole_of(c, d, s);
    const Turning t = turning_of(c, d.spindle_speed, d.spindle_direction, s);
    if (!c.ready()) return;
    approach(c, h);
    begin_turning(c, d.starts_spindle, s, t);
    feed_w(c, h.bottom);
    dwell_if(c, d.dwell_bottom);
    orient(c, t, d.spindle_angle);
    const geom::Vec2 beside = h.target + geom::Vec2{d.shift_u, d.shift_v};
    c.straight({beside.x, beside.y, h.bottom + d.shift_w.value_or(0)}, true);
    rapid_to_w(c, h.end);
    in_plane(c, h.target);
    end_turning(c, d.spindle_after, t);
}

void write_steps(Course& c, const BackBoring& d, const Situation& s) {
    const Hole h = hole_of_back_bore(c, d, s);
    const geom::Vec2 beside = h.target + geom::Vec2{d.shift_u, d.shift_v};
    const Turning t = turning_of(c, d.spindle_speed, d.spindle_direction, s);
    if (!c.ready()) return;
    if (d.retract_plane) {
        approach(c, h);
        in_plane(c, beside);
        orient(c, t);
    } else {
        in_plane(c, h.target);
        c.over_place();
        orient(c, t);
        in_plane(c, beside);
    }
    rapid_to_w(c, h.bottom);
    in_plane(c, h.target);
    start_spindle(c, t);
    feed_w(c, d.counterbore_top);
    dwell_if(c, d.dwell);
    if (d.feed_out.value_or(0) != 0) feed_w(c, h.bottom);
    orient(c, t);
    in_plane(c, beside);
    rapid_to_w(c, h.end);
    in_plane(c, h.target);
    start_spindle(c, t);
}

void write_steps(Course& c, const ManualBoring& d, const Situation& s) {
    const Hole h = hole_of(c, d, s);
    const Turning t = turning_of(c, d.spindle_speed, d.spindle_direction, s);
    const bool with_move = d.manual_retract.value_or(0) != 0;
    if (!c.ready()) return;
    approach(c, h);
    feed_w(c, h.bottom);
    dwell_if(c, d.dwell_bottom);
    stop_spindle(c, t);
    c.add(cl::Stop{cl::StopKind::program});
    if (with_move) {
        c.assume("the operator takes the tool straight out to the retract plane");
        rapid_to_w(c, h.retract);
    }
    start_spindle(c, t);
    if (with_move) rapid_to_w(c, h.end);
}

}  // namespace obrys::cycles
