#include "geom/sweep.hpp"

#include <algorithm>
#include <cmath>

#include "base/whole.hpp"
#include "geom/arrangement.hpp"
#include "geom/boolean.hpp"
#include "geom/tolerance.hpp"

namespace obrys::geom {

namespace {

/// Angles w + k pi strictly inside from .. from + sweep, as fractions of the sweep, in order.
std::vector<double> fractions(double w, double from, double sweep) {
    std::vector<double> out;
    const double lo = std::min(from, from + sweep), hi = std::max(from, from + sweep);
    for (double a = w + pi * std::ceil((lo - w) / pi); a < hi; a += pi)
        if (const double t = (a - from) / sweep; t > 1e-12 && t < 1 - 1e-12) out.push_back(t);
    std::sort(out.begin(), out.end());
    return out;
}

/// The edge in parts along which it does not turn past the direction `d`.
std::vector<Edge> parts_beside(const Edge& e, Vec2 d) {
    if (!is_arc(e)) return {e};
    const Vec2 t = tangent_at(e, 0);
    std::vector<Edge> out;
    double last = 0;
    for (const double f : fractions(std::atan2(d.y, d.x), std::atan2(t.y, t.x), sweep_angle(e))) {
        out.push_back(part(e, last, f));
        if (out.size() > 1) out.back().a = out[out.size() - 2].b;
        last = f;
    }
    out.push_back(last == 0 ? e : part(e, last, 1));
    if (out.size() > 1) out.back().a = out[out.size() - 2].b;
    return out;
}

Contour positive_loop(std::vector<Edge> loop) {
    const Contour c = contour_of(loop);
    return area(c) < 0 ? reversed(c) : c;
}

/// An arc edge along an arc: (u, t), u the edge's angle about its centre, t the path's, map to m + r e(u) + R e(t). The
/// map folds where u - t is a multiple of pi; between folds it is one to one, and its sides are arcs.
struct Corner {
    double u = 0, t = 0;
};
class ArcAlongArc {
public:
    ArcAlongArc(Vec2 middle, double edge_radius, double path_radius)
        : middle_(middle), r_(edge_radius), R_(path_radius) {}

    /// `box`: corners of the rectangle of angles; loops between the folds.
    void loops(const std::array<Corner, 4>& box, std::vector<Contour>& out) const {
        double lo = box[0].u - box[0].t, hi = lo;
        for (const Corner& c : box) {
            lo = std::min(lo, c.u - c.t);
            hi = std::max(hi, c.u - c.t);
        }
        for (double k = std::floor(lo / pi + 1e-12); k * pi < hi - 1e-12; ++k) {
            std::vector<Corner> strip = clipped({box.begin(), box.end()}, k * pi, 1);
            strip = clipped(strip, (k + 1) * pi, -1);
            if (strip.size() < 3) continue;
            std::vector<Edge> loop;
            for (std::size_t i = 0; i < strip.size(); ++i) side(strip[i], strip[(i + 1) % strip.size()], loop);
            if (loop.size() > 1) out.push_back(positive_loop(loop));
        }
    }

private:
    [[nodiscard]] Vec2 at(Corner c) const {
        return middle_ + r_ * Vec2{std::cos(c.u), std::sin(c.u)} + R_ * Vec2{std::cos(c.t), std::sin(c.t)};
    }
    /// The part with sign * (u - t - fold) >= 0.
    static std::vector<Corner> clipped(const std::vector<Corner>& in, double fold, double sign) {
        std::vector<Corner> out;
        for (std::size_t i = 0; i < in.size(); ++i) {
            const Corner &p = in[i], &q = in[(i + 1) % in.size()];
            const double dp = sign * (p.u - p.t - fold), dq = sign * (q.u - q.t - fold);
            if (dp >= 0) out.push_back(p);
            if ((dp > 0 && dq < 0) || (dp < 0 && dq > 0)) {
                const double s = dp / (dp - dq);
                out.push_back({p.u + s * (q.u - p.u), p.t + s * (q.t - p.t)});
            }
        }
        return out;
    }
    void side(Corner p, Corner q, std::vector<Edge>& loop) const {
        const double du = q.u - p.u, dt = q.t - p.t;
        // Along u the edge's arc, along t the path's, along a fold both turn alike.
        const double sweep = std::abs(du) > std::abs(dt) ? du : dt;
        if (std::abs(sweep) < 1e-15) return;
        const Vec2 a = loop.empty() ? at(p) : loop.back().b;
        loop.push_back({a, at(q), std::tan(sweep / 4)});
    }

