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
double point_length(Course& c, const Situation& s) {
    if (c.maybe(Role::depth_reference, 0) == 0) return 0;
    const double radius = c.tool_radius(s);
    const double angle = c.known(s.tool_point_angle, "the tool's point angle");
    if (angle <= 0 || angle > 180) c.fault("the tool's point angle must be above 0 and up to 180 degrees");
    return radius / std::tan(geom::radians(angle / 2));
}

/// Old form: the tool stands at the clearance, which it also retracts to.
void peck(Course& c, const Situation& s) {
    const double top = c.known(s.at.z, "the tool's height");
    const double surface = top - std::abs(c.need(Role::clearance));  // older programs write it with the depth's sign
    const double depth = c.depth();
    const double infeed = std::abs(c.need(Role::infeed));
    const double dwell = c.maybe_at_least(Role::dwell, 0, 0);
    const double feed = c.feed_or_programmed(Role::feed_plunge, s.feed);
    if (infeed == 0) c.fault(Role::infeed, "the plunging depth must not be 0");
    if (!c.ready()) return;
    const double stop = std::min(7.0, std::max(0.6, -depth / 50));
    const double bottom = surface + depth;
    for (const double level : levels_of(c, surface, bottom, {.first = infeed})) {
        c.move_w(level, feed);
        if (level == bottom) c.dwell(dwell);
        c.rapid_w(top);
        if (level != bottom) c.rapid_w(std::min(top, level + stop));
    }
}

void drill(Course& c, const Situation& s) {
    Heights h = read_heights(c);
    h.bottom -= point_length(c, s);
    const Infeeds infeeds = read_infeeds(c, false);
    const double feed = c.feed(Role::feed_plunge);
    const double top_dwell = c.maybe_at_least(Role::dwell_top, 0, 0);
    const double bottom_dwell = c.maybe_at_least(Role::dwell_bottom, 0, 0);
    if (!c.ready()) return;
    const auto levels = levels_of(c, h.surface, h.bottom, infeeds);
    if (!c.ready()) return;
    c.rapid_w(h.clearance);
    for (const double level : levels) {
        c.move_w(level, feed);
        if (level == h.bottom) break;
        c.rapid_w(h.clearance);
        c.dwell(top_dwell);
        c.rapid_w(level + (h.clearance - h.surface));
    }
    c.dwell(bottom_dwell);
    c.rapid_w(h.end);
}

void universal_drill(Course& c, const Situation& s) {
    Heights h = read_heights(c);
    h.bottom -= point_length(c, s);
    const Infeeds infeeds = read_infeeds(c, true);
    const double feed = c.feed(Role::feed_plunge);
    const double back = c.feed_or(Role::feed_retract, feed);
    const double breaks = c.maybe_at_least(Role::breaks_before_retract, 0, 0);
    const double break_distance = c.maybe_at_least(Role::chip_break_distance, 0, 0);
    const double top_dwell = c.maybe_at_least(Role::dwell_top, 0, 0);
    const double bottom_dwell = c.maybe_at_least(Role::dwell_bottom, 0, 0);
    if (!c.ready()) return;
    const auto levels = levels_of(c, h.surface, h.bottom, infeeds);
    if (!c.ready()) return;
    c.rapid_w(h.clearance);
    double made = 0;
    for (const double level : levels) {
        c.move_w(level, feed);
        if (level == h.bottom) break;
        if (made < breaks) {
            made += 1;
            c.move_w(std::min(level + break_distance, h.clearance), chip_break_feed);
            continue;
        }
        made = 0;
        c.move_w(h.clearance, back);
        c.dwell(top_dwell);
        c.rapid_w(level + (h.clearance - h.surface));
    }
    c.dwell(bottom_dwell);
    c.move_w(h.clearance, back);
    c.rapid_w(h.end);
}

void universal_peck(Course& c, const Situation& s) {
    Heights h = read_heights(c);
    h.bottom -= point_length(c, s);
    const Infeeds infeeds = read_infeeds(c, true);
    const double feed = c.feed(Role::feed_plunge);
    const double first_stop = c.maybe_at_least(Role::stop_distance_first, 0, 0);
    const double last_stop = c.maybe_at_least(Role::stop_distance_last, 0, first_stop);
    const double every = read_break_depth(c, h.surface - h.bottom);
    const double distance = c.maybe_at_least(Role::chip_break_distance, 0, 0);
    const double bottom_dwell = c.maybe_at_least(Role::dwell_bottom, 0, 0);
    const double deepened = c.maybe_at_least(Role::deepened_start, 0, 0);
    const double approach = deepened > 0 ? c.feed(Role::feed_position) : 0;
    const double back = c.feed_or(Role::feed_retract, std::numeric_limits<double>::infinity());
    if (deepened > h.surface - h.bottom)
        c.fault(Role::deepened_start, "the deepened starting point lies below the depth");
    if (!c.ready()) return;
    const double top = h.surface - deepened;
    const auto levels = levels_of(c, top, h.bottom, infeeds);
    if (!c.ready()) return;
    c.rapid_w(h.clearance);
    if (deepened > 0) c.move_w(top + (h.clearance - h.surface), approach);
    peck_down(c, levels,
              {.top = top,
               .retract_to = h.clearance,
               .first_stop = first_stop,
               .last_stop = last_stop,
               .break_every = every,
               .break_distance = distance,
               .feed = feed});
    c.dwell(bottom_dwell);
    c.move_w(h.clearance, back);
    c.rapid_w(h.end);
}

