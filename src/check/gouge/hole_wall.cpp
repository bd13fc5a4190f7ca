#include "check/gouge/hole_wall.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>

#include "base/whole.hpp"

namespace obrys::check {

using geom::Vec3;

namespace {

constexpr std::size_t hole_directions = 36;  ///< about the axis
constexpr std::size_t wide_from = 10;        ///< directions of an arc that has a circle of its own
constexpr std::size_t least_points = 8;      ///< of an arc
constexpr double no_circle_from = 0.5;       ///< of what is allowed: farther off than this nearly all must not be
constexpr double nearly_all = 0.98;

/// The circle of least squares, u2 + v2 = 2 a u + 2 b v + c, and how far points lie off it.
struct Circle {
    double radius = 0;
    std::vector<double> off;
};

double share(std::vector<double> v, double part) {
    const auto n = base::clipped<std::size_t>(part * static_cast<double>(v.size()), 0, v.size() - 1);
    std::nth_element(v.begin(), v.begin() + static_cast<std::ptrdiff_t>(n), v.end());
    return v[n];
}

std::optional<Circle> circle_of(const std::vector<WallPoint>& points, Vec3 axis) {
    const Vec3 aside = std::abs(axis.x) < 0.6 ? Vec3{1, 0, 0} : Vec3{0, 1, 0};
    const Vec3 first = cross(axis, aside), u = (1 / length(first)) * first, v = cross(axis, u);
    Vec3 centre;
    for (const WallPoint& p : points) centre = centre + (1.0 / static_cast<double>(points.size())) * p.at;
    double uu = 0, uv = 0, vv = 0, us = 0, vs = 0, sum = 0;
    for (const WallPoint& p : points) {
        const double x = dot(p.at - centre, u), y = dot(p.at - centre, v), s = x * x + y * y;
        uu += x * x, uv += x * y, vv += y * y, us += x * s, vs += y * s, sum += s;
    }
    const double det = uu * vv - uv * uv;
    if (!(det > 1e-6 * uu * vv)) return std::nullopt;
    const double a = (us * vv - vs * uv) / (2 * det), b = (vs * uu - us * uv) / (2 * det);
    Circle circle{std::sqrt(a * a + b * b + sum / static_cast<double>(points.size())), {}};
    for (const WallPoint& p : points) {
        const Vec3 spoke = p.at - centre - a * u - b * v;
        circle.off.push_back(std::abs(length(spoke - dot(spoke, axis) * axis) - circle.radius));
    }
    return circle;
}

/// From the axis to a point.
Vec3 spoke_to(const HoleAxis& axis, Vec3 p) {
    const Vec3 from = p - axis.foot;
    return from - dot(from, axis.along) * axis.along;
}

/// In how many directions from the axis points lie.
std::size_t width_of(const std::vector<WallPoint>& arc, const HoleAxis& axis) {
    const Vec3 u = spoke_to(axis, arc.front().at), v = cross(axis.along, u);
    std::array<bool, hole_directions> met{};
    for (const WallPoint& p : arc) {
        const Vec3 spoke = spoke_to(axis, p.at);
        const double turn = std::atan2(dot(spoke, v), dot(spoke, u)) / (2 * geom::pi) + 0.5;
        met[base::clipped<std::size_t>(turn * static_cast<double>(hole_directions), 0, hole_directions - 1)] = true;
    }
    return static_cast<std::size_t>(std::count(met.begin(), met.end(), true));
}

double middle_about(const HoleAxis& axis, const std::vector<WallPoint>& arc) {
    std::vector<double> radii;
    for (const WallPoint& p : arc) radii.push_back(length(spoke_to(axis, p.at)));
    return middle(std::move(radii));
}

}  // namespace

double middle(std::vector<double> v) {
    std::nth_element(v.begin(), v.begin() + static_cast<std::ptrdiff_t>(v.size() / 2), v.end());
    return v[v.size() / 2];
}

/// Each move's arc has its own circle, wherever that lies. One too short for a circle says something only where the
/// whole is none.
std::optional<HoleRadii> radii_of(const std::vector<WallPoint>& wall, const HoleAxis& axis, double allowed) {
    const std::optional<Circle> whole = circle_of(wall, axis.along);
    const bool one = whole && middle(whole->off) <= allowed;
    const bool no_circle = !one || share(whole->off, nearly_all) > no_circle_from * allowed;
    std::map<std::uint32_t, std::vector<WallPoint>> arcs;
    for (const WallPoint& p : wall) arcs[p.tag].push_back(p);
    constexpr double none = std::numeric_limits<double>::infinity();
    HoleRadii radii{one ? whole->radius : none, one ? whole->radius : none};
    for (const auto& [tag, arc] : arcs) {
        if (arc.size() < least_points) continue;
        if (width_of(arc, axis) < wide_from) {
            if (no_circle) radii.least = std::min(radii.least, middle_about(axis, arc));
            continue;
        }
        const std::optional<Circle> own = circle_of(arc, axis.along);
        if (own && middle(own->off) <= allowed) radii.least = std::min(radii.least, own->radius);
    }
    if (!one) radii.fitted = radii.least;
    if (!std::isfinite(radii.least)) return std::nullopt;
    return radii;
}

}  // namespace obrys::check
