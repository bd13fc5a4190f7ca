#include "path/compensation/held_corner.hpp"

#include <cmath>

namespace obrys::path {

using geom::Vec2;

Vec2 leaving(Vec2 point, Vec2 centre, double turn) { return (-turn) * geom::left_of(unit(centre - point)); }

HeldTurn turn_at(Vec2 point, Vec2 to, Vec2 direction, double offset) {
    const double side = std::copysign(1.0, offset);
    const Vec2 along = (-side) * geom::left_of(unit(to - point));
    return {point, to, along, direction, offset, -side * geom::cross(along, direction), geom::dot(along, direction)};
}

Meeting line_meets_line(const HeldTurn& t) {
    const double back =
        std::abs(t.offset) * t.sine / (1 + t.cosine);  // radius by the tangent of half the angle, inner: < 0
    return {t.to + back * t.along};
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
    const double part = (-radius * t.cosine + (inside ? tool : -tool)) / own;
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
