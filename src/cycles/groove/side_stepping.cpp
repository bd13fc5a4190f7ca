/// Side stepping: plunges that go one step sideways and one infeed deeper, back and forth between the flanks.

#include <algorithm>
#include <cmath>

#include "cycles/groove/strategy.hpp"

namespace obrys::cycles::groove {

namespace {

/// Where the blade stands on its staircase.
struct Stair {
    double u = 0, v = 0;
    Side toward = Side::right;
    bool at_flank = false;
};

/// One step sideways and one infeed deeper, not past the flank and not into the contour.
Stair next(const Blade& blade, const Stair& now) {
    const Manner& m = blade.manner();
    const Contour& contour = blade.contour();
    Stair s = now;
    const double level = std::max(now.v - m.infeed, contour.bottom);
    const double far = blade.flush(now.toward, level), way = outward(now.toward);
    s.u = now.u + way * m.stepover;
    s.at_flank = (s.u - far) * way >= -nothing;
    if (s.at_flank) s.u = far;
    // A leaning flank behind the blade: no deeper than where it is one step on.
    s.v = std::max(level, contour.reach(s.u, blade.width()));
    if (s.v - contour.bottom < nothing) s.v = contour.bottom;
    return s;
}

}  // namespace

void side_stepping(Blade& blade, Side start) {
    const Contour& contour = blade.contour();
    std::array<double, 2> clean{contour.wall(Side::left).edge.y, contour.wall(Side::right).edge.y};
    Stair stair{0, clean[index(start)], other(start), false};
    stair.u = blade.flush(start, stair.v);
    if (stair.v > contour.bottom) blade.plunge(stair.u, stair.v);
    std::optional<double> first_on_bottom;
    Doings& does = blade.doings();
    while (true) {
        stair = next(blade, stair);
        blade.plunge(stair.u, stair.v);
        if (stair.v == contour.bottom && !first_on_bottom) first_on_bottom = stair.u;
        if (!stair.at_flank) continue;
        if (does.traverses++ == 0) does.first_traverse = does.area;
        blade.wedge(stair.toward, stair.v, clean[index(stair.toward)]);
        clean[index(stair.toward)] = std::min(clean[index(stair.toward)], stair.v);
        stair.toward = other(stair.toward);
        if (first_on_bottom) break;
    }
    // Back over the staircase, from where the bottom was reached.
    const double far = blade.flush(stair.toward, contour.bottom), way = far - *first_on_bottom;
    const int n = steps_of(std::abs(way), blade.manner().stepover);
    for (int i = 1; i <= n; ++i) blade.plunge(i == n ? far : *first_on_bottom + way * i / n, contour.bottom);
    blade.wedge(stair.toward, contour.bottom, clean[index(stair.toward)]);
    blade.dwell();
    blade.out();
}

}  // namespace obrys::cycles::groove
