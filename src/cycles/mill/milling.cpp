#include "cycles/mill/milling.hpp"

#include <algorithm>
#include <cmath>

#include "base/number.hpp"
#include "cycles/levels.hpp"
#include "geom/boolean.hpp"
#include "geom/clearing.hpp"
#include "geom/offset.hpp"

namespace obrys::cycles {

using geom::Contour;
using geom::Edge;
using geom::Region;
using geom::Vec2;

double milling_radius(Course& c, const Situation& s) {
    constexpr double largest = 1e4;
    const double radius = c.tool_radius(s);
    if (radius == 0) c.fault("the tool radius must be greater than 0");
    if (radius > largest) c.fault("the tool radius is out of range");
    return radius;
}

void check_size(Course& c, const Region& region) {
    constexpr double farthest = 1e6;  // the 2D kernel's snap needs the digits
    const auto near = [](Vec2 p) { return std::abs(p.x) <= farthest && std::abs(p.y) <= farthest; };
    for (const Contour& k : region.contours) {
        bool good = true;
        for (const geom::Vertex& v : k.vertices) good = good && near(v.p) && std::abs(v.bulge) <= 1e5;
        for (const Edge& e : geom::edges(k)) {
            const geom::Box b = geom::box(e);
            good = good && near(b.lo) && near(b.hi);
        }
        if (!good) return c.fault("the contour lies out of range");
    }
}

void set_angle(Course& c, const Situation& s, Descent& d) {
    if (d.how == Plunge::straight) return;
    const double degrees = s.tool_plunge_angle;
    if (std::isnan(degrees)) {
        c.remark(Role::plunge, "the tool's plunging angle is not known: it is taken straight down");
        d.how = Plunge::straight;
    } else if (degrees <= 0) {
        c.fault(Role::plunge, "the tool's plunging angle is 0: it may not plunge obliquely",
                "enter ANGLE in the tool table, or let it plunge vertically");
    } else if (degrees >= 90) {
        d.how = Plunge::straight;
    } else {
        d.angle = geom::radians(degrees);
    }
}

std::string place_text(Vec2 p) { return "u " + base::fixed(p.x, 3) + " v " + base::fixed(p.y, 3); }

std::vector<double> even_levels(Course& c, double top, double bottom, double infeed) {
    if (top - bottom <= same_depth) return {};
    return levels_of(c, top, bottom, {.first = infeed});
}

namespace {

/// A point in the part, by which it can be found.
Vec2 place_of(const Region& part) {
    const geom::Box b = geom::box(part);
    const Vec2 middle = 0.5 * (b.lo + b.hi);
    return geom::contains(part, middle) ? middle : part.contours.front().vertices.front().p;
}

}  // namespace

void complain_of_room(Course& c, const Region& region, const AreaOptions& o, bool nowhere) {
    for (const Region& part : geom::pieces(region)) {
        if (!geom::offset(part, -o.radius - o.side).empty()) continue;
        const std::string text = "tool radius too large: a tool of radius " + base::shortest(o.radius) +
                                 (o.side != 0 ? " with an allowance of " + base::shortest(o.side) : "") +
                                 " does not fit at " + place_text(placed(place_of(part), o.where));
        if (nowhere) return c.fault(text, "use a smaller tool");
        c.remark(Role::radius, text + ": nothing is machined there");
    }
    if (nowhere) c.fault("there is no area to machine");
}

AreaPaths area_paths(Course& c, const Region& region, const AreaOptions& o) {
    const geom::Clearing clearing = geom::clearing_rings(
        region,
        {.radius = o.radius, .allowance = o.side, .stepover = o.stepover, .rounding = o.rounding, .most = 5000});
    switch (clearing.fault) {
        case geom::ClearingFault::none: break;
        case geom::ClearingFault::no_room: complain_of_room(c, region, o, true); return {};
        case geom::ClearingFault::too_many:
            c.fault(Role::overlap, "the stepover is too small for the area", "enter a larger path overlap factor");
            return {};
        case geom::ClearingFault::bad_input:
            c.fault("radius, allowance or contour are not of a size that can be milled");
            return {};
    }
    complain_of_room(c, region, o, false);
    AreaPaths out{{}, placed(clearing.room, o.where)};
    for (const Contour& tour : geom::clearing_tours(clearing, !o.climb)) out.tours.push_back(placed(tour, o.where));
    return out;
}

void run_edge(Course& c, const Edge& e, double w, double feed) {
    if (std::abs(geom::sagitta(e)) > 1e-7)
        c.arc(geom::circle(e).centre, geom::sweep_angle(e), w, feed);
    else
        c.move({e.b.x, e.b.y, w}, feed);
}

void follow(Course& c, const Contour& chain, double w, double feed) {
    for (const Edge& e : geom::edges(chain)) {
        if (!c.room()) return;
        run_edge(c, e, w, feed);
    }
}

namespace {

/// The centre of a circle through `p` within the room; its radius in `radius`, 0 where there is none.
Vec2 helix_centre(const Region& room, Vec2 p, double& radius) {
    for (const double part : {1.0, 0.75, 0.5, 0.25})
        for (int i = 0; i < 16; ++i) {
            const double way = i * geom::pi / 8, r = part * radius;
            const Vec2 centre = p + r * Vec2{std::cos(way), std::sin(way)};
            if (!geom::contains(room, centre) || geom::distance(room, centre) < r - 1e-9) continue;
            radius = r;
            return centre;
        }
    radius = 0;
    return p;
}

/// The first edges of the chain, up to a length.
std::vector<Edge> first_stretch(const Contour& chain, double most, double& length) {
    std::vector<Edge> out;
    length = 0;
    for (const Edge& e : geom::edges(chain)) {
        const double l = geom::length(e);
        if (length + l >= most) {
            out.push_back(geom::part(e, 0, (most - length) / l));
            length = most;
            return out;
        }
        out.push_back(e);
        length += l;
    }
    return out;
}

void along_down(Course& c, const std::vector<Edge>& stretch, double length, double to, double feed) {
    const double from = c.at().z;
    double done = 0;
    for (const Edge& e : stretch) {
        done += geom::length(e);
        run_edge(c, e, &e == &stretch.back() ? to : from + (to - from) * done / length, feed);
    }
}

void reciprocate(Course& c, const Contour& chain, double to, double radius, const Descent& d) {
    double length = 0;
    const std::vector<Edge> there = first_stretch(chain, d.length > 0 ? d.length : 4 * radius, length);
    if (length < 1e-3) return c.move_w(to, d.feed);
    std::vector<Edge> back;
    for (std::size_t i = there.size(); i-- > 0;) back.push_back(geom::reversed(there[i]));
    const double from = c.at().z;
    // An even number of passes ends at the start.
    const double passes = 2 * std::ceil((from - to) / (2 * length * std::tan(d.angle)) - 1e-9);
    for (double i = 1; i <= passes && c.room(); ++i)
        along_down(c, std::fmod(i, 2) == 1 ? there : back, length, i == passes ? to : from + (to - from) * i / passes,
                   d.feed);
}

}  // namespace

void descend(Course& c, const Contour& chain, const Region& room, double to, double radius, const Descent& d) {
    if (c.at().z <= to || d.how == Plunge::straight) return c.move_w(to, d.feed);
    double helix = radius;
    const Vec2 centre = d.how == Plunge::helix ? helix_centre(room, {c.at().x, c.at().y}, helix) : Vec2{};
    if (d.how != Plunge::helix || helix <= 0) return reciprocate(c, chain, to, radius, d);
    const double turns = std::ceil((c.at().z - to) / (2 * geom::pi * helix * std::tan(d.angle)) - 1e-9);
    c.arc(centre, 2 * geom::pi * turns, to, d.feed);
}

void mill_tours(Course& c, const AreaPaths& paths, const Cuts& cuts, double radius, const Descent& d, double feed) {
    for (const Contour& tour : paths.tours) {
        if (tour.vertices.empty()) continue;
        const Vec2 start = tour.vertices.front().p;
        c.rapid_w(std::max({cuts.clearance, cuts.safe, c.at().z}));
        c.rapid({start.x, start.y, c.at().z});
        double above = cuts.top;
        for (const double level : cuts.levels) {
            if (!c.room()) return;
            c.rapid({start.x, start.y, c.at().z});
            c.rapid_w(std::min(cuts.clearance, above + cuts.lift));
            c.move_w(above, d.feed);
            descend(c, tour, paths.room, level, radius, d);
            follow(c, tour, level, feed);
            c.move_w(cuts.direct ? std::min(cuts.clearance, level + cuts.lift) : cuts.clearance, cuts.retract);
            above = level;
        }
        c.move_w(cuts.clearance, cuts.retract);
    }
}

}  // namespace obrys::cycles
