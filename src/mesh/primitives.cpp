#include "mesh/primitives.hpp"

#include <algorithm>
#include <cmath>

#include "base/whole.hpp"
#include "mesh/topology.hpp"

namespace obrys::mesh {

using geom::Vec3;

Mesh box(Vec3 lo, Vec3 hi) {
    Mesh m;
    if (!(lo.x < hi.x && lo.y < hi.y && lo.z < hi.z)) return m;
    // Vertex number by bits: 1 = far in x, 2 = far in y, 4 = far in z.
    for (unsigned i = 0; i < 8; ++i)
        m.vertices.push_back({(i & 1U) != 0 ? hi.x : lo.x, (i & 2U) != 0 ? hi.y : lo.y, (i & 4U) != 0 ? hi.z : lo.z});
    m.triangles = {{0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}, {0, 1, 5}, {0, 5, 4},
                   {2, 6, 7}, {2, 7, 3}, {0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}};
    return m;
}

std::optional<Box> as_box(const Mesh& m) {
    constexpr double same_volume = 1e-9;  // of it
    if (m.triangles.empty() || !topology(m).closed()) return std::nullopt;
    const Box b = bounds(m);
    const auto lies_in = [&](const Triangle& t, auto&& coordinate) {
        const auto all_at = [&](double side) {
            return std::all_of(t.begin(), t.end(), [&](std::uint32_t v) { return coordinate(m.vertices[v]) == side; });
        };
        return all_at(coordinate(b.lo)) || all_at(coordinate(b.hi));
    };
    const bool on_faces = std::all_of(m.triangles.begin(), m.triangles.end(), [&](const Triangle& t) {
        return lies_in(t, [](Vec3 p) { return p.x; }) || lies_in(t, [](Vec3 p) { return p.y; }) ||
               lies_in(t, [](Vec3 p) { return p.z; });
    });
    const Vec3 size = b.size();
    const double whole = size.x * size.y * size.z;
    if (!on_faces || !(std::abs(std::abs(volume(m)) - whole) <= same_volume * whole)) return std::nullopt;
    return b;
}

int circle_sides(double radius, double tolerance) {
    if (!(radius > 0) || !(tolerance > 0)) return 8;
    const double cosine = 1 - tolerance / radius;  // of half the angle of a side
    if (!(cosine > 0)) return 8;
    return base::clipped<int>(std::ceil(geom::pi / std::acos(cosine)), 8, 4096);
}

Mesh cylinder(Vec3 foot, double radius, double height, int sides) {
    Mesh m;
    if (!(radius > 0 && height > 0) || sides < 3) return m;
    const auto n = static_cast<std::uint32_t>(sides);
    m.vertices = {foot, foot + Vec3{0, 0, height}};
    for (std::uint32_t i = 0; i < n; ++i) {
        const double angle = 2 * geom::pi * i / n;
        const Vec3 at = foot + Vec3{radius * std::cos(angle), radius * std::sin(angle), 0};
        m.vertices.push_back(at);
        m.vertices.push_back(at + Vec3{0, 0, height});
    }
    for (std::uint32_t i = 0; i < n; ++i) {
        const std::uint32_t low = 2 + 2 * i, next = 2 + 2 * ((i + 1) % n);
        m.triangles.push_back({0, next, low});
        m.triangles.push_back({1, low + 1, next + 1});
        m.triangles.push_back({low, next, next + 1});
        m.triangles.push_back({low, next + 1, low + 1});
    }
    return m;
}

Mesh ball(Vec3 centre, double radius, int sides) {
    Mesh m;
    if (!(radius > 0) || sides < 4) return m;
    const auto around = static_cast<std::uint32_t>(sides), rings = around / 2;
    m.vertices = {centre - Vec3{0, 0, radius}, centre + Vec3{0, 0, radius}};
    for (std::uint32_t r = 1; r < rings; ++r)
        for (std::uint32_t i = 0; i < around; ++i) {
            const double up = geom::pi * r / rings, angle = 2 * geom::pi * i / around;
            m.vertices.push_back(
                centre + radius * Vec3{std::sin(up) * std::cos(angle), std::sin(up) * std::sin(angle), -std::cos(up)});
        }
    const auto at = [&](std::uint32_t r, std::uint32_t i) { return 2 + (r - 1) * around + i % around; };
    for (std::uint32_t i = 0; i < around; ++i) {
        m.triangles.push_back({0, at(1, i + 1), at(1, i)});
        m.triangles.push_back({1, at(rings - 1, i), at(rings - 1, i + 1)});
        for (std::uint32_t r = 1; r + 1 < rings; ++r) {
            m.triangles.push_back({at(r, i), at(r, i + 1), at(r + 1, i + 1)});
            m.triangles.push_back({at(r, i), at(r + 1, i + 1), at(r + 1, i)});
        }
    }
    return m;
}

}  // namespace obrys::mesh
