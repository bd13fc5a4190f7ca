#include "path/arc_input.hpp"

#include <algorithm>
#include <cmath>

#include "path/element.hpp"

namespace obrys::path {

using geom::Vec2;
using geom::Vec3;

namespace {

double sign(Sense s) { return s == Sense::counter_clockwise ? 1.0 : -1.0; }

ArcResult failed(ArcFailure f, double difference = 0) {
    ArcResult r;
    r.failure = f;
    r.radius_difference = difference;
    return r;
}

double with_turns(double sweep, int turns, Sense sense) {
    return sweep + sign(sense) * geom::full_turn * std::max(turns, 0);
}

double sweep_between(Vec2 from, Vec2 to, Vec2 centre, Sense sense) {
    if (geom::distance(from, to) <= same_point) return sign(sense) * geom::full_turn;
    const double a = sign(sense) * turn_between(from - centre, to - centre);
    return sign(sense) * (a <= 0 ? a + geom::full_turn : a);
}

/// The centre moved along the chord to be equally far from both ends.
Vec2 balanced(Vec2 from, Vec2 to, Vec2 centre) {
    const Vec2 chord = to - from;
    const double length = geom::length(chord);
    if (length <= same_point) return centre;
    const double start = geom::distance(from, centre), end = geom::distance(to, centre);
    const double shift = (end - start) * (end + start) / (2 * length);
    return std::abs(shift) > 10 * std::abs(end - start) ? centre : centre + (shift / length) * chord;
}

/// The arc over a chord with the centre `height` to the left of it.
ArcResult over_chord(Vec2 from, Vec2 to, double height, Sense sense, int turns) {
    const Vec2 chord = to - from;
    ArcResult r;
    r.to = to;
    r.centre = 0.5 * (from + to) + (height / geom::length(chord)) * geom::left_of(chord);
    r.sweep = with_turns(sweep_between(from, to, r.centre, sense), turns, sense);
    return r;
}

}  // namespace

ArcResult arc_by_centre(Vec2 from, Vec2 to, Vec2 centre, Sense sense, int turns, const ArcTolerance& tolerance) {
    const double start = geom::distance(from, centre), end = geom::distance(to, centre);
    if (start <= same_point) return failed(ArcFailure::no_radius, end - start);
    const double radius = tolerance.keep_centre ? std::max(start, end) : start;
    if (!(std::abs(end - start) <= std::max(tolerance.absolute, tolerance.relative * radius)))
        return failed(ArcFailure::radius_mismatch, end - start);
    ArcResult r;
    r.to = to;
    r.centre = tolerance.keep_centre ? centre : balanced(from, to, centre);
    r.sweep = with_turns(sweep_between(from, to, r.centre, sense), turns, sense);
    r.radius_difference = end - start;
    return r;
}

ArcResult arc_by_radius(Vec2 from, Vec2 to, double radius, Sense sense, int turns, const ArcTolerance& tolerance) {
    const double half = 0.5 * geom::distance(from, to), r = std::abs(radius);
    if (half <= 0.5 * same_point) return failed(ArcFailure::points_coincide);
    if (!(half - r <= std::max(tolerance.absolute, tolerance.relative * r)) || r <= same_point)
        return failed(ArcFailure::radius_too_small, half - r);
    const double height = r > half ? std::sqrt((r - half) * (r + half)) : 0;
    const bool left = (sense == Sense::counter_clockwise) == (radius > 0);
    ArcResult result = over_chord(from, to, left ? height : -height, sense, turns);
    if (height == 0) result.sweep = with_turns(sign(sense) * geom::pi, turns, sense);
    return result;
}

ArcResult arc_by_angle(Vec2 from, Vec2 to, double angle, Sense sense, int turns) {
    if (!(angle > 0 && angle < geom::full_turn)) return failed(ArcFailure::bad_angle);
    const double half = 0.5 * geom::distance(from, to);
    if (half <= 0.5 * same_point) return failed(ArcFailure::points_coincide);
    // cot(angle / 2) changes sign at half a turn, where the centre crosses the chord.
    const double height = half * std::cos(0.5 * angle) / std::sin(0.5 * angle);
    ArcResult r = over_chord(from, to, sign(sense) * height, sense, turns);
    r.sweep = with_turns(sign(sense) * angle, turns, sense);
    return r;
}

ArcResult arc_about_centre(Vec2 from, Vec2 centre, double angle, Sense sense, int turns) {
    if (!(angle > 0 && angle <= geom::full_turn)) return failed(ArcFailure::bad_angle);
    if (geom::distance(from, centre) <= same_point) return failed(ArcFailure::no_radius);
    ArcResult r;
    r.centre = centre;
    r.to = angle == geom::full_turn ? from : centre + rotated(from - centre, sign(sense) * angle);
    r.sweep = with_turns(sign(sense) * angle, turns, sense);
    return r;
}

ArcResult arc_by_tangent(Vec2 from, Vec2 to, Vec2 direction) {
    const Vec2 chord = to - from;
    const double length = geom::length(chord);
    if (!(geom::length(direction) > 0)) return failed(ArcFailure::no_direction);
    if (length <= same_point) return failed(ArcFailure::points_coincide);
    const double half = turn_between(direction, chord);
    // The arc's sagitta below same_point is a line; straight back there is no finite circle either.
    if (std::abs(std::sin(half)) * length < same_point) return failed(ArcFailure::collinear);
    ArcResult r;
    r.to = to;
    r.sweep = 2 * half;
    const double radius = length / (2 * std::sin(half));
    r.centre = from + (radius / geom::length(direction)) * geom::left_of(direction);
    return r;
}

ArcInSpace arc_through(const Vec3& from, const Vec3& via, const Vec3& to, const Vec3& plane_normal) {
    ArcInSpace r;
    const Vec3 a = via - from, b = to - from;
    if (geom::length(a) <= same_point || geom::distance(via, to) <= same_point) {
        r.failure = ArcFailure::points_coincide;
        return r;
    }
    if (geom::length(b) <= same_point) {
        r.centre = 0.5 * (from + via);
        r.normal = plane_normal;
        r.sweep = geom::full_turn;
        return r;
    }
    const Vec3 n = geom::cross(a, b);
    const double area = geom::length(n);
    if (area <= same_point * std::max(geom::length(a), geom::length(b))) {
        r.failure = ArcFailure::collinear;
        return r;
    }
    // Circumcentre of the triangle, relative to `from`.
    const Vec3 c = (0.5 / (area * area)) * (geom::dot(a, a) * geom::cross(b, n) + geom::dot(b, b) * geom::cross(n, a));
    r.centre = from + c;
    r.normal = (1.0 / area) * n;
    const Vec3 start = from - r.centre, end = to - r.centre;
    r.sweep = std::atan2(geom::dot(r.normal, geom::cross(start, end)), geom::dot(start, end));
    if (r.sweep <= 0) r.sweep += geom::full_turn;
    return r;
}

}  // namespace obrys::path
