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

geom::Vec2 target_of(Course& c, const Said& u, const Said& v, const Situation& s) {
    const geom::Vec2 target{u.value_or(s.at.x), v.value_or(s.at.y)};
    c.known(target.x + target.y, "the position of the hole");
    return target;
}

Hole hole_of(Course& c, const HolePlanes& d, const Situation& s) {
    Hole h;
    h.target = target_of(c, d.target_u, d.target_v, s);
    h.called_here = std::isnan(d.target_u.value_or(unknown)) && std::isnan(d.target_v.value_or(unknown));
    h.retract = d.retract_plane;
    h.bottom = d.bottom;
    h.end = d.return_level.value_or(h.retract);
    const double rise = d.rise_first.value_or(0);
    h.rise_first = rise != 0;
    h.risen = rise > 1;
    if (h.rise_first) c.known(s.at.z, "the tool's height");
    if (h.retract < h.bottom) c.fault(Role::retract_plane, "the retract plane lies below the bottom of the hole");
    return h;
}

double top_of(Course& c, const HolePlanes& d) {
    const double top = asked_or(c, d, &HolePlanes::surface, Must::be_known, d.retract_plane);
    if (top > d.retract_plane || top < d.bottom)
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

void dwell_if(Course& c, const Said& seconds) {
    if (seconds) c.add(cl::Dwell{.seconds = *seconds});
}

void feed_out(Course& c, const Hole& h, bool whole_way) {
    if (whole_way) return feed_w(c, h.end);
    feed_w(c, h.retract);
    rapid_to_w(c, h.end);
}

Turning turning_of(Course& c, const Said& speed, const Said& direction, const Situation& s) {
    Turning t;
    t.speed = speed ? *speed : c.spindle_speed(s);
    const double wanted = direction.value_or(s.spindle_direction);
    if (wanted == 0) c.fault("the spindle does not turn", "program M3 or M4 before the cycle");
    if (wanted != 0 && std::abs(wanted) != 1) c.fault(Role::spindle_direction, "the spindle direction must be 1 or -1");
    t.direction = wanted < 0 ? -1 : 1;
    return t;
}

void stop_spindle(Course& c, const Turning& t) { c.spindle(t.speed, 0); }
void start_spindle(Course& c, const Turning& t) { c.spindle(t.speed, t.direction); }

void begin_turning(Course& c, const Said& starts_spindle, const Situation& s, const Turning& t) {
    if (starts_spindle.value_or(0) == 1 && s.spindle_direction != t.direction) start_spindle(c, t);
}

void end_turning(Course& c, const Said& spindle_after, const Turning& t) {
    if (!spindle_after) return start_spindle(c, t);
    if (*spindle_after != 0) c.spindle(t.speed, *spindle_after > 0 ? 1 : -1);
}

void feed_of(Course& c, const Said& feed) {
    if (feed) c.add(cl::Feed{*feed, cl::FeedMode::per_minute});
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
    Said back;                   ///< chip breaking: this far up
    double stop = 0;             ///< pecking: rapid down to this far above
    double out = 0;              ///< pecking: out to this height
    double full_every = 0;       ///< chip breaking: depth between full retractions, 0 none
    bool binary = false;
    Said dwell;  ///< s, at the bottom
};

/// Ends of the infeeds below `top`, of which the first two may be larger.
std::vector<double> levels_below(Course& c, double top, const PeckInfeeds& d) {
    std::vector<double> levels;
    for (const double larger : {d.first_infeed.value_or(0), d.second_infeed.value_or(0)}) {
        if (larger <= 0 || top - larger <= d.bottom + same_depth) continue;
        top -= larger;
        levels.push_back(top);
    }
    const std::vector<double> rest =
        levels_of(c, top, d.bottom, {d.infeed, d.decrement.value_or(0), d.min_infeed.value_or(0)});
    levels.insert(levels.end(), rest.begin(), rest.end());
    return levels;
}

/// What pecking and chip breaking have in common; how far back and down is left to them.
Pecks pecks_of(Course& c, const PeckInfeeds& d, const Hole& h) {
    Pecks p;
    const double top = top_of(c, d);
    p.out = d.peck_to_surface.value_or(0) != 0 ? top : h.retract;
    if (p.out < h.retract)
        c.assume(
            "between the infeeds the tool goes out to a distance below the top of the hole that is not documented: it "
            "is run up to the top");
    const double unit = d.length_unit.value_or(0);
    p.binary = unit > 0;
    p.dwell = d.dwell_bottom;
    if (!c.ready()) return p;
    p.levels = p.binary ? binary_levels(c, h, d.infeed, unit) : levels_below(c, top, d);
    if (p.levels.empty()) p.levels.push_back(h.bottom);
    return p;
}

void run_pecks(Course& c, const Hole& h, const Pecks& p) {
    if (!c.ready()) return;
    // LinuxCNC goes back by the whole distance even where that is above the retract plane.
    const auto above = [&](double w) { return p.binary ? w : std::min(w, h.retract); };
    approach(c, h);
    double since = h.retract;
    for (std::size_t i = 0; i + 1 < p.levels.size() && c.room(); ++i) {
        const double level = p.levels[i];
        feed_w(c, level);
        const bool full = p.full_every > 0 && since - level >= p.full_every - same_depth;
        if (p.back && !full) {
            rapid_to_w(c, above(level + *p.back));
            continue;
        }
        since = level;
        rapid_to_w(c, p.out);
        const double down = above(level + p.stop);
        rapid_to_w(c, p.out < h.retract ? std::min(down, p.out) : down);
    }
    feed_w(c, h.bottom);
    dwell_if(c, p.dwell);
    rapid_to_w(c, h.end);
}

}  // namespace

void write_steps(Course& c, const Drilling& d, const Situation& s) {
    const Hole h = hole_of(c, d, s);
    const double finish = d.finish_infeed.value_or(0);
    const double factor = finish > 0 ? asked(c, d, &Drilling::feed_factor, Must::be_above_0) / 100 : 1;
    const double feed = factor != 1 ? c.known(s.feed, "the feed rate in mm/min") : 0;
    if (!c.ready()) return;
    approach(c, h);
    feed_to_bottom(c, h, finish, factor, feed);
    dwell_if(c, d.dwell_bottom);
    rapid_to_w(c, h.end);
}

void write_steps(Course& c, const ChipBreakDrilling& d, const Situation& s) {
    const Hole h = hole_of(c, d, s);
    const double every = d.retract_every.value_or(0);
    const double stop = every > 0 ? asked(c, d, &ChipBreakDrilling::stop_distance_first, Must::be_at_least_0) : 0;
    Pecks p = pecks_of(c, d, h);
    p.back = d.chip_break_distance;
    p.full_every = every;
    p.stop = stop;
    run_pecks(c, h, p);
}

void write_steps(Course& c, const PeckDrilling& d, const Situation& s) {
    const Hole h = hole_of(c, d, s);
    Pecks p = pecks_of(c, d, h);
    p.stop = d.stop_distance_first;
    run_pecks(c, h, p);
}

}  // namespace obrys::cycles
