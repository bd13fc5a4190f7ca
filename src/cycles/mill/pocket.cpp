/// Rectangular and circular pockets. Source: HEIDENHAIN iTNC 530 cycle programming (251, 252, 4, 5); parameters as in
/// dialect/heidenhain/cycle_parameters. The path between plunge and wall the manuals do not give.

#include <algorithm>
#include <cmath>

#include "cycles/mill/families.hpp"
#include "cycles/mill/pocket_data.hpp"

namespace obrys::cycles {

namespace {

using geom::Vec2;

constexpr std::string_view rings =
    "the path in the pocket: equidistant rings from the inside outwards, one radius or what the overlap says apart";

/// Centre of a rectangle whose corner (1 lower left, 2 lower right, 3 upper right, 4 upper left) is the called
/// position.
Vec2 centre_from_corner(int position, double length, double width) {
    const double u = length / 2, v = width / 2;
    switch (position) {
        case 1: return {u, v};
        case 2: return {-u, v};
        case 3: return {-u, -v};
        case 4: return {u, -v};
        default: return {};
    }
}

double corner_of(Course& c, const Said& said, double length, double width) {
    const double corner = said.value_or(0);
    if (corner > std::min(length, width) / 2 + 1e-9)
        c.fault(Role::corner_radius, "the corner radius is larger than half the pocket's side");
    return std::min(corner, std::min(length, width) / 2);
}

/// Old forms: the tool stands above the centre at the set-up clearance, to which it returns; depths and clearances may
/// be written with either sign. The stepover is the tool's radius times a machine parameter (MP7430), taken as 1.
PocketData old_data(Course& c, const OldPocket& d, const Situation& s) {
    PocketData p;
    p.h.end = p.h.clearance = c.known(s.at.z, "the tool's height");
    p.lift = std::abs(d.clearance);
    p.h.surface = p.h.clearance - p.lift;
    p.h.bottom = p.h.surface + d.depth;
    p.radius = milling_radius(c, s);
    p.infeed = std::abs(d.infeed);
    p.plunge = d.feed_plunge;
    p.mill = d.feed_mill;
    p.climb = d.direction.value_or(1) >= 0;
    p.stepover = p.radius;
    p.operation = 1;
    p.descent.feed = p.plunge;
    p.called = {s.at.x, s.at.y};
    c.assume(
        "the path in the pocket: equidistant rings from the inside outwards, one tool radius apart (the factor of the "
        "machine parameters is not known)");
    return p;
}

}  // namespace

void write_steps(Course& c, const RectangularPocket& d, const Situation& s) {
    const PocketData p = pocket_data(c, d, s);
    const double corner = corner_of(c, d.corner_radius, d.length, d.width);
    if (!c.ready()) return;
    c.assume(rings);
    const Vec2 centre = centre_from_corner(p.position, d.length, d.width);
    mill_pocket(c, p, {{{geom::moved(rectangle(d.length, d.width, corner), centre)}}, {p.rotation, p.called}, centre});
}

void write_steps(Course& c, const CircularPocket& d, const Situation& s) {
    const PocketData p = pocket_data(c, d, s);
    if (!c.ready()) return;
    c.assume(rings);
    mill_pocket(c, p, {{{disc(d.diameter / 2)}}, {0, p.called}, {}});
}

void write_steps(Course& c, const OldRectangularPocket& d, const Situation& s) {
    using Cycle = OldRectangularPocket;
    const PocketData p = old_data(c, d, s);
    // The sides are named by axes; the working plane is X Y, Y Z or Z X.
    const bool x = d.axis_x.has_value(), y = d.axis_y.has_value();
    const auto first = x && y ? &Cycle::axis_x : y ? &Cycle::axis_y : &Cycle::axis_z;
    const auto second = x && y ? &Cycle::axis_y : y ? &Cycle::axis_z : &Cycle::axis_x;
    const double length = std::abs(asked(c, d, first, Must::be_known));
    const double width = std::abs(asked(c, d, second, Must::be_known));
    if (length == 0 || width == 0) c.fault("the sides of the pocket must not be 0");
    const double corner = corner_of(c, d.corner_radius, length, width);
    if (!c.ready()) return;
    mill_pocket(c, p, {{{rectangle(length, width, corner)}}, {0, p.called}, {}});
}

void write_steps(Course& c, const OldCircularPocket& d, const Situation& s) {
    const PocketData p = old_data(c, d, s);
    if (!c.ready()) return;
    mill_pocket(c, p, {{{disc(d.radius)}}, {0, p.called}, {}});
}

}  // namespace obrys::cycles
