#include "geom/region.hpp"

namespace obrys::geom {

std::vector<Edge> edges(const Contour& c) {
    std::vector<Edge> out;
    const std::size_t n = c.vertices.size();
    if (n < 2) return out;
    out.reserve(n);
    for (std::size_t i = 0; i + (c.closed ? 0 : 1) < n; ++i) {
        const Edge e{c.vertices[i].p, c.vertices[(i + 1) % n].p, c.vertices[i].bulge};
        if (e.a != e.b) out.push_back(e);
    }
    return out;
}

std::vector<Edge> edges(const Region& r) {
    std::vector<Edge> out;
    for (const Contour& c : r.contours) {
        const auto more = edges(c);
        out.insert(out.end(), more.begin(), more.end());
    }
    return out;
}

Contour contour_of(const std::vector<Edge>& closed_chain) {
    Contour c;
    c.vertices.reserve(closed_chain.size());
    for (const Edge& e : closed_chain) c.vertices.push_back({e.a, e.bulge});
    return c;
}

double area(const Contour& c) {
    double sum = 0;
    for (const Edge& e : edges(c)) sum += area_term(e);
    return sum;
}

double area(const Region& r) {
    double sum = 0;
    for (const Contour& c : r.contours) sum += area(c);
    return sum;
}

double moment(const Region& r) {
    double sum = 0;
    for (const Edge& e : edges(r)) sum += moment_term(e);
    return sum;
}

double volume(const Region& r) { return 2 * pi * moment(r); }

double length(const Contour& c) {
    double sum = 0;
    for (const Edge& e : edges(c)) sum += length(e);
    return sum;
}

double length(const Region& r) {
    double sum = 0;
    for (const Contour& c : r.contours) sum += length(c);
    return sum;
}

Box box(const Contour& c) {
    Box b;
    for (const Edge& e : edges(c)) b.add(box(e));
    return b;
}

Box box(const Region& r) {
    Box b;
    for (const Contour& c : r.contours) b.add(box(c));
    return b;
}

int winding(const std::vector<Edge>& contours, Vec2 p) {
    int w = 0;
    for (const Edge& e : contours) w += winding_term(e, p);
    return w;
}

bool contains(const Region& r, Vec2 p) { return winding(edges(r), p) > 0; }

double distance(const Region& r, Vec2 p) {
    double d = std::numeric_limits<double>::infinity();
    for (const Edge& e : edges(r)) d = std::min(d, distance(e, p));
    return d;
}

Contour moved(const Contour& c, Vec2 by) {
    Contour out = c;
    for (Vertex& v : out.vertices) v.p = v.p + by;
    return out;
}

Contour reversed(const Contour& c) {
    Contour out;
    out.closed = c.closed;
    const std::size_t n = c.vertices.size();
    for (std::size_t i = 0; i < n; ++i)
        out.vertices.push_back({c.vertices[n - 1 - i].p, -c.vertices[(2 * n - 2 - i) % n].bulge});
    return out;
}

}  // namespace obrys::geom
