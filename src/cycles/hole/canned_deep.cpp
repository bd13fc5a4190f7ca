/// Deep drilling whose infeeds fall (SINUMERIK CYCLE83), what the plain canned cycles cannot say.
///
///   canned_deep  infeed: the first, counted from the surface (needed). decrement: each is so much less than the one
///                before, not below the decrement itself; what is less than two of these is drilled in two equal
///                infeeds. infeed_factor: each is the one before times this. min_infeed: of both.
///                chip_break_distance: after each infeed so far back; else out to the retract plane, dwell_top there,
///                and at rapid to stop_distance_first above the depth reached.
///                dwell after each infeed, dwell_bottom after the last; feed_factor: of the first infeed, %.
/// Sources: cycles/hole/canned.hpp, doc.i5cnc.com no. 512 (the sequence, under other names of the parameters); the rule
/// by which infeeds fall is from memory of the Programming Guide Cycles 11.02, 2.1.4, and is listed.

#include <algorithm>
#include <cmath>

#include "cycles/hole/canned.hpp"
#include "cycles/levels.hpp"

namespace obrys::cycles {

namespace {

struct Falling {
    double first = 0, decrement = 0, factor = 1, least = 0;
};

Falling read_falling(Course& c, const Demand& demand) {
    Falling f;
    f.first = c.positive(Role::infeed);
    f.decrement = c.maybe_at_least(Role::decrement, 0, 0);
    f.least = c.maybe_at_least(Role::min_infeed, 0, 0);
    if (demand.find(Role::infeed_factor)) f.factor = c.positive(Role::infeed_factor);
    if (f.factor > 1) c.fault(Role::infeed_factor, "the factor of the infeeds must not be above 1");
    if (f.decrement > 0)
        c.assume("how the infeeds fall to the last ones is not documented: they are run as older manuals say");
    return f;
}

double next_infeed(const Falling& f, double before, double rest) {
    if (f.decrement <= 0) return std::max(before * f.factor, f.least);
    const double next = std::max({before - f.decrement, std::min(before, f.decrement), f.least});
    const bool last_two = next <= f.decrement + same_depth && rest < 2 * f.decrement - same_depth;
    return last_two && rest > f.decrement + same_depth ? rest / 2 : next;
}

/// Where the infeeds end, the bottom last.
std::vector<double> falling_levels(Course& c, double top, double bottom, const Falling& f) {
    std::vector<double> levels;
    double infeed = f.first, level = top;
    while (level - infeed > bottom + same_depth) {
        level -= infeed;
        levels.push_back(level);
        if (levels.size() > most_steps / 8 || infeed < same_depth) {
            c.fault(Role::infeed, "the infeed is too small for the depth");
            return {};
        }
        infeed = next_infeed(f, infeed, level - bottom);
    }
    levels.push_back(bottom);
    return levels;
}

struct Ways {
    bool out = false;                       ///< of the hole after each infeed
    double distance = 0;                    ///< back, or above the depth reached
    double dwell = 0, top = 0, bottom = 0;  ///< s
};

Ways read_ways(Course& c, const Demand& demand) {
    Ways w;
    w.out = !demand.find(Role::chip_break_distance);
    w.distance = c.at_least(w.out ? Role::stop_distance_first : Role::chip_break_distance, 0);
    w.dwell = c.maybe_at_least(Role::dwell, 0, 0);
    w.top = c.maybe_at_least(Role::dwell_top, 0, 0);
    w.bottom = c.maybe_at_least(Role::dwell_bottom, 0, 0);
    return w;
}

void between(Course& c, const Hole& h, const Ways& w) {
    const double level = c.at().z;
    c.dwell(w.dwell);
    if (w.out) {
        rapid_to_w(c, h.retract);
        c.dwell(w.top);
    }
    rapid_to_w(c, std::min(level + w.distance, h.retract));
}

}  // namespace

void canned_deep(Course& c, const Demand& demand, const Situation& s) {
    const Hole h = read_hole(c, s);
    c.need(Role::surface);
    const double top = top_of(c, h);
    const Falling falling = read_falling(c, demand);
    const Ways ways = read_ways(c, demand);
    const double factor = demand.find(Role::feed_factor) ? c.positive(Role::feed_factor) / 100 : 1;
    const double feed = factor != 1 ? c.known(s.feed, "the feed rate in mm/min") : 0;
    if (!c.ready()) return;
    const std::vector<double> levels = falling_levels(c, top, h.bottom, falling);
    if (!c.ready()) return;
    approach(c, h);
    if (factor != 1) c.add(cl::Feed{feed * factor, cl::FeedMode::per_minute});
    for (std::size_t i = 0; i < levels.size() && c.room(); ++i) {
        feed_w(c, levels[i]);
        if (i == 0 && factor != 1) c.add(cl::Feed{feed, cl::FeedMode::per_minute});
        if (i + 1 < levels.size()) between(c, h, ways);
    }
    c.dwell(ways.bottom);
    rapid_to_w(c, h.end);
}

}  // namespace obrys::cycles
