/// Reaming, boring, back boring, bore milling. Source: HEIDENHAIN iTNC 530 cycle programming, chapter on drilling
/// cycles (201, 202, 204, 208). Not stated there and chosen here: the side of the bore-milling approach (u+), and that
/// the tool ends above the hole's centre after a sideways disengagement, as later controls do.

#include <algorithm>
#include <cmath>

#include "cycles/hole/families.hpp"

namespace obrys::cycles {

namespace {

constexpr double disengagement = 0.2;  ///< mm, cycle 202

void ream(Course& c) {
    const Heights h = read_heights(c);
    const double feed = c.feed(Role::feed_plunge);
    const double back = c.feed_or(Role::feed_retract, feed);
    const double dwell = c.maybe_at_least(Role::dwell_bottom, 0, 0);
    if (!c.ready()) return;
    c.rapid_w(h.clearance);
    c.move_w(h.bottom, feed);
    c.dwell(dwell);
    c.move_w(h.clearance, back);
    c.rapid_w(h.end);
}

/// Unit vector of a disengaging direction, zero for 0.
geom::Vec3 direction_of(Course& c, double least) {
    const double d = c.need(Role::retract_direction);
    if (d == 1) return {-1, 0, 0};
    if (d == 2) return {0, -1, 0};
    if (d == 3) return {1, 0, 0};
    if (d == 4) return {0, 1, 0};
    if (d != 0 || least > 0) c.fault(Role::retract_direction, "the disengaging direction must be 1, 2, 3 or 4");
    return {};
}

/// The bar stands in a known direction: the way out goes by it. Degrees of the spindle; NaN: where the machine is set
/// to.
void orient_bar(Course& c, double angle) { c.add(cl::Spindle{.speed = 0, .direction = 0, .held = angle}); }

void turn_again(Course& c, const Situation& s) {
    if (s.spindle_direction != 0 && std::isfinite(s.spindle_speed)) c.spindle(s.spindle_speed, s.spindle_direction);
}

void bore(Course& c, const Situation& s) {
    const Heights h = read_heights(c);
    const double feed = c.feed(Role::feed_plunge);
    const double back = c.feed_or(Role::feed_retract, feed);
    const double dwell = c.maybe_at_least(Role::dwell_bottom, 0, 0);
    const geom::Vec3 away = direction_of(c, 0);
    const double angle = c.maybe(Role::spindle_angle, NAN);
    c.spindle_speed(s);
    if (!c.ready()) return;
    c.rapid_w(h.clearance);
    const geom::Vec3 axis = c.at();
    c.move_w(h.bottom, feed);
    c.dwell(dwell);
    orient_bar(c, angle);
    c.move(c.at() + disengagement * away, back);
    c.move_w(h.clearance, back);
    c.rapid_w(h.end);
    c.rapid({axis.x, axis.y, h.end});
    turn_again(c, s);
}

void back_bore(Course& c, const Situation& s) {
    const double surface = c.need(Role::surface), clearance = c.at_least(Role::clearance, 0);
    const double end = surface + std::max(clearance, c.maybe_at_least(Role::second_clearance, 0, 0));
    const double depth = c.need(Role::counterbore_depth), thickness = c.positive(Role::thickness);
    const double off = c.positive(Role::off_centre), edge = c.at_least(Role::edge_height, 0);
    const double positioning = c.feed(Role::feed_position), boring = c.feed(Role::feed_countersink);
    const double dwell = c.maybe_at_least(Role::dwell, 0, 0);
    const geom::Vec3 away = direction_of(c, 1);
    const double angle = c.maybe(Role::spindle_angle, NAN);
    c.spindle_speed(s);
    if (depth < 0) c.fault(Role::counterbore_depth, "enter the depth of counterbore as a positive value");
    if (depth > thickness) c.fault(Role::counterbore_depth, "the counterbore is deeper than the material is thick");
    if (depth == 0) return c.not_executed(Role::counterbore_depth);
    if (!c.ready()) return;
    // The programmed length is the bar's underside: the edge cuts `edge` above it.
    const double below = surface - thickness - clearance - edge;
    c.rapid_w(surface + clearance);
    const geom::Vec3 axis = c.at();
    orient_bar(c, angle);
    c.move(axis + off * away, positioning);
    c.move_w(below, positioning);
    c.move({axis.x, axis.y, below}, positioning);
    turn_again(c, s);
    c.move_w(surface - thickness + depth - edge, boring);
    c.dwell(dwell);
    c.move_w(below, positioning);
    orient_bar(c, angle);
    c.move(c.at() + off * away, positioning);
    c.move_w(surface + clearance, positioning);
    c.rapid_w(end);
    c.rapid({axis.x, axis.y, end});
    turn_again(c, s);
}

void bore_mill(Course& c, const Situation& s) {
    const Heights h = read_heights(c);
    const double feed = c.feed(Role::feed_plunge);
    const double per_turn = c.positive(Role::infeed_per_turn);
    const double diameter = c.positive(Role::diameter);
    const double predrilled = c.maybe_at_least(Role::predrilled_diameter, 0, 0);
    const double sense = c.maybe(Role::direction, 1) < 0 ? -1 : 1;  // inside a hole climb is counter-clockwise with M3
    const double radius = diameter / 2 - c.tool_radius(s);
    if (radius < -1e-9) c.fault(Role::diameter, "tool radius too large: the hole is smaller than the tool");
    if (predrilled == 0 && radius > s.tool_radius + 1e-9)
        c.fault(Role::diameter, "the hole is larger than twice the tool and not roughed out: a core would stay",
                "take a larger tool or enter the roughed-out diameter");
    const double turns = (h.clearance - h.bottom) / per_turn;
    if (turns > most_helix_turns) c.fault(Role::infeed_per_turn, "the infeed per helix is too small for the depth");
    if (!c.ready()) return;
    c.rapid_w(h.clearance);
    const geom::Vec2 centre{c.at().x, c.at().y};
    if (radius <= 1e-9) {
        c.move_w(h.bottom, feed);
    } else {
        c.arc(centre + geom::Vec2{radius / 2, 0}, sense * geom::pi, h.clearance, feed);
        c.arc(centre, sense * turns * 2 * geom::pi, h.bottom, feed);
        c.arc(centre, sense * 2 * geom::pi, h.bottom, feed);
        c.move({centre.x, centre.y, h.bottom}, feed);
    }
    c.rapid_w(h.end);
}

}  // namespace

void expand_bore(Course& c, const Demand& demand, const Situation& situation) {
    switch (demand.kind) {
        case Kind::bore: return bore(c, situation);
        case Kind::back_bore: return back_bore(c, situation);
        case Kind::bore_mill: return bore_mill(c, situation);
        default: return ream(c);
    }
}

}  // namespace obrys::cycles
