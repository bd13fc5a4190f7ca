#include "cl/spline.hpp"

#include <algorithm>

#include "base/whole.hpp"
#include "cl/totals.hpp"

namespace obrys::cl {

namespace {

geom::Vec3 unit(geom::Vec3 v) {
    const double l = geom::length(v);
    return l == 0 ? v : (1 / l) * v;
}

/// An arc's radius vector and rise, with 0 along the coordinates that are not known and lie across the circle.
struct Spoke {
    geom::Vec3 radius, rise;
};
Spoke spoke_of(geom::Vec3 from, const Arc& arc) {
    const auto known = [](double v, double n) { return std::isnan(v) && std::abs(n) == 1 ? 0.0 : v; };
    const geom::Vec3 spoke = travel(arc.centre, from), way = travel(from, arc.to);
    const geom::Vec3 &n = arc.normal, s{known(spoke.x, n.x), known(spoke.y, n.y), known(spoke.z, n.z)};
    return {s - geom::dot(s, n) * n, geom::dot(way, n) * n};
}

geom::Vec3 turned(geom::Vec3 v, geom::Vec3 normal, double angle) {
    return std::cos(angle) * v + std::sin(angle) * geom::cross(normal, v);
}

/// Direction on an arc after `angle` of its sweep.
geom::Vec3 direction_on(geom::Vec3 from, const Arc& arc, double angle) {
    if (arc.sweep == 0) return {};
    const Spoke s = spoke_of(from, arc);
    return unit(arc.sweep * geom::cross(arc.normal, turned(s.radius, arc.normal, angle)) + s.rise);
}

}  // namespace

geom::Cubic curve(const Spline& s) { return {s.to, s.k1, s.k2, s.k3}; }
geom::Cubic forward(const Spline& s) { return geom::reversed(curve(s)); }
Spline spline_of(const geom::Cubic& forward) {
    const geom::Cubic c = geom::reversed(forward);
    Spline s;
    s.to = c.k0;
    s.k1 = c.k1;
    s.k2 = c.k2;
    s.k3 = c.k3;
    return s;
}
Spline spline_of(const geom::Cubic& forward, geom::Vec3 to) {
    Spline s = spline_of(forward);
    s.to = to;
    return s;
}
geom::Vec3 start_of(const Spline& s) { return geom::point_at(curve(s), 1); }
geom::Polynomial3 curve(const SplineAxis& a) { return {a.to, a.k1, a.k2, a.k3}; }

geom::Vec3 start_gap(geom::Vec3 position, const Spline& s) { return travel(position, start_of(s)); }

geom::Vec3 first_direction(geom::Vec3 from, const Step& move) {
    if (const auto* spline = std::get_if<Spline>(&move)) return geom::leaving(forward(*spline));
    if (const auto* arc = std::get_if<Arc>(&move)) return direction_on(from, *arc, 0);
    return unit(travel(from, position_after(from, move)));
}

geom::Vec3 last_direction(geom::Vec3 from, const Step& move) {
    if (const auto* spline = std::get_if<Spline>(&move)) return -1 * geom::leaving(curve(*spline));
    if (const auto* arc = std::get_if<Arc>(&move)) return direction_on(from, *arc, arc->sweep);
    return unit(travel(from, position_after(from, move)));
}

Joint join(geom::Vec3 position, geom::Vec3 arriving, const Spline& next) {
    const geom::Vec3 gap = start_gap(position, next);
    return {gap, geom::length(gap), geom::angle_between(arriving, geom::leaving(forward(next)))};
}

Joint join(const Spline& before, const Spline& next) { return join(before.to, last_direction({}, before), next); }

void points_between(geom::Vec3 from, const Step& move, double tolerance, int most,
                    base::FunctionRef<void(geom::Vec3)> point) {
    if (const auto* spline = std::get_if<Spline>(&move)) {
        const geom::Cubic c = forward(*spline);
        const int count = std::min(geom::chord_count(c, tolerance), most);
        for (int i = 1; i < count; ++i) point(geom::point_at(c, static_cast<double>(i) / count));
    } else if (const auto* arc = std::get_if<Arc>(&move)) {
        const Spoke s = spoke_of(from, *arc);
        const double radius = geom::length(s.radius);
        if (!std::isfinite(radius + arc->sweep)) return;
        // A chord over the angle a leaves the circle by r (1 - cos(a/2)), which is below r a^2 / 8.
        const double count =
            std::min(std::ceil(std::abs(arc->sweep) * std::sqrt(radius / (8 * tolerance))), static_cast<double>(most));
        const int chords = base::clipped<int>(count, 0, most);
        for (int i = 1; i < chords; ++i) {
            const double part = i / count;
            const geom::Vec3 way = turned(s.radius, arc->normal, part * arc->sweep) - s.radius + part * s.rise;
            point({from.x + way.x, from.y + way.y, from.z + way.z});
        }
    }
}

}  // namespace obrys::cl
