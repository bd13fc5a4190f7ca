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

namespace obrys::cycles {

namespace {

void bore_feed(Course& c, const Demand& demand, const Situation& s) {
    const Hole h = read_hole(c, s);
    c.maybe_at_least(Role::dwell_bottom, 0, 0);
    const bool whole_way = c.maybe(Role::feed_out, 0) != 0;
    for (const Role role : {Role::feed_plunge, Role::feed_retract})
        if (demand.find(role)) c.positive(role);
    if (!c.ready()) return;
    approach(c, h);
    feed_of(c, demand, Role::feed_plunge);
    feed_w(c, h.bottom);
    dwell_if(c, demand, Role::dwell_bottom);
    feed_of(c, demand, Role::feed_retract);
    feed_out(c, h, whole_way);
}

void bore_stop(Course& c, const Demand& demand, const Situation& s) {
    const Hole h = read_hole(c, s);
    const Turning t = read_turning(c, s);
    c.maybe_at_least(Role::dwell_bottom, 0, 0);
    if (!c.ready()) return;
    approach(c, h);
    begin_turning(c, demand, s, t);
    feed_w(c, h.bottom);
    dwell_if(c, demand, Role::dwell_bottom);
    stop_spindle(c, t);
    if (demand.get(Role::stops_program, 0) == 1) c.add(cl::Stop{cl::StopKind::program});
    rapid_to_w(c, h.end);
    end_turning(c, demand, t);
}

geom::Vec2 read_shift(Course& c) { return {c.need(Role::shift_u), c.need(Role::shift_v)}; }

/// The tool stands in a known direction: the shift goes by it. NaN: the machine knows the angle.
void orient(Course& c, const Turning& t, double angle = NAN) {
    c.add(cl::Spindle{.speed = t.speed, .direction = 0, .held = angle});
}

void in_plane(Course& c, geom::Vec2 to) { c.straight({to.x, to.y, c.at().z}, true); }

void bore_orient(Course& c, const Demand& demand, const Situation& s) {
    const Hole h = read_hole(c, s);
    const Turning t = read_turning(c, s);
    const geom::Vec2 shift = read_shift(c);
    c.maybe_at_least(Role::dwell_bottom, 0, 0);
    const double lift = c.maybe(Role::shift_w, 0);
    const auto angle = demand.find(Role::spindle_angle);
    if (!c.ready()) return;
    approach(c, h);
    begin_turning(c, demand, s, t);
    feed_w(c, h.bottom);
    dwell_if(c, demand, Role::dwell_bottom);
    orient(c, t, angle.value_or(NAN));
    const geom::Vec2 beside = h.target + shift;
    c.straight({beside.x, beside.y, h.bottom + lift}, true);
    rapid_to_w(c, h.end);
    in_plane(c, h.target);
    end_turning(c, demand, t);
}

struct BackBore {
    Hole hole;
    bool by_retract_plane = false, feed_back = false;
    double top = 0;
    geom::Vec2 beside;
};

BackBore read_back_bore(Course& c, const Demand& demand, const Situation& s) {
    BackBore b;
    b.by_retract_plane = demand.find(Role::retract_plane).has_value();
    if (b.by_retract_plane) {
        b.hole = read_hole(c, s);
    } else {
        b.hole.target = read_target(c, s);
        b.hole.bottom = c.need(Role::bottom);
        b.hole.end = c.maybe(Role::return_level, s.at.z);
        c.known(b.hole.end, "the height where the cycle ends");
    }
    b.top = c.need(Role::counterbore_top);
    b.beside = b.hole.target + read_shift(c);
    b.feed_back = c.maybe(Role::feed_out, 0) != 0;
    return b;
}

void back_bore(Course& c, const Demand& demand, const Situation& s) {
    const BackBore b = read_back_bore(c, demand, s);
    const Turning t = read_turning(c, s);
    c.maybe_at_least(Role::dwell, 0, 0);
    if (!c.ready()) return;
    if (b.by_retract_plane) {
        approach(c, b.hole);
        in_plane(c, b.beside);
        orient(c, t);
    } else {
        in_plane(c, b.hole.target);
        c.over_place();
        orient(c, t);
        in_plane(c, b.beside);
    }
    rapid_to_w(c, b.hole.bottom);
    in_plane(c, b.hole.target);
    start_spindle(c, t);
    feed_w(c, b.top);
    dwell_if(c, demand, Role::dwell);
    if (b.feed_back) feed_w(c, b.hole.bottom);
    orient(c, t);
    in_plane(c, b.beside);
    rapid_to_w(c, b.hole.end);
    in_plane(c, b.hole.target);
    start_spindle(c, t);
}

void bore_manual(Course& c, const Demand& demand, const Situation& s) {
    const Hole h = read_hole(c, s);
    const Turning t = read_turning(c, s);
    const bool with_move = c.maybe(Role::manual_retract, 0) != 0;
    c.maybe_at_least(Role::dwell_bottom, 0, 0);
    if (!c.ready()) return;
    approach(c, h);
    feed_w(c, h.bottom);
    dwell_if(c, demand, Role::dwell_bottom);
    stop_spindle(c, t);
    c.add(cl::Stop{cl::StopKind::program});
    if (with_move) {
        c.assume("the operator takes the tool straight out to the retract plane");
        rapid_to_w(c, h.retract);
    }
    start_spindle(c, t);
    if (with_move) rapid_to_w(c, h.end);
}

}  // namespace

void canned_bore(Course& c, const Demand& demand, const Situation& s) {
    switch (demand.kind) {
        case Kind::canned_bore_stop: return bore_stop(c, demand, s);
        case Kind::canned_bore_orient: return bore_orient(c, demand, s);
        case Kind::canned_back_bore: return back_bore(c, demand, s);
        case Kind::canned_bore_manual: return bore_manual(c, demand, s);
        default: return bore_feed(c, demand, s);
    }
}

}  // namespace obrys::cycles
