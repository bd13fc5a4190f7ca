/// Strategies in columns: stepwise alternating, pecked one by one, with ribs between.

#include <algorithm>
#include <cmath>

#include "base/number.hpp"
#include "cycles/groove/strategy.hpp"

namespace obrys::cycles::groove {

namespace {

/// From the middle outward, its left neighbour first.
std::vector<std::size_t> outward_order(std::size_t n) {
    std::vector<std::size_t> order{n / 2};
    for (std::size_t i = 1; order.size() < n; ++i) {
        if (i <= n / 2) order.push_back(n / 2 - i);
        if (n / 2 + i < n) order.push_back(n / 2 + i);
    }
    return order;
}

std::vector<double> bottom_columns(const Blade& blade, double step) {
    const double bottom = blade.contour().bottom;
    return columns(blade.flush(Side::left, bottom), blade.flush(Side::right, bottom), step);
}

void wedges(Blade& blade) {
    const Contour& c = blade.contour();
    for (const Side side : {Side::left, Side::right}) blade.wedge(side, c.bottom, c.wall(side).edge.y);
    blade.dwell();
    blade.out();
}

/// Two neighbours by turns, each time one infeed deeper than the other, from the lower of their tops.
void alternate(Blade& blade, double first, double second) {
    const double bottom = blade.contour().bottom;
    double level = std::min(blade.highest(first), blade.highest(second));
    const std::array<double, 2> pair{first, second};
    for (std::size_t turn = 0; blade.has_stock(first, bottom) || blade.has_stock(second, bottom); ++turn) {
        level = std::max(bottom, level - blade.manner().infeed);
        if (level - bottom < nothing) level = bottom;
        blade.plunge(pair[turn % 2], level);
    }
}

}  // namespace

std::vector<double> columns(double begin, double end, double step) {
    const int gaps = steps_of(end - begin, step);
    std::vector<double> u{begin};
    for (int i = 1; i <= gaps; ++i) u.push_back(i == gaps ? end : begin + (end - begin) * i / gaps);
    return u;
}

void stepwise(Blade& blade) {
    const double bottom = blade.contour().bottom;
    const std::vector<double> u = bottom_columns(blade, std::min(blade.manner().stepover, 0.8 * blade.width()));
    blade.doings().columns = u.size();
    const std::vector<std::size_t> order = outward_order(u.size());
    if (u.size() == 1) {
        blade.peck(u[0], bottom, blade.manner().infeed);
    } else {
        alternate(blade, u[order[0]], u[order[1]]);
        for (std::size_t i = 2; i < order.size(); ++i) blade.peck(u[order[i]], bottom, blade.manner().peck);
    }
    wedges(blade);
}

void pecked_columns(Blade& blade, bool only_first) {
    const std::vector<double> u = bottom_columns(blade, blade.manner().stepover);
    blade.doings().columns = only_first ? 1 : u.size();
    for (const std::size_t i : outward_order(u.size())) {
        blade.peck(u[i], blade.contour().bottom, blade.manner().infeed);
        if (only_first) break;
    }
    if (only_first) {
        blade.dwell();
        blade.out();
    } else {
        wedges(blade);
    }
}

std::optional<Refusal> multiple(Blade& blade) {
    const double flat = blade.contour().flat(), w = blade.width(), bottom = blade.contour().bottom;
    const double widest = blade.manner().rib * w;
    if (!(widest > 0) || widest >= w)
        return Refusal{Guard::rib,
                       "a rib of " + base::shortest(widest) + " mm is not narrower than the insert of " +
                           base::shortest(w) + " mm: its foot would stay",
                       "give `rib` a part of the insert's width below 1, usually 0.6 to 0.8"};
    // Round corners leave room on both sides of a rib: what is between two full cuts must fit the next one's edge.
    const double round = blade.corner_radius(), between = std::min(widest, w - 4 * round);
    const double step = between > 0 ? w + between : w - 2 * round;
    int full = 1 + steps_of(flat - w, step);
    if (full > 1 && flat - full * w <= 0)  // no ribs: the edges of the full cuts alone make the bottom
        full = 1 + steps_of(flat - w, w - 2 * round);
    const double rib = full > 1 ? (flat - full * w) / (full - 1) : -w;
    Doings& does = blade.doings();
    does.columns = does.full_columns = static_cast<std::size_t>(full);
    const double left = blade.flush(Side::left, bottom), right = blade.flush(Side::right, bottom);
    std::vector<double> u{left};
    for (int i = 1; i < full; ++i) u.push_back(left + (right - left) * i / (full - 1));
    for (const double at : u) blade.peck(at, bottom, blade.manner().peck);
    if (rib > nothing) {
        does.ribs = static_cast<std::size_t>(full - 1);
        does.rib_width = rib;
        blade.set_feed(1.4);  // both corners are free [Sandvik grooving guide]
        for (std::size_t i = 0; i + 1 < u.size(); ++i) blade.peck((u[i] + u[i + 1]) / 2, bottom, blade.manner().peck);
        blade.set_feed(1);
    }
    wedges(blade);
    return std::nullopt;
}

}  // namespace obrys::cycles::groove
