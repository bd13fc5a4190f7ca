#include "geom/offset.hpp"

#include <cmath>

#include "geom/boolean.hpp"
#include "geom/tolerance.hpp"

namespace obrys::geom {

namespace {

Vec2 right_of(Vec2 v) { return -left_of(v); }

/// The strip between an edge and its equidistant on the given side (positive: right).
Contour strip(const Edge& e, double d) {
    const Vec2 a = e.a + d * right_of(tangent_at(e, 0)), b = e.b + d * right_of(tangent_at(e, 1));
    // Of an arc bent towards that side only as much as its centre lies away: beyond it, points are nearer elsewhere.
    if (is_arc(e) && (e.bulge > 0) != (d > 0)) {
        const Circle c = circle(e);
        if (c.radius <= std::abs(d)) {
            const Contour sector{{{e.a, e.bulge}, {e.b, 0}, {c.centre, 0}}, true};
            return area(sector) < 0 ? reversed(sector) : sector;
        }
    }
    const Contour s{{{e.a, e.bulge}, {e.b, 0}, {b, -e.bulge}, {a, 0}}, true};
    return area(s) < 0 ? reversed(s) : s;
}

}  // namespace

Region offset(const Region& r, double distance) {
    if (std::abs(distance) <= snap) return r;
    const double radius = std::abs(distance);
    std::vector<Contour> bands;
    for (const Edge& whole : edges(r)) {
        const int n = is_arc(whole) ? 1 + static_cast<int>(std::abs(sweep_angle(whole)) / 2) : 1;
        for (int i = 0; i < n; ++i) {
            const Edge e = part(whole, static_cast<double>(i) / n, static_cast<double>(i + 1) / n);
            if (e.a == e.b) continue;
            bands.push_back(strip(e, distance));
        }
        bands.push_back({{{whole.a - Vec2{radius, 0}, 1}, {whole.a + Vec2{radius, 0}, 1}}, true});
    }
    const Region band = positive(bands);
    return distance > 0 ? unite(r, band) : subtract(r, band);
}

}  // namespace obrys::geom
