/// Reaming, boring, back boring, bore milling. Source: HEIDENHAIN iTNC 530 cycle programming, chapter on drilling
/// cycles (201, 202, 204, 208). Not stated there and chosen here: the side of the bore-milling approach (u+), and that
/// the tool ends above the hole's centre after a sideways disengagement, as later controls do.

#include <algorithm>
#include <cmath>

#include "cycles/hole/families.hpp"

namespace obrys::cycles {

namespace {

constexpr double disengagement = 0.2;  ///< mm, cycle 202

/// Unit vector of a disengaging direction, zero for 0.
geom::Vec3 direction_of(Course& c, double d, double least) {
    if (d == 1) return {-1, 0, 0};
    if (d == 2) return {0, -1, 0};
    if (d == 3) return {1, 0, 0};
    if (d == 4) return {0, 1, 0};
    if (d != 0 || least > 0) c.fault(Role::retract_direction, "the disengaging direction must be 1, 2, 3 or 4");
    return {};
}

/// The bar stands in a known direction: the way out goes by it. Degrees of the spindle; not said: where the machine is
/// set to.
void orient_bar(Course& c, const Said& angle) {
    c.add(cl::Spindle{.speed = 0, .direction = 0, .held = angle.value_or(NAN)});
}

void turn_again(Course& c, const Situation& s) {
    if (s.spindle_direction != 0 && std::isfinite(s.spindle_speed)) c.spindle(s.spindle_speed, s.spindle_direction);
}

}  // namespace

void write_steps(Course& c, const Reaming& d, const Situation&) {
    const Heights h = heights_of(d);
    if (!c.ready()) return;
    c.rapid_w(h.clearance);
    c.move_w(h.bottom, d.feed_plunge);
    c.dwell(d.dwell_bottom.value_or(0));
    c.move_w(h.clearance, unless_0(d.feed_retract, d.feed_plunge));
    c.rapid_w(h.end);
}

void write_steps(Course& c, const DepthBoring& d, const Situation& s) {
    const Heights h = heights_of(d);
    const double back = unless_0(d.feed_retract, d.feed_plunge);
    const geom::Vec3 away = direction_of(c, d.retract_direction, 0);
    c.spindle_speed(s);
    if (!c.ready()) return;
    c.rapid_w(h.clearance);
    const geom::Vec3 axis = c.at();
    c.move_w(h.bottom, d.feed_plunge);
    c.dwell(d.dwell_bottom.value_or(0));
    orient_bar(c, d.spindle_angle);
    c.move(c.at() + disengagement * away, back);
    c.move_w(h.clearance, back);
    c.rapid_w(h.end);
    c.rapid({axis.x, axis.y, h.end});
    turn_again(c, s);
}

void write_steps(Course& c, const Counterboring& d, const Situation& s) {
    const double above = d.surface + d.clearance;
    const double end = d.surface + std::max(d.clearance, d.second_clearance.value_or(0));
    const geom::Vec3 away = direction_of(c, d.retract_direction, 1);
    c.spindle_speed(s);
    if (d.counterbore_depth < 0) c.fault(Role::counterbore_depth, "enter the depth of counterbore as a positive value");
    if (d.counterbore_depth > d.thickness)
        c.fault(Role::counterbore_depth, "the counterbore is deeper than the material is thick");
    if (d.counterbore_depth == 0) return c.not_executed(Role::counterbore_depth);
    if (!c.ready()) return;
    // The programmed length is the bar's underside: the edge cuts that much above it.
    const double below = d.surface - d.thickness - d.clearance - d.edge_height;
    c.rapid_w(above);
    const geom::Vec3 axis = c.at();
    orient_bar(c, d.spindle_angle);
    c.move(axis + d.off_centre * away, d.feed_position);
    c.move_w(below, d.feed_position);
    c.move({axis.x, axis.y, below}, d.feed_position);
    turn_again(c, s);
    c.move_w(d.surface - d.thickness + d.counterbore_depth - d.edge_height, d.feed_countersink);
    c.dwell(d.dwell.value_or(0));
    c.move_w(below, d.feed_position);
    orient_bar(c, d.spindle_angle);
    c.move(c.at() + d.off_centre * away, d.feed_position);
    c.move_w(above, d.feed_position);
    c.rapid_w(end);
    c.rapid({axis.x, axis.y, end});
    turn_again(c, s);
}

void write_steps(Course& c, const BoreMilling& d, const Situation& s) {
    const Heights h = heights_of(d);
    const double sense = d.direction.value_or(1) < 0 ? -1 : 1;  // inside a hole climb is counter-clockwise with M3
    const double radius = d.diameter / 2 - c.tool_radius(s);
    if (radius < -1e-9) c.fault(Role::diameter, "tool radius too large: the hole is smaller than the tool");
    if (d.predrilled_diameter.value_or(0) == 0 && radius > s.tool_radius + 1e-9)
        c.fault(Role::diameter, "the hole is larger than twice the tool and not roughed out: a core would stay",
                "take a larger tool or enter the roughed-out diameter");
    const double turns = (h.clearance - h.bottom) / d.infeed_per_turn;
    if (turns > most_helix_turns) c.fault(Role::infeed_per_turn, "the infeed per helix is too small for the depth");
    if (!c.ready()) return;
    c.rapid_w(h.clearance);
    const geom::Vec2 centre{c.at().x, c.at().y};
    if (radius <= 1e-9) {
        c.move_w(h.bottom, d.feed_plunge);
    } else {
        c.arc(centre + geom::Vec2{radius / 2, 0}, sense * geom::pi, h.clearance, d.feed_plunge);
        c.arc(centre, sense * turns * 2 * geom::pi, h.bottom, d.feed_plunge);
        c.arc(centre, sense * 2 * geom::pi, h.bottom, d.feed_plunge);
        c.move({centre.x, centre.y, h.bottom}, d.feed_plunge);
    }
    c.rapid_w(h.end);
}

}  // namespace obrys::cycles
