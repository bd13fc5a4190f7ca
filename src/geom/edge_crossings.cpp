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

Crossings line_arc(const Edge& line, const Edge& arc, double tolerance) {
    Crossings c;
    const Circle k = circle(arc);
    const double l = chord(line);
    if (l == 0) return c;
    const Vec2 u = (1 / l) * (line.b - line.a);
    const double off = cross(u, k.centre - line.a), h2 = (k.radius - off) * (k.radius + off);
    const Vec2 foot = line.a + dot(k.centre - line.a, u) * u;
    if (std::abs(off) >= k.radius) {
        if (std::abs(off) <= k.radius + tolerance) keep(c, line, arc, foot, tolerance);
        return c;
    }
    const double h = std::sqrt(h2);
    keep(c, line, arc, foot - h * u, tolerance);
    keep(c, line, arc, foot + h * u, tolerance);
    return c;
}

Crossings arc_arc(const Edge& e, const Edge& f, double tolerance) {
    Crossings c;
    const Circle k = circle(e), m = circle(f);
    const double d = distance(k.centre, m.centre), dr = std::abs(k.radius - m.radius);
    if (d + dr <= tolerance) return c;  // one circle
    if (d > k.radius + m.radius + tolerance || d < dr - tolerance || d == 0) return c;
    const Vec2 u = (1 / d) * (m.centre - k.centre);
    const double a = 0.5 * (d + (k.radius - m.radius) * (k.radius + m.radius) / d);
    if (std::abs(a) >= k.radius) {
        keep(c, e, f, k.centre + std::copysign(k.radius, a) * u, tolerance);
        return c;
    }
    const double h = std::sqrt((k.radius - a) * (k.radius + a));
    keep(c, e, f, k.centre + a * u - h * left_of(u), tolerance);
    keep(c, e, f, k.centre + a * u + h * left_of(u), tolerance);
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
