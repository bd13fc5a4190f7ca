#include "geom/offset.hpp"

#include "geom/boolean.hpp"
#include "geom/tolerance.hpp"

namespace obrys::geom {

namespace {

// A point outside a region and within d of it lies beside an edge, at most d away on its outer side (in its band), or in
// the sector about a corner between the normals of its edges. One closed curve goes around the region, all bands and
// all sectors at once, sides that two of them share left out: it winds about a point once for each of them it lies in.

/// The edge's far side, `d` to its right.
struct Shifted {
    std::vector<Edge> far;        ///< runs from the far end of one side of the band to that of the other
    Vec2 normal_a, normal_b;      ///< d long
    bool cut = false;             ///< the band ends at the arc's centre, nearer than d
};

Shifted shifted(const Edge& e, double d) {
    Shifted out;
    out.normal_a = -d * left_of(tangent_at(e, 0));
    out.normal_b = -d * left_of(tangent_at(e, 1));
    const bool towards_centre = is_arc(e) && e.bulge < 0;
    if (towards_centre && circle(e).radius <= d + snap) {
        const Vec2 centre = circle(e).centre;
        out.cut = true;
        out.far = {{e.a, centre, 0}, {centre, e.b, 0}};
    } else {
        out.far = {{e.a + out.normal_a, e.b + out.normal_b, is_arc(e) ? e.bulge : 0}};
    }
    return out;
}

/// From the far end of one edge's band around the corner `v` to the next one's.
void go_around(Vec2 v, const Shifted& before, const Shifted& after, std::vector<Edge>& curve) {
    const Vec2 n = before.normal_b, m = after.normal_a;
    const Vec2 end = after.cut ? v : v + m;
    const bool alike = distance(n, m) <= snap;
    const auto line_to = [&](Vec2 p) {
        if (p != curve.back().b) curve.push_back({curve.back().b, p, 0});
    };
    if (alike && !before.cut && !after.cut) return line_to(end);
    const double turn = std::atan2(cross(n, m), dot(n, m));
    // A cusp, where the outline turns straight back, is rounded: at an outer one the two normals are opposite.
    const bool outer = !alike && (turn > 0 || turn < -pi + 1e-9);
    if (outer) {
        line_to(v + n);
        const double sweep = turn > 0 ? turn : turn + 2 * pi;
        curve.push_back({v + n, v + m, std::tan(0.25 * sweep)});
    } else {
        line_to(v);
    }
    line_to(end);
}

Contour grown(const Contour& c, double d) {
    const std::vector<Edge> around = edges(c);
    std::vector<Shifted> sides;
    sides.reserve(around.size());
    for (const Edge& e : around) sides.push_back(shifted(e, d));
    std::vector<Edge> curve;
    for (std::size_t i = 0; i < sides.size(); ++i) {
        curve.insert(curve.end(), sides[i].far.begin(), sides[i].far.end());
        go_around(around[i].b, sides[i], sides[(i + 1) % sides.size()], curve);
    }
    return contour_of(curve);
}

}  // namespace

Region offset(const Region& r, double by) {
    if (by == 0) return r;
    // Inward, what is outside grows: its contours are the region's, reversed.
    std::vector<Contour> curves;
    for (const Contour& c : r.contours) {
        if (edges(c).empty()) continue;
        curves.push_back(by > 0 ? grown(c, by) : reversed(grown(reversed(c), -by)));
    }
    return positive(curves);
}

}  // namespace obrys::geom
