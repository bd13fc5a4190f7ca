/// Strategies in levels: layer by layer, plunge turning, ramping.

#include <algorithm>
#include <cmath>

#include "base/number.hpp"
#include "cycles/groove/strategy.hpp"

namespace obrys::cycles::groove {

namespace {

/// Equal layers, at most `thickest`, from the crest to the bottom.
std::vector<double> equal_levels(const Contour& c, double thickest) {
    const double deep = c.crest() - c.bottom;
    const int n = std::max(1, steps_of(deep, thickest));
    std::vector<double> v;
    for (int i = 1; i <= n; ++i) v.push_back(i == n ? c.bottom : c.crest() - deep * i / n);
    return v;
}

void note_layers(Blade& blade, const std::vector<double>& levels) {
    blade.doings().layers = levels.size();
    blade.doings().layer = (blade.contour().crest() - blade.contour().bottom) / static_cast<double>(levels.size());
}

Side low_side(const Contour& c) { return c.slope >= 0 ? Side::left : Side::right; }

/// On the side's flank at this height, from where it goes on downward.
bool stands_on(const Blade& blade, Side side, double v) {
    return !blade.moves().empty() && v <= blade.contour().wall(side).edge.y && blade.at().y == v &&
           std::abs(blade.at().x - blade.flush(side, v)) < nothing;
}

/// Where the blade may stand on both sides at this height.
struct Room {
    double left = 0, right = 0;
};
Room room_at(const Blade& blade, double v) {
    Room r{blade.flush(Side::left, v), blade.flush(Side::right, v)};
    // Over the lower edge the blade may stand in front of the stock.
    if (r.left > r.right) std::swap(r.left, r.right);
    return r;
}

/// From a plunge's bottom back by `lift`, sideways to `end` and down again.
void turn(Blade& blade, Vec2 start, double end, double lift) {
    if (end == start.x) return;
    const double v = start.y + lift;
    if (blade.stock().met({{start.x, v}, {end, v}}, blade.width()).depth <= nothing) {
        blade.plunge(end, start.y);
        return;
    }
    if (blade.at() != start) blade.link(start.x);
    blade.straight({start.x, v});
    blade.straight({end, v});
    blade.straight({end, start.y});
}

/// There and back: down to `to`, then along its height to `back`.
void ramp(Blade& blade, Vec2 from, Vec2 to, double back) {
    ++blade.doings().passes;
    if (blade.moves().empty() || blade.at().y != from.y) blade.link(from.x);
    blade.straight(from);
    blade.straight(to);
    blade.straight({back, to.y});
}

}  // namespace

void layer_by_layer(Blade& blade) {
    const Contour& c = blade.contour();
    const std::vector<double> levels = equal_levels(c, blade.manner().infeed);
    note_layers(blade, levels);
    Side side = low_side(c);
    double above = c.crest();
    for (const double v : levels) {
        const Room room = room_at(blade, v);
        std::vector<double> u = columns(room.left, room.right, blade.manner().stepover);
        if (side == Side::right) std::reverse(u.begin(), u.end());
        const bool there = stands_on(blade, side, above);
        if (there) blade.descend(side, above, v);
        for (std::size_t i = there ? 1 : 0; i < u.size(); ++i) blade.plunge(u[i], v);
        for (const Side s : {side, other(side)}) blade.wedge(s, v, above);
        above = v;
        side = other(side);
    }
    blade.dwell();
    blade.out();
}

std::optional<Refusal> plunge_turning(Blade& blade) {
    const Contour& c = blade.contour();
    const Manner& m = blade.manner();
    const double most = thickest_layer * blade.width();
    if (m.layer > most + nothing)
        return Refusal{Guard::layer,
                       "a layer of " + base::shortest(m.layer) + " mm is more than " + base::shortest(thickest_layer) +
                           " of the insert's width, " + base::shortest(most) + " mm",
                       "give `layer` at most that, or leave it out"};
    const std::vector<double> levels = equal_levels(c, m.layer > 0 ? m.layer : std::min(m.infeed, most));
    note_layers(blade, levels);
    Side side = low_side(c);
    double above = c.crest();
    for (const double v : levels) {
        const Room room = room_at(blade, v);
        const double start = side == Side::left ? room.left : room.right;
        const double end = side == Side::left ? room.right : room.left;
        if (stands_on(blade, side, above)) {
            blade.descend(side, above, v);
        } else {
            blade.plunge(start, v);
        }
        turn(blade, {start, v}, end, std::min(m.lift, above - v));
        for (const Side s : {side, other(side)}) blade.wedge(s, v, above);
        above = v;
        side = other(side);
    }
    blade.dwell();
    blade.out();
    return std::nullopt;
}

std::optional<Refusal> ramping(Blade& blade) {
    const Contour& c = blade.contour();
    const Manner& m = blade.manner();
    const double free = c.flat() - blade.width(), slope = std::tan(m.ramp_angle);
    if (free < blade.width() / 2 - nothing)
        return Refusal{Guard::ramp,
                       "beside the insert the bottom has " + base::shortest(free) +
                           " mm for ramps: less than half of the insert's width",
                       "take a narrower insert or another strategy"};
    if ((c.crest() - c.bottom) / (free * slope) > most_cuts)
        return Refusal{Guard::ramp, "ramps of so small an angle make more than " + base::shortest(most_cuts) + " cuts",
                       "give `ramp_angle` a larger angle"};
    const std::vector<double> levels =
        equal_levels(c, std::min({m.infeed, thickest_ramp * blade.width(), free * slope}));
    note_layers(blade, levels);
    const Side side = low_side(c);
    const double way = outward(other(side));
    double above = c.crest();
    for (const double v : levels) {
        const double length = (above - v) / slope;
        double start = blade.flush(side, v), end = blade.flush(other(side), v);
        // Over the lower edge the ramp begins in front of the stock, where it would be too steep.
        if (v >= c.wall(side).edge.y && (end - start) * way < length) start = end - way * length;
        ramp(blade, {start, above}, {end, v}, start);
        above = v;
    }
    for (const Side s : {Side::left, Side::right}) blade.wedge(s, c.bottom, c.wall(s).edge.y);
    blade.dwell();
    blade.out();
    return std::nullopt;
}

}  // namespace obrys::cycles::groove
