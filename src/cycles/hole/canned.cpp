/// Drilling, chip breaking and pecking; what all canned cycles share. Sources: cycles/hole/canned.hpp.
///
///   canned_drill       (G81, G82) dwell_bottom; finish_infeed: the last bit of the way, at feed_factor % (Acramatic).
///   canned_chip_break  (G73) infeed; chip_break_distance: how far back after each; retract_every with
///                      stop_distance_first: out to the retract plane after this depth (Haas K with Q).
///   canned_peck        (G83) infeed; stop_distance_first: rapid down ends this far above the depth reached.
/// Both with decrement and min_infeed (Haas I, J, K) and dwell_bottom; first_infeed and second_infeed (Acramatic J1 …
/// J3). Infeeds count from the surface, where it is written, else from the retract plane; peck_to_surface: out to the
/// surface alone.

#include <algorithm>
#include <cmath>

#include "cycles/hole/canned.hpp"
#include "cycles/hole/families.hpp"
#include "cycles/levels.hpp"

namespace obrys::cycles {

geom::Vec2 read_target(Course& c, const Situation& s) {
    const geom::Vec2 target{c.maybe(Role::target_u, s.at.x), c.maybe(Role::target_v, s.at.y)};
    c.known(target.x + target.y, "the position of the hole");
    return target;
}

Hole read_hole(Course& c, const Situation& s) {
    Hole h;
    h.target = read_target(c, s);
    h.called_here = std::isnan(c.maybe(Role::target_u, unknown)) && std::isnan(c.maybe(Role::target_v, unknown));
    h.retract = c.need(Role::retract_plane);
    h.bottom = c.need(Role::bottom);
    h.end = c.maybe(Role::return_level, h.retract);
    const double rise = c.maybe(Role::rise_first, 0);
    h.rise_first = rise != 0;
    h.risen = rise > 1;
    if (h.rise_first) c.known(s.at.z, "the tool's height");
    if (h.retract < h.bottom) c.fault(Role::retract_plane, "the retract plane lies below the bottom of the hole");
    return h;
}

double top_of(Course& c, const Hole& h) {
    const double top = c.maybe(Role::surface, h.retract);
    if (top > h.retract || top < h.bottom)
        c.fault(Role::surface, "the surface does not lie between the retract plane and the bottom of the hole");
    return top;
}

void feed_w(Course& c, double w) { c.straight({c.at().x, c.at().y, w}, false); }
void rapid_to_w(Course& c, double w) { c.straight({c.at().x, c.at().y, w}, true); }

void approach(Course& c, const Hole& h) {
    if (h.rise_first && !h.risen && c.at().z < h.retract) rapid_to_w(c, h.retract);
    // LinuxCNC crosses at its own height where it stands above the retract plane, else where the cycle will end.
    const double across = h.rise_first && !(c.at().z > h.retract) ? h.end : c.at().z;
    if (!h.called_here) c.straight({h.target.x, h.target.y, across}, true);
    c.over_place();
    if (c.at().z != h.retract) rapid_to_w(c, h.retract);
}

void dwell_if(Course& c, const Demand& demand, Role role) {
    if (const auto seconds = demand.find(role)) c.add(cl::Dwell{.seconds = *seconds});
}

void feed_out(Course& c, const Hole& h, bool whole_way) {
    if (whole_way) return feed_w(c, h.end);
    feed_w(c, h.retract);
    rapid_to_w(c, h.end);
}

Turning read_turning(Course& c, const Situation& s) {
    Turning t;
    const double said = c.maybe_at_least(Role::spindle_speed, 0, unknown);
    t.speed = std::isnan(said) ? c.spindle_speed(s) : said;
    const double wanted = c.maybe(Role::spindle_direction, s.spindle_direction);
    if (wanted == 0) c.fault("the spindle does not turn", "program M3 or M4 before the cycle");
    if (wanted != 0 && std::abs(wanted) != 1) c.fault(Role::spindle_direction, "the spindle direction must be 1 or -1");
    t.direction = wanted < 0 ? -1 : 1;
    return t;
}

void stop_spindle(Course& c, const Turning& t) { c.spindle(t.speed, 0); }
void start_spindle(Course& c, const Turning& t) { c.spindle(t.speed, t.direction); }

void begin_turning(Course& c, const Demand& demand, const Situation& s, const Turning& t) {
    if (demand.get(Role::starts_spindle, 0) == 1 && s.spindle_direction != t.direction) start_spindle(c, t);
}

void end_turning(Course& c, const Demand& demand, const Turning& t) {
    const auto after = demand.find(Role::spindle_after);
    if (!after) return start_spindle(c, t);
    if (*after != 0) c.spindle(t.speed, *after > 0 ? 1 : -1);
}

void feed_of(Course& c, const Demand& demand, Role role) {
    if (const auto feed = demand.find(role)) c.add(cl::Feed{*feed, cl::FeedMode::per_minute});
}

namespace {

/// The last bit of the way at another feed.
void feed_to_bottom(Course& c, const Hole& h, double finish, double factor, double feed) {
    if (finish > 0 && factor != 1) {
        feed_w(c, std::min(c.at().z, h.bottom + finish));
        c.add(cl::Feed{feed * factor, cl::FeedMode::per_minute});
        feed_w(c, h.bottom);
        return c.add(cl::Feed{feed, cl::FeedMode::per_minute});
    }
    feed_w(c, h.bottom);
}

void drill(Course& c, const Demand& demand, const Situation& s) {
    const Hole h = read_hole(c, s);
    c.maybe_at_least(Role::dwell_bottom, 0, 0);
    const double finish = c.maybe_at_least(Role::finish_infeed, 0, 0);
    const double factor = finish > 0 ? c.positive(Role::feed_factor) / 100 : 1;
    const double feed = factor != 1 ? c.known(s.feed, "the feed rate in mm/min") : 0;
    if (!c.ready()) return;
    approach(c, h);
    feed_to_bottom(c, h, finish, factor, feed);
    dwell_if(c, demand, Role::dwell_bottom);
    rapid_to_w(c, h.end);
}

/// Infeeds added up as LinuxCNC does it, in binary numbers of the program's unit: a rounding error may leave one more
/// infeed, without length, and the calls shall be the same.
std::vector<double> binary_levels(Course& c, const Hole& h, double infeed, double unit) {
    std::vector<double> levels;
    if ((h.retract - h.bottom) / infeed > double(most_steps) / 8) {
        c.fault(Role::infeed, "the infeed is too small for the depth");
        return levels;
    }
    const double bottom = h.bottom / unit, step = infeed / unit;
    for (double level = h.retract / unit - step; level > bottom && levels.size() < most_steps; level -= step)
        levels.push_back(level * unit);
    levels.push_back(h.bottom);
    return levels;
}

struct Pecks {
    std::vector<double> levels;  ///< ends of the infeeds, the bottom last
    double back = 0;             ///< chip breaking: this far up
    double stop = 0;             ///< pecking: rapid down to this far above
    double out = 0;              ///< pecking: out to this height
    double full_every = 0;       ///< chip breaking: depth between full retractions, 0 none
    bool binary = false;
};

/// Ends of the infeeds below `top`, of which the first two may be larger.
std::vector<double> levels_below(Course& c, double top, double bottom, const Infeeds& infeeds) {
    const double first = c.maybe_at_least(Role::first_infeed, 0, 0),
                 second = c.maybe_at_least(Role::second_infeed, 0, 0);
    if (!c.ready()) return {};
    std::vector<double> levels;
    for (const double larger : {first, second}) {
        if (larger <= 0 || top - larger <= bottom + same_depth) continue;
        top -= larger;
        levels.push_back(top);
    }
    const std::vector<double> rest = levels_of(c, top, bottom, infeeds);
    levels.insert(levels.end(), rest.begin(), rest.end());
    return levels;
}

Pecks read_pecks(Course& c, const Hole& h, bool chip_break) {
    Pecks p;
    const double top = top_of(c, h);
    p.out = c.maybe(Role::peck_to_surface, 0) != 0 ? top : h.retract;
    if (p.out < h.retract)
        c.assume(
            "between the infeeds the tool goes out to a distance below the top of the hole that is not documented: it "
            "is run up to the top");
    const double unit = c.maybe(Role::length_unit, 0);
    p.binary = unit > 0;
    const Infeeds infeeds = read_infeeds(c, true);
    if (chip_break) {
        p.back = c.at_least(Role::chip_break_distance, 0);
        p.full_every = c.maybe_at_least(Role::retract_every, 0, 0);
    }
    if (!chip_break || p.full_every > 0) p.stop = c.at_least(Role::stop_distance_first, 0);
    c.maybe_at_least(Role::dwell_bottom, 0, 0);
    if (!c.ready()) return p;
    p.levels = p.binary ? binary_levels(c, h, infeeds.first, unit) : levels_below(c, top, h.bottom, infeeds);
    if (p.levels.empty()) p.levels.push_back(h.bottom);
    return p;
}

void pecks(Course& c, const Demand& demand, const Situation& s, bool chip_break) {
    const Hole h = read_hole(c, s);
    const Pecks p = read_pecks(c, h, chip_break);
    if (!c.ready()) return;
    // LinuxCNC goes back by the whole distance even where that is above the retract plane.
    const auto above = [&](double w) { return p.binary ? w : std::min(w, h.retract); };
    approach(c, h);
    double since = h.retract;
    for (std::size_t i = 0; i + 1 < p.levels.size() && c.room(); ++i) {
        const double level = p.levels[i];
        feed_w(c, level);
        const bool full = p.full_every > 0 && since - level >= p.full_every - same_depth;
        if (chip_break && !full) {
            rapid_to_w(c, above(level + p.back));
            continue;
        }
        since = level;
        rapid_to_w(c, p.out);
        const double down = above(level + p.stop);
        rapid_to_w(c, p.out < h.retract ? std::min(down, p.out) : down);
    }
    feed_w(c, h.bottom);
    dwell_if(c, demand, Role::dwell_bottom);
    rapid_to_w(c, h.end);
}

}  // namespace

void expand_canned(Course& c, const Demand& demand, const Situation& situation) {
    switch (demand.kind) {
        case Kind::canned_drill: return drill(c, demand, situation);
        case Kind::canned_chip_break: return pecks(c, demand, situation, true);
        case Kind::canned_peck: return pecks(c, demand, situation, false);
        case Kind::canned_deep: return canned_deep(c, demand, situation);
        case Kind::canned_tap_floating:
        case Kind::canned_tap_rigid: return canned_tap(c, demand, situation);
        default: return canned_bore(c, demand, situation);
    }
}

}  // namespace obrys::cycles
