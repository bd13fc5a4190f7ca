/// Studs, and the finishing cycles of pockets and studs. Source: HEIDENHAIN iTNC 530 cycle programming (256, 257, 212
/// to 215); 256 also TNC 128, cycle 256. Where beside the stud the tool goes down the sources at hand do not say for
/// these.

#include <algorithm>
#include <cmath>

#include "cycles/levels.hpp"
#include "cycles/mill/families.hpp"
#include "cycles/mill/pocket_data.hpp"
#include "geom/offset.hpp"

namespace obrys::cycles {

namespace {

using geom::Contour;
using geom::Region;
using geom::Vec2;

constexpr double most_stepovers = 10'000;
constexpr std::string_view beside =
    "where beside the figure the tool goes down, and the arcs to and from it: quarter "
    "circles of the tool's radius at most, in the middle of the longest element";

/// Around the stud, from the blank inwards; `farthest`: how far the blank reaches beyond the stud.
void mill_stud(Course& c, const PocketData& p, const Region& stud, double farthest) {
    const Placement where{p.rotation, p.called};
    const double passes = std::max(1.0, std::ceil((farthest - p.side) / p.stepover - 1e-9));
    check_size(c, placed(stud, where));
    if (passes > most_stepovers) c.fault(Role::overlap, "the stepover is too small for the blank");
    if (!c.ready()) return;
    const std::vector<double> levels = even_levels(c, p.h.surface, p.h.bottom, p.infeed);
    if (!c.ready()) return;
    c.rapid_w(std::max(c.at().z, p.h.end));
    double above = p.h.clearance;
    for (const double level : levels) {
        const Cuts cuts{.top = above,
                        .clearance = p.h.clearance,
                        .levels = {level},
                        .lift = p.lift,
                        .direct = false,
                        .retract = rapid_retract};
        for (double i = passes - 1; i >= 0 && c.room(); --i) {
            const Region path = geom::offset(stud, p.radius + p.side + i * p.stepover);
            mill_walls(c, walls_around(path, {.arc = p.radius, .climb = p.climb, .where = where}), cuts, p.plunge,
                       p.mill);
        }
        above = level;
    }
    c.rapid_w(p.h.end);
    if (p.position == 0) c.rapid({p.called.x, p.called.y, p.h.end});
}

/// How far the corner of a blank reaches beyond a rectangle with rounded corners, sides lying alike.
double beyond(double length, double width, double corner, double blank_length, double blank_width) {
    const double u = blank_length / 2 - (length / 2 - corner), v = blank_width / 2 - (width / 2 - corner);
    return std::max({0.0, std::hypot(std::max(0.0, u), std::max(0.0, v)) - corner, (blank_length - length) / 2,
                     (blank_width - width) / 2});
}

/// 212 to 215: one run along the wall on every level. The figure stands about the centre that the cycle names.
struct Finishing {
    Heights h;
    double radius = 0, mill = 0, plunge = 0, infeed = 0;
    Vec2 centre;
};

Finishing finishing_of(Course& c, const WallFinishing& d, const Situation& s) {
    Finishing f;
    f.h = heights_of(d);
    f.radius = milling_radius(c, s);
    c.known(s.at.z, "the tool's height");
    f.infeed = d.infeed;
    f.mill = d.feed_mill;
    f.plunge = unless_0(d.feed_plunge, f.mill);
    f.centre = {d.centre_u, d.centre_v};
    return f;
}

void run_along(Course& c, const Finishing& f, const Contour& figure, bool outside) {
    const Placement where{0, f.centre};
    const Region region{{figure}};
    check_size(c, placed(region, where));
    if (!c.ready()) return;
    const Region path = geom::offset(region, outside ? f.radius : -f.radius);
    if (path.empty())
        c.fault("tool radius too large: the tool does not fit into the pocket at " + place_text(f.centre),
                "use a smaller tool");
    Cuts cuts{.top = f.h.surface,
              .clearance = f.h.clearance,
              .levels = {},
              .lift = 0,
              .direct = false,
              .retract = rapid_retract};
    cuts.levels = even_levels(c, f.h.surface, f.h.bottom, f.infeed);
    if (!c.ready()) return;
    c.assume(beside);
    const WallOptions o{.arc = f.radius, .where = where};
    c.rapid_w(std::max(c.at().z, f.h.end));
    if (!outside) c.rapid({f.centre.x, f.centre.y, c.at().z});
    mill_walls(c, outside ? walls_around(path, o) : walls_of(path, o), cuts, f.plunge, f.mill);
    c.rapid_w(f.h.end);
    c.rapid({f.centre.x, f.centre.y, f.h.end});
}

void finish_rectangle(Course& c, const RectangularFinishing& d, const Situation& s, bool outside) {
    const Finishing f = finishing_of(c, d, s);
    const double corner = d.corner_radius.value_or(0);
    if (corner > std::min(d.length, d.width) / 2 + 1e-9)
        c.fault(Role::corner_radius, "the corner radius is larger than half the side");
    if (c.ready()) run_along(c, f, rectangle(d.length, d.width, corner), outside);
}

void finish_circle(Course& c, const CircularFinishing& d, const Situation& s, bool outside) {
    const Finishing f = finishing_of(c, d, s);
    if (c.ready()) run_along(c, f, disc(d.diameter / 2), outside);
}

}  // namespace

void write_steps(Course& c, const RectangularStud& d, const Situation& s) {
    const PocketData p = pocket_data(c, d, s);
    c.not_below(Role::blank_length, d.blank_length, d.length);
    c.not_below(Role::blank_width, d.blank_width, d.width);
    const double corner = d.corner_radius.value_or(0), u = d.length / 2, v = d.width / 2;
    if (corner > std::min(u, v) + 1e-9)
        c.fault(Role::corner_radius, "the corner radius is larger than half the stud's side");
    if (!c.ready()) return;
    c.assume(beside);
    const Vec2 centres[] = {{0, 0}, {u, v}, {-u, v}, {-u, -v}, {u, -v}};
    const Region stud{
        {geom::moved(rectangle(d.length, d.width, std::min(corner, std::min(u, v))), centres[p.position])}};
    mill_stud(c, p, stud, beyond(d.length, d.width, corner, d.blank_length, d.blank_width));
}

void write_steps(Course& c, const CircularStud& d, const Situation& s) {
    const PocketData p = pocket_data(c, d, s);
    c.not_below(Role::blank_diameter, d.blank_diameter, d.diameter);
    if (!c.ready()) return;
    c.assume(beside);
    mill_stud(c, p, {{disc(d.diameter / 2)}}, (d.blank_diameter - d.diameter) / 2);
}

void write_steps(Course& c, const RectangularPocketFinishing& d, const Situation& s) {
    finish_rectangle(c, d, s, false);
}
void write_steps(Course& c, const RectangularStudFinishing& d, const Situation& s) { finish_rectangle(c, d, s, true); }
void write_steps(Course& c, const CircularPocketFinishing& d, const Situation& s) { finish_circle(c, d, s, false); }
void write_steps(Course& c, const CircularStudFinishing& d, const Situation& s) { finish_circle(c, d, s, true); }

}  // namespace obrys::cycles
