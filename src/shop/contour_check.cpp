#include "shop/contour_check.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace obrys::shop {

namespace {

using geom::Vec2;

constexpr double one_point = 1e-7;  ///< mm; points closer than this are one point

struct Edge {
    Vec2 a, b;
    double sweep = 0;  ///< radians, 0: straight
    Vec2 centre;
    double radius = 0;
    Vec2 low, high;  ///< box
};

Edge make_edge(geom::Vertex v, Vec2 b) {
    Edge e{v.p, b, 0, {}, 0, {}, {}};
    e.low = {std::min(v.p.x, b.x), std::min(v.p.y, b.y)};
    e.high = {std::max(v.p.x, b.x), std::max(v.p.y, b.y)};
    if (v.bulge == 0) return e;
    e.sweep = 4 * std::atan(v.bulge);
    // The centre stands left of the chord at (1 - bulge^2) / (4 bulge) chord lengths from its middle.
    const Vec2 chord = b - v.p;
    const double k = (1 - v.bulge * v.bulge) / (4 * v.bulge);
    e.centre = 0.5 * (v.p + b) + k * geom::left_of(chord);
    e.radius = geom::distance(e.centre, v.p);
    e.low = e.centre - Vec2{e.radius, e.radius};
    e.high = e.centre + Vec2{e.radius, e.radius};
    return e;
}

/// Angle from the arc's start to `p` in the arc's own sense, 0 … 2 pi.
double angle_along(const Edge& e, Vec2 p) {
    const Vec2 s = e.a - e.centre, t = p - e.centre;
    double angle = std::atan2(geom::cross(s, t), geom::dot(s, t)) * (e.sweep > 0 ? 1 : -1);
    if (angle < 0) angle += 2 * geom::pi;
    return angle;
}

bool lies_on(const Edge& e, Vec2 p) {
    if (geom::distance(e.a, p) < one_point || geom::distance(e.b, p) < one_point) return true;
    if (e.sweep == 0) {
        const Vec2 d = e.b - e.a;
        const double l = geom::length(d);
        const double t = geom::dot(d, p - e.a) / l;
        return std::abs(geom::cross(d, p - e.a)) / l < one_point && t > 0 && t < l;
    }
    return std::abs(geom::distance(e.centre, p) - e.radius) < one_point && angle_along(e, p) < std::abs(e.sweep);
}

void meet_lines(const Edge& e, const Edge& f, std::vector<Vec2>& out) {
    const Vec2 d = e.b - e.a, g = f.b - f.a;
    const double det = geom::cross(d, g);
    if (std::abs(det) < 1e-12 * geom::length(d) * geom::length(g)) return;
    out.push_back(e.a + (geom::cross(f.a - e.a, g) / det) * d);
}

void meet_line_arc(const Edge& line, const Edge& arc, std::vector<Vec2>& out) {
    const Vec2 d = (1 / geom::distance(line.a, line.b)) * (line.b - line.a);
    const double t = geom::dot(arc.centre - line.a, d);
    const Vec2 foot = line.a + t * d;
    const double h = geom::distance(foot, arc.centre);
    if (h > arc.radius + one_point) return;
    const double half = std::sqrt(std::max(0.0, arc.radius * arc.radius - h * h));
    out.push_back(foot + half * d);
    out.push_back(foot - half * d);
}

void meet_arcs(const Edge& e, const Edge& f, std::vector<Vec2>& out) {
    const Vec2 d = f.centre - e.centre;
    const double l = geom::length(d);
    if (l < one_point || l > e.radius + f.radius + one_point || l < std::abs(e.radius - f.radius) - one_point) return;
    const double t = (l * l + e.radius * e.radius - f.radius * f.radius) / (2 * l);
    const double half = std::sqrt(std::max(0.0, e.radius * e.radius - t * t));
    const Vec2 u = (1 / l) * d;
    out.push_back(e.centre + t * u + half * geom::left_of(u));
    out.push_back(e.centre + t * u - half * geom::left_of(u));
}

bool boxes_meet(const Edge& e, const Edge& f) {
    return e.low.x <= f.high.x + one_point && f.low.x <= e.high.x + one_point && e.low.y <= f.high.y + one_point &&
           f.low.y <= e.high.y + one_point;
}

/// True where the edges share a point that is not in `corners`, the corners they share by construction.
bool meet(const Edge& e, const Edge& f, const std::vector<Vec2>& corners) {
    if (!boxes_meet(e, f)) return false;
    std::vector<Vec2> points{e.a, e.b, f.a, f.b};  // ends catch overlaps of one line or one circle
    if (e.sweep == 0 && f.sweep == 0)
        meet_lines(e, f, points);
    else if (e.sweep == 0)
        meet_line_arc(e, f, points);
    else if (f.sweep == 0)
        meet_line_arc(f, e, points);
    else
        meet_arcs(e, f, points);
    return std::any_of(points.begin(), points.end(), [&](Vec2 p) {
        const bool shared =
            std::any_of(corners.begin(), corners.end(), [&](Vec2 c) { return geom::distance(c, p) < 10 * one_point; });
        return !shared && lies_on(e, p) && lies_on(f, p);
    });
}

}  // namespace

double signed_area(const geom::Contour& closed) {
    double sum = 0;
    const std::size_t n = closed.vertices.size();
    for (std::size_t i = 0; i < n; ++i) {
        const Edge e = make_edge(closed.vertices[i], closed.vertices[(i + 1) % n].p);
        sum += geom::cross(e.a, e.b) / 2;
        if (e.sweep != 0) sum += e.radius * e.radius * (e.sweep - std::sin(e.sweep)) / 2;
    }
    return sum;
}

geom::Contour reversed(const geom::Contour& contour) {
    geom::Contour out;
    out.closed = contour.closed;
    const std::size_t n = contour.vertices.size();
    for (std::size_t i = 0; i < n; ++i) {
        const std::size_t from = n - 1 - i;
        // The edge from here to the next vertex of the result began at that vertex.
        out.vertices.push_back({contour.vertices[from].p, -contour.vertices[(from + n - 1) % n].bulge});
    }
    if (!out.closed && n > 0) out.vertices.back().bulge = 0;
    for (geom::Vertex& v : out.vertices)
        if (v.bulge == 0) v.bulge = 0;  // no -0
    return out;
}

double lowest_y(geom::Vertex a, geom::Vec2 b) {
    const Edge e = make_edge(a, b);
    const double ends = std::min(e.a.y, e.b.y);
    const Vec2 bottom = e.centre - Vec2{0, e.radius};
    return e.sweep != 0 && lies_on(e, bottom) ? std::min(ends, bottom.y) : ends;
}

std::optional<std::pair<std::size_t, std::size_t>> first_crossing(const geom::Contour& closed) {
    const std::size_t n = closed.vertices.size();
    std::vector<Edge> edges;
    for (std::size_t i = 0; i < n; ++i) edges.push_back(make_edge(closed.vertices[i], closed.vertices[(i + 1) % n].p));
    for (std::size_t i = 0; i < n; ++i)
        for (std::size_t j = i + 1; j < n; ++j) {
            std::vector<Vec2> corners;
            if (j == i + 1) corners.push_back(edges[j].a);
            if (i == 0 && j == n - 1) corners.push_back(edges[i].a);
            if (meet(edges[i], edges[j], corners)) return std::pair{i, j};
        }
    return std::nullopt;
}

}  // namespace obrys::shop
