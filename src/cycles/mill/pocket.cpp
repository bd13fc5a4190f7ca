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

double read_corner(Course& c, double length, double width) {
    const double corner = c.maybe_at_least(Role::corner_radius, 0, 0);
    if (corner > std::min(length, width) / 2 + 1e-9)
        c.fault(Role::corner_radius, "the corner radius is larger than half the pocket's side");
    return std::min(corner, std::min(length, width) / 2);
}

void rectangular(Course& c, const Situation& s) {
    const PocketData p = read_pocket(c, s, true);
    const double length = c.positive(Role::length), width = c.positive(Role::width);
    const double corner = read_corner(c, length, width);
    if (!c.ready()) return;
    c.assume(rings);
    const Vec2 centre = centre_from_corner(p.position, length, width);
    mill_pocket(c, p, {{{geom::moved(rectangle(length, width, corner), centre)}}, {p.rotation, p.called}, centre});
}

void circular(Course& c, const Situation& s) {
    const PocketData p = read_pocket(c, s, true);
    const double diameter = c.positive(Role::diameter);
    if (!c.ready()) return;
    c.assume(rings);
    mill_pocket(c, p, {{{disc(diameter / 2)}}, {0, p.called}, {}});
}

/// Old forms: the tool stands above the centre at the set-up clearance, to which it returns; depths and clearances may
/// be written with either sign. The stepover is the tool's radius times a machine parameter (MP7430), taken as 1.
PocketData read_simple(Course& c, const Situation& s) {
    PocketData p;
    p.h.end = p.h.clearance = c.known(s.at.z, "the tool's height");
    p.lift = std::abs(c.need(Role::clearance));
    p.h.surface = p.h.clearance - p.lift;
    p.h.bottom = p.h.surface + c.depth();
    p.radius = milling_radius(c, s);
    p.infeed = std::abs(c.need(Role::infeed));
    if (p.infeed == 0) c.fault(Role::infeed, "the plunging depth must not be 0");
    p.plunge = c.feed(Role::feed_plunge);
    p.mill = c.feed(Role::feed_mill);
    p.climb = c.maybe(Role::direction, 1) >= 0;
    p.stepover = p.radius;
    p.operation = 1;
    p.descent.feed = p.plunge;
    p.called = {s.at.x, s.at.y};
    c.assume(
        "the path in the pocket: equidistant rings from the inside outwards, one tool radius apart (the factor of the "
        "machine parameters is not known)");
    return p;
}

void rectangular_simple(Course& c, const Demand& d, const Situation& s) {
    const PocketData p = read_simple(c, s);
    // The sides are named by axes; the working plane is X Y, Y Z or Z X.
    const bool x = d.find(Role::axis_x).has_value(), y = d.find(Role::axis_y).has_value();
    const Role first = x && y ? Role::axis_x : y ? Role::axis_y : Role::axis_z;
    const Role second = x && y ? Role::axis_y : y ? Role::axis_z : Role::axis_x;
    const double length = std::abs(c.need(first)), width = std::abs(c.need(second));
    if (length == 0 || width == 0) c.fault("the sides of the pocket must not be 0");
    const double corner = read_corner(c, length, width);
    if (!c.ready()) return;
    mill_pocket(c, p, {{{rectangle(length, width, corner)}}, {0, p.called}, {}});
}

void circular_simple(Course& c, const Situation& s) {
    const PocketData p = read_simple(c, s);
    const double radius = c.positive(Role::radius);
    if (!c.ready()) return;
    mill_pocket(c, p, {{{disc(radius)}}, {0, p.called}, {}});
}

}  // namespace

void expand_pocket(Course& c, const Demand& d, const Situation& s) {
    switch (d.kind) {
        case Kind::rectangular_pocket: return rectangular(c, s);
        case Kind::circular_pocket: return circular(c, s);
        case Kind::rectangular_pocket_simple: return rectangular_simple(c, d, s);
        default: return circular_simple(c, s);
    }
}

}  // namespace obrys::cycles