/// Depth at which a point of this angle has the wanted diameter.
double centring_depth(Course& c, const Situation& s) {
    const double diameter = std::abs(c.need(Role::diameter));  // the manual writes it negative
    const double angle = c.known(s.tool_point_angle, "the tool's point angle (T-ANGLE)");
    const double radius = c.tool_radius(s);
    if (angle <= 0 || angle >= 180) c.fault("the tool's point angle must lie between 0 and 180 degrees");
    if (diameter > 2 * radius) c.fault(Role::diameter, "the centring diameter is larger than the tool");
    if (diameter == 0) c.fault(Role::diameter, "the centring diameter must not be 0");
    return -diameter / 2 / std::tan(geom::radians(angle / 2));
}

void centre(Course& c, const Situation& s) {
    const double surface = c.need(Role::surface), clearance = c.at_least(Role::clearance, 0);
    const double depth = c.maybe(Role::centre_by_diameter, 0) != 0 ? centring_depth(c, s) : c.depth();
    const double second = c.maybe_at_least(Role::second_clearance, 0, 0);
    const double feed = c.feed(Role::feed_plunge);
    const double dwell = c.maybe_at_least(Role::dwell_bottom, 0, 0);
    if (!c.ready()) return;
    c.rapid_w(surface + clearance);
    c.move_w(surface + depth, feed);
    c.dwell(dwell);
    c.rapid_w(surface + std::max(clearance, second));
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

void single_lip(Course& c, const Demand& d, const Situation& s) {
    const Heights h = read_heights(c);
    const double feed = c.feed(Role::feed_plunge);
    const double back = c.feed_or(Role::feed_retract, feed);
    const double dwell = c.maybe_at_least(Role::dwell_bottom, 0, 0);
    const double deepened = c.maybe_at_least(Role::deepened_start, 0, 0);
    const double approach = deepened > 0 ? c.feed(Role::feed_position) : 0;
    const double way = c.maybe(Role::spindle_direction, s.spindle_direction < 0 ? 4 : 3);
    const double slow = c.maybe_at_least(Role::spindle_speed_position, 0, 0);
    const double fast = d.find(Role::spindle_speed) ? c.at_least(Role::spindle_speed, 0) : c.spindle_speed(s);
    const double on = c.maybe_at_least(Role::coolant_on, 0, 8), off = c.maybe_at_least(Role::coolant_off, 0, 9);
    if (way != 3 && way != 4 && way != 5) c.fault(Role::spindle_direction, "the spindle direction must be 3, 4 or 5");
    if (deepened > h.surface - h.bottom)
        c.fault(Role::deepened_start, "the deepened starting point lies below the depth");
    if (on > 999 || off > 999) c.fault(Role::coolant_on, "an M function has at most three digits");
    if (!c.ready()) return;
    const int turning = way == 4 ? -1 : 1, entering = way == 5 ? 0 : turning;
    c.rapid_w(h.clearance);
    c.spindle(slow, slow > 0 ? entering : 0);
    if (deepened > 0) c.move_w(h.clearance - deepened, approach);
    c.spindle(fast, turning);
    machine_function(c, on);
    c.move_w(h.bottom, feed);
    c.dwell(dwell);
    machine_function(c, off);
    c.spindle(slow, slow > 0 ? entering : 0);
    c.move_w(h.clearance, back);
    c.rapid_w(h.end);
}

}  // namespace

void expand_drill(Course& c, const Demand& demand, const Situation& situation) {
    switch (demand.kind) {
        case Kind::peck: return peck(c, situation);
        case Kind::universal_drill: return universal_drill(c, situation);
        case Kind::universal_peck: return universal_peck(c, situation);
        case Kind::centre: return centre(c, situation);
        case Kind::single_lip: return single_lip(c, demand, situation);
        default: return drill(c, situation);
    }
}

}  // namespace obrys::cycles