    Vec2 middle_;
    double r_, R_;
};

void line_along_arc(const Edge& e, Vec2 centre, double radius, double from, double sweep, std::vector<Contour>& out) {
    const Vec2 d = e.b - e.a;
    std::vector<double> stops{0};
    for (const double f : fractions(std::atan2(d.y, d.x) - pi / 2, from, sweep)) stops.push_back(f);
    stops.push_back(1);
    for (std::size_t i = 0; i + 1 < stops.size(); ++i) {
        const Edge path = arc_about(centre, radius, from + stops[i] * sweep, (stops[i + 1] - stops[i]) * sweep);
        const Edge ahead = moved(path, e.b), back = reversed(moved(path, e.a));
        out.push_back(positive_loop({{back.b, ahead.a, 0}, ahead, {ahead.b, back.a, 0}, back}));
    }
}

void edge_along_arc(const Edge& e, Vec2 centre, double radius, double from, double sweep, std::vector<Contour>& out) {
    if (!is_arc(e)) return line_along_arc(e, centre, radius, from, sweep, out);
    const int n = base::clipped<int>(std::ceil(std::abs(sweep_angle(e)) / (pi / 2) - 1e-9), 1, 4);
    const Circle c = circle(e);
    const double u0 = std::atan2(e.a.y - c.centre.y, e.a.x - c.centre.x), step = sweep_angle(e) / n;
    const ArcAlongArc map(c.centre + centre, c.radius, radius);
    for (int i = 0; i < n; ++i) {
        const double u = u0 + i * step, v = u + step, t = from + sweep;
        map.loops({Corner{u, from}, Corner{v, from}, Corner{v, t}, Corner{u, t}}, out);
    }
}

}  // namespace

Region sweep_straight(const Contour& outline, Vec2 by) {
    if (length(by) <= snap) return {{moved(outline, by)}};
    // One closed curve: parts that face the way of the motion stand at its end, the others at its start, joined by the
    // motion itself. It winds about a point as often as the point's path cuts the outline's area (convolution).
    std::vector<Edge> parts;
    for (const Edge& e : edges(outline))
        for (const Edge& p : parts_beside(e, by)) parts.push_back(p);
    std::vector<Edge> curve;
    bool was_ahead = false, convex = true;
    int changes = 0;
    for (std::size_t i = 0; i <= parts.size(); ++i) {
        const Edge& e = parts[i % parts.size()];
        const bool forward = cross(by, tangent_at(e, 0.5)) > 0;  // its outer side, the right one, looks ahead
        if (i > 0 && forward != was_ahead) {
            ++changes;
            curve.push_back(forward ? Edge{e.a, e.a + by, 0} : Edge{e.a + by, e.a, 0});
        }
        if (i < parts.size()) curve.push_back(forward ? moved(e, by) : e);
        was_ahead = forward;
    }
    for (std::size_t i = 0; i < parts.size() && convex; ++i) {
        const Edge &e = parts[i], &f = parts[(i + 1) % parts.size()];
        convex = e.bulge >= 0 && cross(tangent_at(e, 1), tangent_at(f, 0)) > -1e-12;
    }
    const Contour c = contour_of(joined(curve, true));
    if (convex && changes == 2) return {{c}};
    return positive({c});
}

Region sweep_round(const Contour& outline, Vec2 centre, double radius, double from, double sweep) {
    const Vec2 start = centre + radius * Vec2{std::cos(from), std::sin(from)};
    std::vector<Contour> loops{moved(outline, start)};
    const double whole = std::clamp(sweep, -2 * pi, 2 * pi);
    const int n = base::clipped<int>(std::ceil(std::abs(whole) / (pi / 2) - 1e-9), 1, 4);
    for (int i = 0; i < n; ++i)
        for (const Edge& e : edges(outline)) edge_along_arc(e, centre, radius, from + i * whole / n, whole / n, loops);
    return positive(loops);
}

}  // namespace obrys::geom
