/// Source: HEIDENHAIN iTNC 530 cycle programming, pockets, studs and slots (251 to 254); the sequence of 253 also: TNC7
/// basic, cycle 253. What the sources at hand do not hold is from memory of that manual: codes of the plunging strategy
/// and of the position, finishing only where an allowance is entered, return to the called position.

#include "cycles/mill/pocket_data.hpp"

#include <algorithm>
#include <cmath>

#include "cycles/levels.hpp"
#include "geom/offset.hpp"

namespace obrys::cycles {

using geom::Contour;
using geom::Vec2;

namespace {

/// mm: a room narrower than this is a line.
constexpr double no_room = 1e-6;

}  // namespace

PocketData pocket_data(Course& c, const MilledFigure& d, const Situation& s) {
    PocketData p;
    p.h = heights_of(d);
    p.lift = p.h.clearance - p.h.surface;
    p.radius = milling_radius(c, s);
    p.called = {s.at.x, s.at.y};
    c.known(s.at.z, "the tool's height");
    p.operation = c.whole(Role::operation, d.operation, 0, 0, 2, "the machining operation");
    p.position = c.whole(Role::position, d.position, 0, 0, 4, "the position");
    p.side = d.allowance_side.value_or(0);
    p.floor = d.allowance_floor.value_or(0);
    p.infeed = d.infeed;
    p.finish_infeed = d.finish_infeed.value_or(0);
    p.mill = d.feed_mill;
    p.plunge = d.feed_plunge;
    p.finish = unless_0(d.feed_finish, p.mill);
    p.climb = d.direction.value_or(1) >= 0;
    p.rotation = geom::radians(d.rotation.value_or(0));
    const double overlap = d.overlap.value_or(1);
    if (overlap <= 0 || overlap >= 2) c.fault(Role::overlap, "the path overlap factor must be above 0 and below 2");
    p.stepover = overlap * p.radius;
    p.descent.feed = p.plunge;
    const int how = c.whole(Role::plunge, d.plunge, 0, 0, 2, "the plunging strategy");
    p.descent.how = how == 1 ? Plunge::helix : how == 2 ? Plunge::reciprocate : Plunge::straight;
    if (p.operation != 2) set_angle(c, s, p.descent);
    if (s.tool_cutting_length > 0 && p.descent.angle > 0)
        p.descent.length = std::max(4 * p.radius, s.tool_cutting_length / std::tan(p.descent.angle));
    return p;
}

namespace {

Cuts cuts_of(const PocketData& p, bool convex) {
    Cuts cuts;
    cuts.top = p.h.surface;
    cuts.clearance = p.h.clearance;
    cuts.lift = p.lift;
    cuts.direct = convex;
    cuts.retract = rapid_retract;
    return cuts;
}

AreaPaths paths_of(Course& c, const PocketData& p, const PocketFigure& f, double side) {
    if (!f.middle.vertices.empty() && geom::offset(f.region, -p.radius - side - no_room).empty())
        return {{placed(f.middle, f.where)}, {}};
    AreaPaths paths = area_paths(
        c, f.region, {.radius = p.radius, .side = side, .stepover = p.stepover, .climb = p.climb, .where = f.where});
    if (f.convex)
        for (Contour& tour : paths.tours)
            tour.vertices.insert(tour.vertices.begin(), geom::Vertex{placed(f.start, f.where)});
    return paths;
}

void rough(Course& c, const PocketData& p, const PocketFigure& f) {
    Cuts cuts = cuts_of(p, f.convex);
    cuts.levels = even_levels(c, p.h.surface, p.h.bottom + p.floor, p.infeed);
    const AreaPaths paths = paths_of(c, p, f, p.side);
    if (c.ready()) mill_tours(c, paths, cuts, p.radius, p.descent, p.mill);
}

void finish(Course& c, const PocketData& p, const PocketFigure& f) {
    if (p.side > 0) {
        Cuts cuts = cuts_of(p, f.convex);
        cuts.levels =
            even_levels(c, p.h.surface, p.h.bottom, p.finish_infeed > 0 ? p.finish_infeed : p.h.surface - p.h.bottom);
        const geom::Region room = geom::offset(f.region, -p.radius);
        if (room.empty()) complain_of_room(c, f.region, {.radius = p.radius, .where = f.where}, true);
        if (!c.ready()) return;
        mill_walls(c, walls_of(room, {.arc = p.radius, .climb = p.climb, .where = f.where}), cuts, p.plunge, p.finish);
    }
    if (p.floor > 0) {
        Cuts cuts = cuts_of(p, f.convex);
        cuts.levels = {p.h.bottom};
        cuts.top = p.h.bottom + p.floor;
        const AreaPaths paths = paths_of(c, p, f, 0);
        if (!c.ready()) return;
        mill_tours(c, paths, cuts, p.radius, {.feed = p.plunge}, p.finish);
    }
}

}  // namespace

void mill_pocket(Course& c, const PocketData& p, const PocketFigure& f) {
    if (p.h.bottom + p.floor > p.h.surface)
        c.fault(Role::allowance_floor, "the finishing allowance for floor is larger than the depth");
    check_size(c, placed(f.region, f.where));
    if (!c.ready()) return;
    c.rapid_w(std::max(c.at().z, p.h.clearance));
    if (p.operation != 2) rough(c, p, f);
    if (c.ready() && p.operation != 1) finish(c, p, f);
    if (!c.ready()) return;
    c.rapid_w(p.h.end);
    if (p.position == 0) c.rapid({p.called.x, p.called.y, p.h.end});
}

}  // namespace obrys::cycles
