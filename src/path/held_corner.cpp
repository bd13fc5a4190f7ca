#include "path/held_corner.hpp"

#include <cmath>

namespace obrys::path {

using geom::Vec2;

Vec2 unit(Vec2 v) {
    const double l = std::sqrt(geom::dot(v, v));  // half the time of hypot, and on every move
    return l == 0 ? Vec2{1, 0} : (1 / l) * v;
}

Vec2 leaving(Vec2 point, Vec2 centre, double turn) { return (-turn) * geom::left_of(unit(centre - point)); }

HeldTurn turn_at(Vec2 point, Vec2 to, Vec2 direction, double offset) {
    const double side = std::copysign(1.0, offset);
    HeldTurn t{point, to, (-side) * geom::left_of(unit(to - point)), direction, offset, 0};
    t.bend = -side * turn_between(t.along, direction);
    if (t.bend < -0.5 * geom::pi) t.bend += 2 * geom::pi;
    return t;
}

Meeting line_meets_line(const HeldTurn& t) {
    const double radius = std::abs(t.offset);
    const double half = 0.5 * (t.bend + geom::pi);  // of the angle between the walls
    return {t.to - (radius / std::tan(half)) * t.along};
}

Meeting arc_meets_line(const HeldTurn& t, const HeldEnd& held) {
    const double tool = std::abs(t.offset), radius = geom::distance(held.to, held.centre);
    const bool inside = runs_inside(t.offset, held.turn);
    const double programmed = inside ? radius + tool : radius - tool;
    const Vec2 across = held.turn * geom::left_of(t.direction);
    // the parallel's distance from the arc's centre, in parts of the radius
    const double d = programmed * geom::dot(across, unit(held.centre - t.point));
    const double part = (inside ? d - tool : d + tool) / radius;
    if (part > 1 || part < -1) return {{}, Refusal::arc_line_unreachable};
    const double behind = std::sqrt(1 - part * part);
    return {held.centre - radius * (part * across + (inside ? behind : -behind) * t.direction)};
}

Meeting line_meets_arc(const HeldTurn& t, Vec2 centre, double radius, double turn) {
    const double tool = std::abs(t.offset);
    const bool inside = runs_inside(t.offset, turn);
    const double own = inside ? radius - tool : radius + tool;
    const double part = (-radius * std::cos(t.bend) + (inside ? tool : -tool)) / own;
    if (part > 1 || part < -1) return {{}, Refusal::arc_unreachable};
    const double ahead = std::sqrt(1 - part * part);
    return {centre + own * ((inside ? ahead : -ahead) * t.along + turn * part * geom::left_of(t.along))};
}

Meeting arc_meets_arc(double offset, const HeldEnd& held, Vec2 centre, double radius, double turn) {
    const double tool = std::abs(offset), old = geom::distance(held.to, held.centre);
    const double own = runs_inside(offset, turn) ? radius - tool : radius + tool;
    const double apart = geom::distance(held.centre, centre);
    if (old == 0 || apart == 0) return {{}, Refusal::same_centre};
    const double part = (old * old + apart * apart - own * own) / (2 * old * apart);
    if (part > 1 || part < -1) return {{}, Refusal::arc_arc_unreachable};
    const bool left = runs_inside(offset, held.turn) == (turn > 0);
    const Vec2 towards = unit(centre - held.centre);
    const double aside = std::sqrt(1 - part * part);
    return {held.centre + old * (part * towards + (left ? aside : -aside) * geom::left_of(towards))};
}

}  // namespace obrys::path
