/// Cycles 20 to 24. Source: HEIDENHAIN iTNC 530 cycle programming, 7.4 contour data (20). From memory of the same
/// manual, not found again in the sources at hand: that Q19 and ANGLE choose the plunge of 22, its retraction feed, the
/// advanced stop distance of 21, the condition on the sum of radius and allowance of 24.

#include "cycles/contour/contour.hpp"

#include <algorithm>
#include <cmath>

#include "cycles/contour/train.hpp"
#include "cycles/levels.hpp"
#include "cycles/mill/milling.hpp"
#include "geom/boolean.hpp"
#include "geom/offset.hpp"

namespace obrys::cycles {

namespace {

using geom::Contour;
using geom::Region;
using geom::Vec2;

constexpr double ridge = 1e-6;  // mm

/// Contour data (20). Heights absolute.
struct Data {
    double top = 0, bottom = 0, clearance = 0, safe = 0;
    double side = 0, floor = 0, overlap = 1, rounding = 0;
    bool climb = true;
    double radius = 0;
};

Data read_data(Course& c, const Situation& s) {
    Data d;
    d.top = c.need(Role::surface);
    d.bottom = d.top + c.depth();
    d.clearance = d.top + c.at_least(Role::clearance, 0);
    d.safe = c.need(Role::clearance_height);
    d.side = c.maybe(Role::allowance_side, 0);
    d.floor = c.maybe_at_least(Role::allowance_floor, 0, 0);
    d.overlap = c.maybe(Role::overlap, 1);
    d.rounding = c.maybe_at_least(Role::rounding_radius, 0, 0);
    d.climb = c.maybe(Role::direction, 1) >= 0;
    d.radius = milling_radius(c, s);
    c.known(s.at.z, "the tool's height");
    if (d.safe < d.top) c.fault(Role::clearance_height, "the clearance height lies below the workpiece surface");
    if (d.overlap <= 0 || d.overlap >= 2) c.fault(Role::overlap, "the path overlap factor must be above 0 and below 2");
    if (d.radius + d.side < 0) c.fault(Role::allowance_side, "the negative allowance is larger than the tool radius");
    if (d.bottom + d.floor > d.top)
        c.fault(Role::allowance_floor, "the finishing allowance for floor is larger than the depth");
    return d;
}

Cuts cuts_of(const Data& d) {
    return {.top = d.top,
            .clearance = d.clearance,
            .levels = {},
            .lift = d.clearance - d.top,
            .direct = false,
            .retract = rapid_retract,
            .safe = d.safe};
}

AreaPaths paths_of(Course& c, const Data& d, const Region& area, double radius) {
    return area_paths(
        c, area,
        {.radius = radius, .side = d.side, .stepover = d.overlap * radius, .rounding = d.rounding, .climb = d.climb});
}

/// Where a coarser tool has left material that this one reaches: the places for its centre.
Region rest_room(const Region& area, const Data& d, double coarse) {
    const Region room = geom::offset(area, -d.radius - d.side);
    const Region reached = geom::offset(geom::offset(area, -coarse - d.side), coarse);
    Region rest;
    for (const Region& piece : geom::pieces(geom::subtract(geom::offset(room, d.radius), reached)))
        if (geom::area(piece) > 0.5 * ridge * geom::length(piece))
            rest.contours.insert(rest.contours.end(), piece.contours.begin(), piece.contours.end());
    if (rest.empty()) return {};
    return geom::intersect(room, geom::offset(rest, d.radius));
}

AreaPaths rough_paths(Course& c, const Data& d, const ContourTask& task) {
    if (c.maybe(Role::coarse_tool, 0) == 0) return paths_of(c, d, task.area, d.radius);
    const double coarse = c.known(task.other_radius, "the radius of the coarse roughing tool");
    if (!c.ready()) return {};
    if (coarse <= d.radius) c.fault(Role::coarse_tool, "the coarse roughing tool is not larger than the tool in use");
    const Region room = rest_room(task.area, d, coarse);
    if (room.empty()) {
        c.remark(Role::coarse_tool, "the coarse roughing tool has left nothing");
        return {};
    }
    return area_paths(c, room,
                      {.radius = d.radius, .side = -d.radius, .stepover = d.overlap * d.radius, .climb = d.climb});
}

Descent read_descent(Course& c, const Situation& s, const Data& d, double plunge) {
    Descent way;
    way.feed = c.feed_or(Role::feed_reciprocate, plunge);
    if (c.maybe(Role::feed_reciprocate, 0) == 0) return way;
    way.how = Plunge::helix;
    set_angle(c, s, way);
    if (way.angle > 0 && s.tool_cutting_length > 0)
        way.length = std::max(4 * d.radius, s.tool_cutting_length / std::tan(way.angle));
    return way;
}

void rough_out(Course& c, const Situation& s, const ContourTask& task) {
    const Data d = read_data(c, s);
    const double infeed = c.step(Role::infeed), plunge = c.feed(Role::feed_plunge), mill = c.feed(Role::feed_mill);
    const Descent way = read_descent(c, s, d, plunge);
    const double factor = c.maybe(Role::feed_factor, 100);
    if (factor != 100) c.remark(Role::feed_factor, "the feed factor for full cuts is not applied");
    Cuts cuts = cuts_of(d);
    cuts.retract = c.feed_or(Role::feed_retract, mill);
    if (!c.ready()) return;
    c.assume("the path of roughing: equidistant rings from the inside outwards, each connected part to its depth");
    cuts.levels = even_levels(c, d.top, d.bottom + d.floor, infeed);
    const AreaPaths paths = rough_paths(c, d, task);
    if (!c.ready()) return;
    mill_tours(c, paths, cuts, d.radius, way, mill);
    c.rapid_w(d.safe);
}

/// As pecking does it, at the places where roughing goes down.
void pilot_drill(Course& c, const Situation& s, const ContourTask& task) {
    const Data d = read_data(c, s);
    const double infeed = c.step(Role::infeed), plunge = c.feed(Role::feed_plunge);
    const double coarse = c.known(task.other_radius, "the radius of the rough-out tool");
    if (!c.ready()) return;
    c.assume("the places of pilot drilling: where our path of roughing begins");
    const double bottom = d.bottom + d.floor, stop = std::min(7.0, std::max(0.6, (d.top - bottom) / 50));
    const std::vector<double> levels = even_levels(c, d.top, bottom, infeed);
    const AreaPaths paths = paths_of(c, d, task.area, coarse);
    if (!c.ready()) return;
    for (const Contour& tour : paths.tours) {
        const Vec2 p = tour.vertices.front().p;
        c.rapid_w(std::max(d.safe, c.at().z));
        c.rapid({p.x, p.y, c.at().z});
        peck_down(
            c, levels,
            {.top = d.clearance, .retract_to = d.clearance, .first_stop = stop, .last_stop = stop, .feed = plunge});
    }
    c.rapid_w(d.safe);
}

void floor_finish(Course& c, const Situation& s, const ContourTask& task) {
    const Data d = read_data(c, s);
    const double plunge = c.feed(Role::feed_plunge), mill = c.feed(Role::feed_mill);
    Cuts cuts = cuts_of(d);
    cuts.retract = c.feed_or(Role::feed_retract, mill);
    if (!c.ready()) return;
    c.assume("the path on the floor: equidistant rings from the inside outwards; the tool goes straight down on it");
    cuts.top = d.bottom + d.floor;
    cuts.levels = {d.bottom};
    const AreaPaths paths = paths_of(c, d, task.area, d.radius);
    if (!c.ready()) return;
    mill_tours(c, paths, cuts, d.radius, {.feed = plunge}, mill);
    c.rapid_w(d.safe);
}

void side_finish(Course& c, const Situation& s, const ContourTask& task) {
    const Data d = read_data(c, s);
    const double infeed = c.step(Role::infeed), plunge = c.feed(Role::feed_plunge), mill = c.feed(Role::feed_mill);
    const double left = c.maybe_at_least(Role::allowance_left, 0, 0);
    if (!std::isnan(task.other_radius) && d.radius + left >= task.other_radius + d.side)
        c.fault(Role::allowance_left,
                "allowance and radius of the finishing tool together are not smaller than those of "
                "the roughing tool");
    if (!c.ready()) return;
    c.assume(
        "the arcs to and from a wall: quarter circles of the tool's radius at most, in the middle of the longest "
        "element where they find room");
    Cuts cuts = cuts_of(d);
    cuts.levels = even_levels(c, d.top, d.bottom, infeed);
    const Region room = geom::offset(task.area, -d.radius - left);
    complain_of_room(c, task.area, {.radius = d.radius, .side = left, .stepover = d.radius}, room.empty());
    if (!c.ready()) return;
    mill_walls(c, walls_of(room, {.arc = d.radius, .climb = d.climb}), cuts, plunge, mill);
    c.rapid_w(d.safe);
}

}  // namespace

bool is_contour_cycle(Kind kind) {
    return kind == Kind::pilot_drill || kind == Kind::rough_out || kind == Kind::floor_finish ||
           kind == Kind::side_finish || kind == Kind::contour_train;
}

Expansion expand_contour(const Demand& demand, const Situation& s, const ContourTask& task) {
    Course c(demand, s);
    check_size(c, task.area);
    check_size(c, {{task.train.contour}});
    switch (demand.kind) {
        case Kind::pilot_drill: pilot_drill(c, s, task); break;
        case Kind::rough_out: rough_out(c, s, task); break;
        case Kind::floor_finish: floor_finish(c, s, task); break;
        case Kind::side_finish: side_finish(c, s, task); break;
        case Kind::contour_train: expand_contour_train(c, s, task.train); break;
        default: c.not_simulated("this cycle is not simulated"); break;
    }
    return c.finish();
}

}  // namespace obrys::cycles
