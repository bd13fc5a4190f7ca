#include "geom/edge.hpp"

#include <algorithm>
#include <cmath>

namespace obrys::geom {

namespace {

constexpr double invisible = 1e-12;  // mm

/// theta - sin(theta) without cancellation.
double theta_less_sine(double t) {
    if (std::abs(t) > 0.3) return t - std::sin(t);
    const double q = t * t;
    return t * q / 6 * (1 - q / 20 * (1 - q / 42 * (1 - q / 72 * (1 - q / 110))));
}

double wrapped(double angle) { return std::remainder(angle, 2 * pi); }

}  // namespace

double chord(const Edge& e) { return distance(e.a, e.b); }
double sagitta(const Edge& e) { return 0.5 * e.bulge * chord(e); }
bool is_arc(const Edge& e) {
    return e.bulge != 0 && 0.25 * e.bulge * e.bulge * dot(e.b - e.a, e.b - e.a) > invisible * invisible;
}
double sweep_angle(const Edge& e) { return 4 * std::atan(e.bulge); }

Circle circle(const Edge& e) {
    const Vec2 d = e.b - e.a;
    const double k = (1 - e.bulge * e.bulge) / (4 * e.bulge);
    return {0.5 * (e.a + e.b) + k * left_of(d), length(d) * (1 + e.bulge * e.bulge) / (4 * std::abs(e.bulge))};
}

double power(const Edge& e, Vec2 p) {
    const double k = (1 - e.bulge * e.bulge) / (2 * e.bulge);
    return dot(p - e.a, p - e.b) - k * cross(e.b - e.a, p - e.a);
}

double outside(const Edge& e, Vec2 p) {
    const Circle c = circle(e);
    return power(e, p) / (distance(c.centre, p) + c.radius);
}

double length(const Edge& e) { return is_arc(e) ? circle(e).radius * std::abs(sweep_angle(e)) : chord(e); }

Box box(const Edge& e) {
    Box b;
    b.add(e.a);
    b.add(e.b);
    if (!is_arc(e)) return b;
    constexpr std::array<Vec2, 4> ways{Vec2{1, 0}, Vec2{0, 1}, Vec2{-1, 0}, Vec2{0, -1}};
    if (std::abs(e.bulge) < 1e-3) {  // the centre is far and not known well: where does the edge run across the way?
        const Vec2 d = e.b - e.a;
        const double sweep = sweep_angle(e);
        for (const Vec2 way : ways)
            if (const double turn = std::atan2(cross(d, way), dot(d, way)); std::abs(turn) < 0.5 * std::abs(sweep))
                b.add(point_at(e, 0.5 + turn / sweep));
        return b;
    }
    const Circle c = circle(e);
    for (const Vec2 dir : ways) {
        const Vec2 p = c.centre + c.radius * dir;
        // The arc lies right of its chord when it runs counter-clockwise.
        if (cross(e.b - e.a, p - e.a) * e.bulge < 0) b.add(p);
    }
    return b;
}

Edge reversed(const Edge& e) { return {e.b, e.a, -e.bulge}; }
Edge moved(const Edge& e, Vec2 by) { return {e.a + by, e.b + by, e.bulge}; }

Vec2 point_at(const Edge& e, double t) {
    const Vec2 d = e.b - e.a;
    if (e.bulge == 0) return e.a + t * d;
    // chord angle from a to the point at t, and its length over the whole chord, need no centre
    const double s = sweep_angle(e), half = 0.5 * s;
    const double k = std::sin(t * half) / std::sin(half), turn = (t - 1) * half;
    const double c = std::cos(turn), n = std::sin(turn);
    return e.a + k * Vec2{c * d.x - n * d.y, n * d.x + c * d.y};
}

Vec2 tangent_at(const Edge& e, double t) {
    const Vec2 d = (1 / chord(e)) * (e.b - e.a);
    const double turn = (t - 0.5) * sweep_angle(e), c = std::cos(turn), n = std::sin(turn);
    return {c * d.x - n * d.y, n * d.x + c * d.y};
}

double parameter(const Edge& e, Vec2 p) {
    const Vec2 d = e.b - e.a;
    if (!is_arc(e)) return dot(p - e.a, d) / dot(d, d);
    const Circle c = circle(e);
    const Vec2 r = p - c.centre, r0 = e.a - c.centre;
    // p - e.a, not r, for the sake of arcs whose centre is far; from the middle, so that both ends are met alike
    const double s = sweep_angle(e), from_start = std::atan2(cross(r0, p - e.a), dot(r0, r));
    return 0.5 + wrapped(from_start - 0.5 * s) / s;
}

Vec2 nearest(const Edge& e, Vec2 p) {
    const double t = parameter(e, p);
    if (!is_arc(e)) return t <= 0 ? e.a : t >= 1 ? e.b : e.a + t * (e.b - e.a);
    if (t >= 0 && t <= 1) {
        const Circle c = circle(e);
        const double l = distance(c.centre, p);
        if (l > 1e-6 * c.radius) return p - (outside(e, p) / l) * (p - c.centre);
        return point_at(e, t);  // near the centre the direction from it is noise, and all points are equally far
    }
    return distance(e.a, p) <= distance(e.b, p) ? e.a : e.b;
}

double distance(const Edge& e, Vec2 p) {
    if (e.a == e.b) return distance(e.a, p);
    if (is_arc(e)) {
        const double t = parameter(e, p);
        if (t >= 0 && t <= 1) return std::abs(outside(e, p));
        return std::min(distance(e.a, p), distance(e.b, p));
    }
    return distance(nearest(e, p), p);
}

Edge part(const Edge& e, double t0, double t1) {
    return {t0 == 0 ? e.a : point_at(e, t0), t1 == 1 ? e.b : point_at(e, t1),
            e.bulge == 0 ? 0 : std::tan(0.25 * (t1 - t0) * sweep_angle(e))};
}

Edge arc_about(Vec2 centre, double radius, double from, double sweep) {
    const auto at = [&](double w) { return centre + radius * Vec2{std::cos(w), std::sin(w)}; };
    return {at(from), at(from + sweep), std::tan(sweep / 4)};
}

double area_term(const Edge& e) {
    const double straight = 0.5 * cross(e.a, e.b);
    if (!is_arc(e)) return straight;
    const double r = circle(e).radius;
    return straight + 0.5 * r * r * theta_less_sine(sweep_angle(e));
}

double moment_term(const Edge& e) {
    const double straight = (e.a.x - e.b.x) * (e.a.y * e.a.y + e.a.y * e.b.y + e.b.y * e.b.y) / 6;
    if (!is_arc(e)) return straight;
    // a circular segment: its area at the centre, and 2/3 (chord/2)^3 towards the middle of the arc
    const Circle c = circle(e);
    const double segment = 0.5 * c.radius * c.radius * theta_less_sine(sweep_angle(e)), d = chord(e);
    return straight + segment * c.centre.y - d * d * (e.b.x - e.a.x) / 12;
}

int winding_term(const Edge& e, Vec2 p) {
    const double side = cross(e.b - e.a, p - e.a);
    int w = 0;
    if (e.a.y <= p.y) {
        if (e.b.y > p.y && side > 0) ++w;
    } else if (e.b.y <= p.y && side < 0) {
        --w;
    }
    if (!is_arc(e)) return w;
    // A point on the chord counts to the side the half-open rule above gives it.
    const bool on_left = side != 0 ? side > 0 : e.a.y != e.b.y ? e.a.y > e.b.y : e.a.x < e.b.x;
    if (on_left != (e.bulge > 0) && power(e, p) < 0) w += e.bulge > 0 ? 1 : -1;
    return w;
}

}  // namespace obrys::geom
