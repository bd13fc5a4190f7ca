/// Drilling. Source: HEIDENHAIN iTNC 530 cycle programming, chapter on drilling cycles (1, 200, 203, 205, 240, 241);
/// the advanced stop distance of the old pecking cycle: TNC 407 ISO programming, 8.2, and TNC 370, 8.2.

#include <algorithm>
#include <cmath>
#include <optional>

#include "base/whole.hpp"
#include "cycles/hole/families.hpp"
#include "cycles/levels.hpp"

namespace obrys::cycles {

namespace {

/// How much deeper the point must go so that the full diameter reaches the depth.
double point_length(Course& c, const Said& depth_reference, const Situation& s) {
    if (depth_reference.value_or(0) == 0) return 0;
    const double radius = c.tool_radius(s);
    const double angle = c.known(s.tool_point_angle, "the tool's point angle");
    if (angle <= 0 || angle > 180) c.fault("the tool's point angle must be above 0 and up to 180 degrees");
    return radius / std::tan(geom::radians(angle / 2));
}

/// To a start below the surface, at the feed that this gives back; 0 where the cycle begins at the surface.
template <class Cycle>
double feed_to_start(Course& c, const Cycle& d, double hole) {
    const double deepened = d.deepened_start.value_or(0);
    if (deepened > hole) c.fault(Role::deepened_start, "the deepened starting point lies below the depth");
    return deepened > 0 ? asked(c, d, &Cycle::feed_position, Must::be_feed) : 0;
}

/// Depth at which a point of this angle has the wanted diameter.
double centring_depth(Course& c, const Centring& d, const Situation& s) {
    const double diameter = std::abs(asked(c, d, &Centring::diameter, Must::be_known));  // the manual: negative
    const double angle = c.known(s.tool_point_angle, "the tool's point angle (T-ANGLE)");
    const double radius = c.tool_radius(s);
    if (angle <= 0 || angle >= 180) c.fault("the tool's point angle must lie between 0 and 180 degrees");
    if (diameter > 2 * radius) c.fault(Role::diameter, "the centring diameter is larger than the tool");
    if (diameter == 0) c.fault(Role::diameter, "the centring diameter must not be 0");
    return -diameter / 2 / std::tan(geom::radians(angle / 2));
}

void machine_function(Course& c, double number) {
    if (number == 8)
        c.add(cl::Coolant{true, false});
    else if (number == 9)
        c.add(cl::Coolant{});
    else if (number == 7)
        c.add(cl::Coolant{false, true});
    else if (const auto m = base::whole<std::int64_t>(number, 0, 99'999))
        c.add(cl::Auxiliary{'M', *m});
    else
        c.fault("the number of an M function must be a whole number from 0 to 99999");
}

}  // namespace

/// Old form: the tool stands at the clearance, which it also retracts to.
void write_steps(Course& c, const OldPecking& d, const Situation& s) {
    const double top = c.known(s.at.z, "the tool's height");
    const double surface = top - std::abs(d.clearance);  // older programs write it with the depth's sign
    const double feed = c.feed_in_force_or(d.feed_plunge, Role::feed_plunge, s.feed);
    if (!c.ready()) return;
    const double stop = std::min(7.0, std::max(0.6, -d.depth / 50));
    const double bottom = surface + d.depth;
    for (const double level : levels_of(c, surface, bottom, {.first = std::abs(d.infeed)})) {
        c.move_w(level, feed);
        if (level == bottom) c.dwell(d.dwell.value_or(0));
        c.rapid_w(top);
        if (level != bottom) c.rapid_w(std::min(top, level + stop));
    }
}

void write_steps(Course& c, const DepthDrilling& d, const Situation& s) {
    Heights h = heights_of(d);
    h.bottom -= point_length(c, d.depth_reference, s);
    if (!c.ready()) return;
    const auto levels = levels_of(c, h.surface, h.bottom, {.first = d.infeed});
    if (!c.ready()) return;
    c.rapid_w(h.clearance);
    for (const double level : levels) {
        c.move_w(level, d.feed_plunge);
        if (level == h.bottom) break;
        c.rapid_w(h.clearance);
        c.dwell(d.dwell_top.value_or(0));
        c.rapid_w(level + (h.clearance - h.surface));
    }
    c.dwell(d.dwell_bottom.value_or(0));
    c.rapid_w(h.end);
}

void write_steps(Course& c, const UniversalDrilling& d, const Situation& s) {
    Heights h = heights_of(d);
    h.bottom -= point_length(c, d.depth_reference, s);
    const double back = unless_0(d.feed_retract, d.feed_plunge);
    if (!c.ready()) return;
    const auto levels =
        levels_of(c, h.surface, h.bottom, {d.infeed, d.decrement.value_or(0), d.min_infeed.value_or(0)});
    if (!c.ready()) return;
    c.rapid_w(h.clearance);
    double made = 0;
    for (const double level : levels) {
        c.move_w(level, d.feed_plunge);
        if (level == h.bottom) break;
        if (made < d.breaks_before_retract.value_or(0)) {
            made += 1;
            c.move_w(std::min(level + d.chip_break_distance.value_or(0), h.clearance), chip_break_feed);
            continue;
        }
        made = 0;
        c.move_w(h.clearance, back);
        c.dwell(d.dwell_top.value_or(0));
        c.rapid_w(level + (h.clearance - h.surface));
    }
    c.dwell(d.dwell_bottom.value_or(0));
    c.move_w(h.clearance, back);
    c.rapid_w(h.end);
}

void write_steps(Course& c, const UniversalPecking& d, const Situation& s) {
    Heights h = heights_of(d);
    h.bottom -= point_length(c, d.depth_reference, s);
    const double every = d.chip_break_depth.value_or(0), first_stop = d.stop_distance_first.value_or(0);
    check_breaks(c, every, h.surface - h.bottom);
    const double deepened = d.deepened_start.value_or(0);
    const double approach = feed_to_start(c, d, h.surface - h.bottom);
    if (!c.ready()) return;
    const double top = h.surface - deepened;
    const auto levels = levels_of(c, top, h.bottom, {d.infeed, d.decrement.value_or(0), d.min_infeed.value_or(0)});
    if (!c.ready()) return;
    c.rapid_w(h.clearance);
    if (deepened > 0) c.move_w(top + (h.clearance - h.surface), approach);
    peck_down(c, levels,
              {.top = top,
               .retract_to = h.clearance,
               .first_stop = first_stop,
               .last_stop = d.stop_distance_last.value_or(first_stop),
               .break_every = every,
               .break_distance = d.chip_break_distance.value_or(0),
               .feed = d.feed_plunge});
    c.dwell(d.dwell_bottom.value_or(0));
    c.move_w(h.clearance, unless_0(d.feed_retract, std::numeric_limits<double>::infinity()));
    c.rapid_w(h.end);
}

void write_steps(Course& c, const Centring& d, const Situation& s) {
    const double depth =
        d.centre_by_diameter.value_or(0) != 0 ? centring_depth(c, d, s) : asked(c, d, &Centring::depth, Must::go_deep);
    if (!c.ready()) return;
    c.rapid_w(d.surface + d.clearance);
    c.move_w(d.surface + depth, d.feed_plunge);
    c.dwell(d.dwell_bottom.value_or(0));
    c.rapid_w(d.surface + std::max(d.clearance, d.second_clearance.value_or(0)));
}

void write_steps(Course& c, const SingleLipDrilling& d, const Situation& s) {
    const Heights h = heights_of(d);
    const double deepened = d.deepened_start.value_or(0);
    const double approach = feed_to_start(c, d, h.surface - h.bottom);
    const double way = d.spindle_direction.value_or(s.spindle_direction < 0 ? 4 : 3);
    const double slow = d.spindle_speed_position.value_or(0);
    const double fast = d.spindle_speed ? *d.spindle_speed : c.spindle_speed(s);
    const double on = d.coolant_on.value_or(8), off = d.coolant_off.value_or(9);
    if (way != 3 && way != 4 && way != 5) c.fault(Role::spindle_direction, "the spindle direction must be 3, 4 or 5");
    if (on > 999 || off > 999) c.fault(Role::coolant_on, "an M function has at most three digits");
    if (!c.ready()) return;
    const int turning = way == 4 ? -1 : 1, entering = way == 5 ? 0 : turning;
    c.rapid_w(h.clearance);
    c.spindle(slow, slow > 0 ? entering : 0);
    if (deepened > 0) c.move_w(h.clearance - deepened, approach);
    c.spindle(fast, turning);
    machine_function(c, on);
    c.move_w(h.bottom, d.feed_plunge);
    c.dwell(d.dwell_bottom.value_or(0));
    machine_function(c, off);
    c.spindle(slow, slow > 0 ? entering : 0);
    c.move_w(h.clearance, unless_0(d.feed_retract, d.feed_plunge));
    c.rapid_w(h.end);
}

}  // namespace obrys::cycles
