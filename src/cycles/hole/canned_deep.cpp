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
#include "cycles/hole/families.hpp"
#include "cycles/levels.hpp"

namespace obrys::cycles {

namespace {

struct Falling {
    double first = 0, decrement = 0, factor = 1, least = 0;
};

Falling falling_of(Course& c, const DeepDrilling& d) {
    const Falling f{d.infeed, d.decrement.value_or(0), d.infeed_factor.value_or(1), d.min_infeed.value_or(0)};
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

/// How far back after each infeed, or above the depth reached.
double way_back(Course& c, const DeepDrilling& d) {
    if (d.chip_break_distance) return *d.chip_break_distance;
    return asked(c, d, &DeepDrilling::stop_distance_first, Must::be_at_least_0);
}

void between(Course& c, const Hole& h, const DeepDrilling& d, double distance) {
    const double level = c.at().z;
    c.dwell(d.dwell.value_or(0));
    if (!d.chip_break_distance) {
        rapid_to_w(c, h.retract);
        c.dwell(d.dwell_top.value_or(0));
    }
    rapid_to_w(c, std::min(level + distance, h.retract));
}

}  // namespace

void write_steps(Course& c, const DeepDrilling& d, const Situation& s) {
    const Hole h = hole_of(c, d, s);
    asked(c, d, &DeepDrilling::surface, Must::be_known);
    const double top = top_of(c, d);
    const Falling falling = falling_of(c, d);
    const double distance = way_back(c, d), factor = d.feed_factor.value_or(100) / 100;
    const double feed = factor != 1 ? c.known(s.feed, "the feed rate in mm/min") : 0;
    if (!c.ready()) return;
    const std::vector<double> levels = falling_levels(c, top, h.bottom, falling);
    if (!c.ready()) return;
    approach(c, h);
    if (factor != 1) c.add(cl::Feed{feed * factor, cl::FeedMode::per_minute});
    for (std::size_t i = 0; i < levels.size() && c.room(); ++i) {
        feed_w(c, levels[i]);
        if (i == 0 && factor != 1) c.add(cl::Feed{feed, cl::FeedMode::per_minute});
        if (i + 1 < levels.size()) between(c, h, d, distance);
    }
    c.dwell(d.dwell_bottom.value_or(0));
    rapid_to_w(c, h.end);
}

}  // namespace obrys::cycles
