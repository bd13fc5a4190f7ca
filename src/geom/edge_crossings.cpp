#include <algorithm>
#include <cmath>

#include "geom/edge.hpp"

namespace obrys::geom {

namespace {

void keep(Crossings& c, const Edge& e, const Edge& f, Vec2 p, double tolerance) {
    if (distance(e, p) <= tolerance && distance(f, p) <= tolerance) c.points[static_cast<std::size_t>(c.count++)] = p;
}

Crossings line_line(const Edge& e, const Edge& f, double tolerance) {
    Crossings c;
    const Vec2 u = e.b - e.a, v = f.b - f.a, w = f.a - e.a;
    const double det = cross(u, v), le = length(u), lf = length(v);
    if (std::abs(det) <= 1e-14 * le * lf) return c;
    const double s = cross(w, v) / det, t = cross(w, u) / det;
    if (s * le < -tolerance || (s - 1) * le > tolerance || t * lf < -tolerance || (t - 1) * lf > tolerance) return c;
    c.points[0] = e.a + s * u;
    c.count = 1;
    return c;
}

/// Where the line through `q` along the unit vector `u` meets the arc's circle: q + t u. No centre is used, as that of
/// a nearly straight arc is not known well.
struct Roots {
    double t[2] = {0, 0};
    double discriminant = 0;  ///< negative: no meeting, t is the place nearest to the circle
};
Roots meet_circle(Vec2 q, Vec2 u, const Edge& arc) {
    const double k = (1 - arc.bulge * arc.bulge) / (4 * arc.bulge);
    const double half = dot(q - 0.5 * (arc.a + arc.b), u) - k * cross(arc.b - arc.a, u), constant = power(arc, q);
    Roots r;
    r.discriminant = half * half - constant;
    if (r.discriminant <= 0) {
        r.t[0] = r.t[1] = -half;
        return r;
    }
    const double far = -(half + std::copysign(std::sqrt(r.discriminant), half));
    r.t[0] = constant / far;
    r.t[1] = far;
    return r;
}

Crossings line_arc(const Edge& line, const Edge& arc, double tolerance) {
    Crossings c;
    const double l = chord(line);
    if (l == 0) return c;
    const Vec2 u = (1 / l) * (line.b - line.a);
    const Vec2 q = line.a + dot(0.5 * (arc.a + arc.b) - line.a, u) * u;
    const Roots r = meet_circle(q, u, arc);
    keep(c, line, arc, q + r.t[0] * u, tolerance);
    if (r.discriminant > 0) keep(c, line, arc, q + r.t[1] * u, tolerance);
    return c;
}

Crossings arc_arc(const Edge& e, const Edge& f, double tolerance) {
    Crossings c;
    const Circle k = circle(e), m = circle(f);
    if (k.radius > m.radius) return arc_arc(f, e, tolerance);
    const double d = distance(k.centre, m.centre), dr = m.radius - k.radius;
    const double slack = tolerance + 1e-15 * (k.radius + m.radius);
    if (d + dr <= tolerance) return c;  // one circle
    if (d > k.radius + m.radius + slack || d < dr - slack || d == 0) return c;
    // the points of equal power lie on a line
    const Vec2 o = 0.5 * (e.a + e.b), w = m.centre - k.centre, u = (1 / length(w)) * left_of(w);
    const double at = 0.5 * (0.25 * dot(e.b - e.a, e.b - e.a) + power(f, o));
    const Vec2 q = o + (at / dot(w, w)) * w;
    const Roots r = meet_circle(q, u, e);
    if (r.discriminant <= 0) {
        const Vec2 p = q + r.t[0] * u, from_centre = p - k.centre;
        if (from_centre == Vec2{}) return c;
        keep(c, e, f, p - (outside(e, p) / length(from_centre)) * from_centre, tolerance);
        return c;
    }
    keep(c, e, f, q + r.t[0] * u, tolerance);
    keep(c, e, f, q + r.t[1] * u, tolerance);
    return c;
}

}  // namespace

Crossings crossings(const Edge& e, const Edge& f, double tolerance) {
    const bool curved_e = is_arc(e), curved_f = is_arc(f);
    if (curved_e && curved_f) return arc_arc(e, f, tolerance);
    if (curved_e) return line_arc(f, e, tolerance);
    if (curved_f) return line_arc(e, f, tolerance);
    return line_line(e, f, tolerance);
}

}  // namespace obrys::geom
