#include <algorithm>
#include <cmath>
#include <utility>

#include "geom/interpolation.hpp"
#include "geom/ridge.hpp"
#include "write/staircase.hpp"
#include "write/staircase_steps.hpp"

namespace obrys::write {

namespace {

/// The plane of an arc about an axis: its two coordinates, so that the first turns into the second about that axis.
std::optional<std::array<std::size_t, 2>> plane_about(const geom::Vec3& normal) {
    const std::array<double, 3> n{std::abs(normal.x), std::abs(normal.y), std::abs(normal.z)};
    for (std::size_t k = 0; k < 3; ++k)
        if (n[k] > 1 - level_noise) return std::array<std::size_t, 2>{(k + 1) % 3, (k + 2) % 3};
    return std::nullopt;
}

double radius_of(const cl::Arc& arc, const geom::Vec3& from) {
    const geom::Vec3 out = from - arc.centre;
    return geom::length(out - geom::dot(out, arc.normal) * arc.normal);
}

/// Angles from the start at which an arc passes from one quadrant to the next, of all its turns.
std::vector<double> quadrant_angles(const cl::Arc& arc, const geom::Vec3& from) {
    const auto plane = *plane_about(arc.normal);
    const auto out = coordinates(from - arc.centre);
    const double quadrants = std::atan2(out[plane[1]], out[plane[0]]) / (geom::pi / 2);
    const bool ccw = (arc.normal.x + arc.normal.y + arc.normal.z) * arc.sweep > 0;
    const double first = ccw ? std::floor(quadrants) + 1 - quadrants : quadrants - std::ceil(quadrants) + 1;
    std::vector<double> angles;
    for (double k = 0; (first + k) * geom::pi / 2 < std::abs(arc.sweep); ++k)
        angles.push_back((first + k) * geom::pi / 2);
    return angles;
}

/// Steps of an arc of which none has a chord that leads farther from it than `deviation` on its way along the axes.
double chord_steps(double sweep, double radius, double deviation) {
    constexpr double share = 1.6;  // half of it the corner over the chord, a fifth of it the arc over the chord
    const double chord = std::min(share * deviation, radius);
    return parts_of_at_most(sweep, 2 * std::asin(chord / (2 * radius)));
}

/// Of a way of two legs: how near it comes to a point, and how far from it.
std::array<double, 2> reach(const geom::Vec2& a, const geom::Vec2& corner, const geom::Vec2& b, const geom::Vec2& c) {
    std::array<double, 2> out{geom::distance(a, c), geom::distance(corner, c)};
    for (const auto& [from, to] : {std::pair{a, corner}, std::pair{corner, b}}) {
        const geom::Vec2 way = to - from;
        const double length = geom::dot(way, way);
        const double t = length > 0 ? std::clamp(geom::dot(c - from, way) / length, 0.0, 1.0) : 0;
        out[0] = std::min(out[0], geom::distance(from + t * way, c));
    }
    return out;
}

}  // namespace

/// Shares of an arc at which its steps end; where it passes quadrants, too, if asked.
static std::vector<double> shares_of(const cl::Arc& arc, const geom::Vec3& from, double steps, bool quadrants) {
    const double sweep = std::abs(arc.sweep);
    std::vector<double> shares = quadrants ? quadrant_angles(arc, from) : std::vector<double>{};
    for (double& angle : shares) angle /= sweep;
    for (double k = 1; k < steps; ++k) shares.push_back(k / steps);
    std::sort(shares.begin(), shares.end());
    shares.push_back(1);
    return shares;
}

void Staircase::take_arc(const cl::Arc& as_it_is, const geom::Vec3& begin) {
    cl::Arc arc = as_it_is;
    geom::Vec3 from = begin;
    const bool no_height = std::isnan(from.z) && std::isnan(arc.to.z) && arc.normal.z != 0;  // and needs none
    if (no_height) from.z = arc.to.z = arc.centre.z = 0;
    const bool known = geom::is_finite(from) && geom::is_finite(arc.centre) && std::isfinite(arc.sweep);
    const double radius = known ? radius_of(arc, from) : NAN;
    const auto plane = plane_about(arc.normal);
    if (!known || !plane || !(radius > still)) {
        stands_ = coordinates(arc.to);
        return lose(plane ? "an arc of which not all is known" : "an arc in a plane that is none of the axes'");
    }
    begin_stairs(sums_.arcs);
    const bool is_level = (*plane)[0] == 0;
    if (no_height) stands_[2] = 0;
    if (!(is_level ? level_arc(arc, from, radius) : standing_arc(arc, from, radius))) stands_ = coordinates(arc.to);
    if (no_height) stands_[2] = NAN;
}

/// In the plane of X and Y, or a helix along Z.
bool Staircase::level_arc(const cl::Arc& arc, const geom::Vec3& from, double radius) {
    const Side on = side();
    const double sweep = std::abs(arc.sweep), tool = on.diameter / 2;
    const bool inner = on.left == (arc.sweep * arc.normal.z > 0);
    const bool touches = on.known && tool > 0;
    const double contour = inner ? radius + tool : std::max(0.0, radius - tool);
    double steps = chord_steps(sweep, radius, form_.deviation);
    if (touches) {
        steps = steps_for(sweep, geom::ridge_step_angle(contour, {on.diameter, form_.roughness}, !inner));
        if (form_.away > 0) steps = std::max(steps, chord_steps(sweep, radius, form_.away));
    }
    const double rise = std::abs(arc.to.z - from.z);
    if (rise > still) steps = std::max(steps, parts_of_at_most(rise, form_.roughness));
    if (!may_run(steps)) return false;
    const bool outward = !on.known || !inner;
    const geom::Vec2 centre = level(arc.centre);
    const geom::PathElement path = geom::Circular{from, arc.to, arc.centre, arc.normal, arc.sweep};
    const Way stairs{[&](double t) { return t < 1 ? geom::point_at(path, t) : arc.to; },
                     [&](geom::Vec2 a, geom::Vec2 b) {
                         const geom::Vec2 x_first{b.x, a.y}, y_first{a.x, b.y};
                         const bool x_is_farther = geom::distance(x_first, centre) > geom::distance(y_first, centre);
                         return x_is_farther == outward ? x_first : y_first;
                     },
                     [&](geom::Vec2 a, geom::Vec2 corner, geom::Vec2 b) {
                         const auto [nearest, farthest] = reach(a, corner, b, centre);
                         return std::max(radius - nearest, farthest - radius);
                     },
                     touches};
    double done = 0;
    for (const double share : shares_of(arc, from, steps, outward)) step(stairs, std::exchange(done, share), share);
    if (touches) sums_.ridge = std::max(sums_.ridge, geom::ridge_of_arc(contour, sweep / steps, on.diameter, !inner));
    if (rise > still) sums_.above = std::max(sums_.above, rise / steps);
    return true;
}

/// In a plane that holds Z: never below the path.
bool Staircase::standing_arc(const cl::Arc& arc, const geom::Vec3& from, double radius) {
    const double steps = chord_steps(std::abs(arc.sweep), radius, std::min(form_.deviation, form_.roughness / 1.6));
    if (!may_run(steps)) return false;
    const geom::PathElement path = geom::Circular{from, arc.to, arc.centre, arc.normal, arc.sweep};
    geom::Vec3 at = from;
    for (const double share : shares_of(arc, from, steps, true)) {
        const geom::Vec3 place = share < 1 ? geom::point_at(path, share) : arc.to;
        const double up = std::abs(place.z - at.z);
        sums_.above = std::max(sums_.above, up);
        sums_.either = std::max(sums_.either, std::min(up, geom::distance(level(at), level(place))));
        legs(place, geom::stair_corner(level(at), level(place), true));
        at = place;
    }
    return true;
}

}  // namespace obrys::write
