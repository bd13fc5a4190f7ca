#include "geom/band.hpp"

#include "geom/tolerance.hpp"

namespace obrys::geom {

namespace {

/// The edge's far side, `d` to its right.
struct Shifted {
    std::vector<Edge> far;    ///< runs from the far end of one side of the band to that of the other
    Vec2 normal_a, normal_b;  ///< d long
    bool cut = false;         ///< the band ends at the arc's centre, nearer than d
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

double curvature(const Edge& e) { return is_arc(e) ? std::copysign(1 / circle(e).radius, e.bulge) : 0; }

class Curve {
public:
    explicit Curve(double d) : d_(d) {}

    void along(const Shifted& s, std::size_t of) {
        for (const Edge& e : s.far) out_.push_back({.edge = e, .of = of, .far = !s.cut});
    }

    /// From the far end of one edge's band around the corner between the edges to the next one's.
    void around(const Edge& e, const Shifted& before, const Edge& f, const Shifted& after, std::size_t of) {
        const Vec2 v = e.b, n = before.normal_b, m = after.normal_a;
        const Vec2 end = after.cut ? v : v + m;
        const bool alike = distance(n, m) <= snap;
        if (alike && !before.cut && !after.cut) return line_to(end, of);
        const double turn = std::atan2(cross(n, m), dot(n, m));
        // A cusp, where the outline turns straight back, is rounded: at an outer one the two normals are opposite.
        const bool cusp = std::abs(turn) > pi - 1e-9, outer = !alike && (turn > 0 || cusp);
        if (outer) {
            line_to(v + n, of);
            const double sweep = turn > 0 ? turn : turn + 2 * pi;
            const bool inner = cusp && curvature(e) + curvature(f) > 1e-9 / d_;
            out_.push_back({{v + n, v + m, std::tan(0.25 * sweep)}, of, true, true, inner});
        } else {
            line_to(v, of);
        }
        line_to(end, of);
    }

    std::vector<BandEdge> take() { return std::move(out_); }

private:
    void line_to(Vec2 p, std::size_t of) {
        if (const Vec2 last = out_.back().edge.b; p != last) out_.push_back({.edge = {last, p, 0}, .of = of});
    }

    double d_;
    std::vector<BandEdge> out_;
};

}  // namespace

std::vector<BandEdge> band_right_of(const std::vector<Edge>& chain, double d) {
    std::vector<Shifted> sides;
    sides.reserve(chain.size());
    for (const Edge& e : chain) sides.push_back(shifted(e, d));
    Curve curve(d);
    for (std::size_t i = 0; i < chain.size(); ++i) {
        const std::size_t next = (i + 1) % chain.size();
        curve.along(sides[i], i);
        curve.around(chain[i], sides[i], chain[next], sides[next], i);
    }
    return curve.take();
}

}  // namespace obrys::geom
