/// Runs along walls with tangential arcs to and from them.

#include <algorithm>
#include <cmath>

#include "cycles/mill/milling.hpp"

namespace obrys::cycles {

using geom::Contour;
using geom::Edge;
using geom::Region;
using geom::Vec2;

namespace {

/// The closed chain, cut open in the middle of one of its edges.
Contour opened(const std::vector<Edge>& chain, std::size_t at) {
    Contour out{{}, false};
    const auto add = [&](const Edge& e) { out.vertices.push_back({e.a, e.bulge}); };
    add(geom::part(chain[at], 0.5, 1));
    for (std::size_t i = 1; i < chain.size(); ++i) add(chain[(at + i) % chain.size()]);
    add(geom::part(chain[at], 0, 0.5));
    out.vertices.push_back({out.vertices.front().p});
    return out;
}

/// Edges by length, longest first, not too many.
std::vector<std::size_t> places(const std::vector<Edge>& chain) {
    std::vector<std::size_t> order(chain.size());
    for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
        return geom::length(chain[a]) > geom::length(chain[b]) + 1e-9;
    });
    if (order.size() > 32) order.resize(32);
    return order;
}

/// `into`: +1 where the room is left of the chain, -1 right.
Wall wall_of(const std::vector<Edge>& chain, const Region& room, double into, const WallOptions& o) {
    Wall w;
    const std::vector<std::size_t> order = places(chain);
    for (const double part : {1.0, 0.5, 0.25, 0.1})
        for (const std::size_t i : order) {
            const Vec2 p = geom::point_at(chain[i], 0.5), ahead = geom::tangent_at(chain[i], 0.5);
            const double r = part * o.arc;
            const Vec2 centre = p + into * r * geom::left_of(ahead);
            if (r <= 0 || !geom::contains(room, centre) || geom::distance(room, centre) < r - 1e-9) continue;
            w.run = opened(chain, i);
            w.centre = centre;
            w.turn = into * (o.semicircle ? geom::pi : geom::pi / 2);
            w.from = o.semicircle ? centre + (centre - p) : centre - r * ahead;
            w.to = o.semicircle ? w.from : centre + r * ahead;
            return w;
        }
    w.run = opened(chain, order.front());
    w.from = w.to = w.run.vertices.front().p;
    return w;
}

}  // namespace

namespace {

Wall placed_wall(Wall w, const Placement& where) {
    w.run = placed(w.run, where);
    w.from = placed(w.from, where);
    w.to = placed(w.to, where);
    w.centre = placed(w.centre, where);
    return w;
}

}  // namespace

std::vector<Wall> walls_of(const Region& room, const WallOptions& o) {
    std::vector<Wall> out;
    for (const Contour& c : room.contours) {
        const std::vector<Edge> chain = geom::edges(o.climb ? c : geom::reversed(c));
        if (!chain.empty()) out.push_back(placed_wall(wall_of(chain, room, o.climb ? 1 : -1, o), o.where));
    }
    return out;
}

std::vector<Wall> walls_around(const Region& stud, const WallOptions& o) {
    // What is outside, as far as arcs may reach.
    geom::Box b = geom::box(stud);
    const double far = 4 * o.arc + 1;
    Region outside{{{{{b.lo - Vec2{far, far}},
                      {{b.hi.x + far, b.lo.y - far}},
                      {b.hi + Vec2{far, far}},
                      {{b.lo.x - far, b.hi.y + far}}},
                     true}}};
    for (const Contour& c : stud.contours) outside.contours.push_back(geom::reversed(c));
    std::vector<Wall> out;
    for (std::size_t i = 1; i < outside.contours.size(); ++i) {
        const Contour& c = outside.contours[i];
        const std::vector<Edge> chain = geom::edges(o.climb ? c : geom::reversed(c));
        if (!chain.empty()) out.push_back(placed_wall(wall_of(chain, outside, o.climb ? 1 : -1, o), o.where));
    }
    return out;
}

void mill_walls(Course& c, const std::vector<Wall>& walls, const Cuts& cuts, double plunge_feed, double feed) {
    for (const Wall& w : walls) {
        c.rapid_w(std::max({cuts.clearance, cuts.safe, c.at().z}));
        c.rapid({w.from.x, w.from.y, c.at().z});
        c.rapid_w(cuts.clearance);
        for (const double level : cuts.levels) {
            if (!c.room()) return;
            c.move({w.from.x, w.from.y, c.at().z}, feed);
            c.move_w(level, plunge_feed);
            if (w.turn != 0) c.arc(w.centre, w.turn, level, feed);
            follow(c, w.run, level, feed);
            if (w.turn != 0) c.arc(w.centre, w.turn, level, feed);
        }
        c.move_w(cuts.clearance, cuts.retract);
    }
}

}  // namespace obrys::cycles
