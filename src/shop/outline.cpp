#include <algorithm>
#include <cmath>

#include "shop/contour_check.hpp"
#include "shop/tool.hpp"

namespace obrys::shop {

namespace {

using geom::Contour;
using geom::Vec2;

constexpr double endless = 1000;  ///< mm, blade without a cutting depth

/// A mirroring of the plane: swap of the axes first, then signs. Turns a contour round so that it stays
/// counter-clockwise.
struct Mirror {
    bool swap = false;
    double z = 1, x = 1;
};

Contour apply(const Mirror& m, Contour c) {
    for (geom::Vertex& v : c.vertices) {
        const Vec2 p = m.swap ? Vec2{v.p.y, v.p.x} : v.p;
        v.p = {m.z * p.x + 0.0, m.x * p.y + 0.0};
    }
    const bool flips = (m.z * m.x < 0) != m.swap;
    if (!flips) return c;
    for (geom::Vertex& v : c.vertices) v.bulge = -v.bulge;
    return reversed(c);
}

/// Blade of a tool that cuts from outside: edge at x = 0, blade towards +x.
Contour blade(const Tool& t) {
    const double left = t.corner_radius_left > 0 ? t.corner_radius_left : t.corner_radius;
    const double right = t.corner_radius_right > 0 ? t.corner_radius_right : t.corner_radius;
    const double depth = t.cutting_depth > 0 ? t.cutting_depth : endless;
    const double z0 = t.reference == ReferenceCorner::left ? 0 : -t.width, z1 = z0 + t.width;
    const double slack = 1e-9 * t.width;
    if (!(t.width > 0) || left < 0 || right < 0 || left + right > t.width + slack || std::max(left, right) > depth)
        return {};
    const double quarter = std::tan(geom::pi / 8);
    Contour c;
    c.vertices.push_back({{z0 + left, 0}, 0});
    if (left + right < t.width - slack) c.vertices.push_back({{z1 - right, 0}, 0});
    if (right > 0) {
        c.vertices.back().bulge = quarter;
        c.vertices.push_back({{z1, right}, 0});
    }
    if (depth > right) c.vertices.push_back({{z1, depth}, 0});
    c.vertices.push_back({{z0, depth}, 0});
    if (left <= 0) return c;
    if (depth > left) c.vertices.push_back({{z0, left}, 0});
    c.vertices.back().bulge = quarter;
    return c;
}

Contour grooving(const Tool& t) {
    switch (t.direction) {
        case BladeDirection::out: return blade(t);
        case BladeDirection::in: return apply({.x = -1}, blade(t));
        case BladeDirection::face: return apply({.swap = true}, blade(t));
    }
    return {};
}

/// Insert that cuts from outside and feeds towards -z; `centre` is that of the nose, relative to the programmed point.
/// The main edge leaves the nose at 180 degrees less the entering angle, the other one by the tip angle further
/// clockwise.
Contour insert(const Tool& t, Vec2 centre) {
    const double main = geom::pi - geom::radians(t.entering_angle), other = main - geom::radians(t.tip_angle);
    const auto direction = [](double a) { return Vec2{std::cos(a), std::sin(a)}; };
    const Vec2 along_main = direction(main), along_other = direction(other);
    const Vec2 main_start = centre + t.nose_radius * geom::left_of(along_main);
    const Vec2 other_start = centre - t.nose_radius * geom::left_of(along_other);
    Contour c;
    c.vertices.push_back({main_start + t.edge_length * along_main, 0});
    if (t.nose_radius > 0) c.vertices.push_back({main_start, std::tan((geom::pi - geom::radians(t.tip_angle)) / 4)});
    c.vertices.push_back({other_start, 0});
    c.vertices.push_back({other_start + t.edge_length * along_other, 0});
    return c;
}

Contour turning_insert(const Tool& t) {
    if (t.nose_radius < 0 || !(t.edge_length > 0) || !(t.tip_angle > 0 && t.tip_angle < 180)) return {};
    const double r = t.nose_radius;
    const Contour corner = insert(t, {r, r}), axis = insert(t, {0, r});
    switch (t.orientation) {
        case 1: return apply({.z = -1, .x = -1}, corner);
        case 2: return apply({.x = -1}, corner);
        case 3: return corner;
        case 4: return apply({.z = -1}, corner);
        case 5: return apply({.swap = true, .z = -1}, axis);
        case 6: return apply({.x = -1}, axis);
        case 7: return apply({.swap = true}, axis);
        case 8: return axis;
        case 9: return apply({.x = t.direction == BladeDirection::in ? -1.0 : 1.0}, insert(t, {0, 0}));
        default: return {};
    }
}

}  // namespace

Contour outline(const Tool& tool) {
    switch (tool.kind) {
        case ToolKind::groove: return grooving(tool);
        case ToolKind::turning: return turning_insert(tool);
        default: return {};
    }
}

Contour sure_outline(const Tool& tool) {
    constexpr double hair = 1e-3;  // mm of edge behind the nose, so that it is a contour
    if (tool.reach_given) return outline(tool);
    Tool least = tool;
    if (tool.kind == ToolKind::turning) least.edge_length = hair;
    if (tool.kind == ToolKind::groove && tool.direction == BladeDirection::in)
        least.cutting_depth =
            std::max({tool.corner_radius, tool.corner_radius_left, tool.corner_radius_right, 0.0}) + hair;
    return outline(least);
}

std::optional<double> parameter(const Tool& tool, int n) {
    if (const auto found = tool.parameters.find(n); found != tool.parameters.end()) return found->second;
    if (n == 2 && tool.kind == ToolKind::turning) return tool.orientation;
    if (n == 3) return tool.length;
    if (n == 6 && tool.kind == ToolKind::turning) return tool.nose_radius;
    if (n == 6 && (tool.kind == ToolKind::other || is_milling(tool.kind))) return tool.radius;
    return std::nullopt;
}

std::vector<Tool> merge_tools(std::vector<Tool> first, const std::vector<Tool>& second) {
    for (const Tool& t : second) {
        const auto same = std::find_if(first.begin(), first.end(),
                                       [&](const Tool& o) { return o.number == t.number && o.edge == t.edge; });
        if (same == first.end()) {
            first.push_back(t);
            continue;
        }
        if (same->name.empty()) same->name = t.name;
        same->parameters.insert(t.parameters.begin(), t.parameters.end());
    }
    std::stable_sort(first.begin(), first.end(), [](const Tool& a, const Tool& b) {
        return std::pair(a.number, a.edge) < std::pair(b.number, b.edge);
    });
    return first;
}

}  // namespace obrys::shop
