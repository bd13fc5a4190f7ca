#include "sim/turning/swept.hpp"

#include <algorithm>
#include <cmath>

#include "geom/region.hpp"
#include "geom/sweep.hpp"

namespace obrys::sim::turning {

using geom::Contour;
using geom::Region;
using geom::Vec2;

namespace {

constexpr double below = 1e-7;  ///< mm below the axis that count: less is rounding

Vec2 over(Vec2 p) { return {p.x, -p.y}; }

Contour over(Contour c) {
    for (geom::Vertex& v : c.vertices) {
        v.p = over(v.p);
        v.bulge = -v.bulge;
    }
    return geom::reversed(c);
}

TurnedOver turn_over(const Contour& outline, const Move& m) {
    return {over(outline), {over(m.from), over(m.to), over(m.centre), -m.sweep}};
}

/// Lowest and highest x of the programmed point.
geom::Box way_of(const Move& m) {
    geom::Box b{m.from, m.from};
    b.add(m.to);
    if (m.sweep == 0) return b;
    const Vec2 r = m.from - m.centre;
    const geom::Box arc = geom::box(geom::arc_about(m.centre, geom::length(r), std::atan2(r.y, r.x),
                                                    std::clamp(m.sweep, -2 * geom::pi, 2 * geom::pi)));
    b.add(arc.lo);
    b.add(arc.hi);
    return b;
}

}  // namespace

Region swept(const Contour& outline, const Move& m) {
    if (m.sweep == 0) {
        Region r = geom::sweep_straight(outline, m.to - m.from);
        for (Contour& c : r.contours) c = geom::moved(c, m.from);
        return r;
    }
    const Vec2 r = m.from - m.centre;
    return geom::sweep_round(outline, m.centre, geom::length(r), std::atan2(r.y, r.x), m.sweep);
}

std::vector<TurnedOver> turned_over(const Contour& outline, const Contour& across, const Move& m) {
    std::vector<TurnedOver> out;
    const auto add = [&](const Contour& what, const Move& part) {
        if (!what.vertices.empty() && way_of(part).lo.y + geom::box(what).lo.y < -below)
            out.push_back(turn_over(what, part));
    };
    const geom::Box way = way_of(m);
    if (way.lo.y >= -below) {
        add(across, m);
    } else if (way.hi.y <= below || m.sweep != 0) {
        add(outline, m);
    } else {
        const Vec2 at = m.from + m.from.y / (m.from.y - m.to.y) * (m.to - m.from);
        const bool down = m.to.y < 0;
        add(down ? across : outline, {m.from, at, {}, 0});
        add(down ? outline : across, {at, m.to, {}, 0});
    }
    return out;
}

}  // namespace obrys::sim::turning
