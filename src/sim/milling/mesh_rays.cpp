#include "sim/milling/mesh_rays.hpp"

#include <algorithm>
#include <cmath>

#include "base/whole.hpp"

namespace obrys::sim::milling {
namespace {

using geom::Vec2;
using geom::Vec3;

struct RayCrossing {
    std::uint32_t ray = 0;
    double at = 0;
    auto operator<=>(const RayCrossing&) const = default;
};

/// Whether the half line from p towards +x crosses the edge; lower end counted in, upper end out. Both triangles of an
/// edge get the same answer because the edge is always taken from its lower end.
bool crosses(Vec2 a, Vec2 b, Vec2 p) {
    if ((a.y > p.y) == (b.y > p.y)) return false;
    if (a.y > b.y) std::swap(a, b);
    return a.x + (p.y - a.y) / (b.y - a.y) * (b.x - a.x) > p.x;
}

struct Projected {
    std::array<Vec2, 3> p;
    std::array<double, 3> height;
};

bool contains(const Projected& t, Vec2 p) {
    return (crosses(t.p[0], t.p[1], p) != crosses(t.p[1], t.p[2], p)) != crosses(t.p[2], t.p[0], p);
}

double height_at(const Projected& t, Vec2 p) {
    const Vec2 u = t.p[1] - t.p[0], v = t.p[2] - t.p[0], q = p - t.p[0];
    const double area = cross(u, v);
    const auto [low, high] = std::minmax({t.height[0], t.height[1], t.height[2]});
    const double h =
        t.height[0] + (cross(q, v) * (t.height[1] - t.height[0]) + cross(u, q) * (t.height[2] - t.height[0])) / area;
    return std::isfinite(h) ? std::clamp(h, low, high) : low;
}

struct NodeRange {
    int from = 0, to = -1;
};
NodeRange nodes_between(double low, double high, double origin, double step, int count) {
    return {base::clipped<int>(std::ceil((low - origin) / step), 0, count),
            base::clipped<int>(std::floor((high - origin) / step), -1, count - 1)};
}

std::vector<RayCrossing> crossings(const Dexels& dexels, const MeshStock& mesh, int axis) {
    const Lattice& l = dexels.lattice();
    const int first = first_across(axis), second = second_across(axis);
    const double u0 = component(l.origin, first), du = component(l.step, first);
    const double v0 = component(l.origin, second), dv = component(l.step, second);
    std::vector<RayCrossing> all;
    for (const auto& corners : mesh.triangles) {
        Projected t;
        for (std::size_t i = 0; i < 3; ++i) {
            const Vec3 p = mesh.vertices[corners[i]];
            t.p[i] = {component(p, first), component(p, second)};
            t.height[i] = component(p, axis);
        }
        const auto [left, right] = std::minmax({t.p[0].x, t.p[1].x, t.p[2].x});
        const auto [down, up] = std::minmax({t.p[0].y, t.p[1].y, t.p[2].y});
        const NodeRange a = nodes_between(left, right, u0, du, dexels.rays_a(axis));
        const NodeRange b = nodes_between(down, up, v0, dv, dexels.rays_b(axis));
        for (int j = b.from; j <= b.to; ++j) {
            for (int i = a.from; i <= a.to; ++i) {
                const Vec2 p{u0 + i * du, v0 + j * dv};
                if (contains(t, p))
                    all.push_back({static_cast<std::uint32_t>(j * dexels.rays_a(axis) + i), height_at(t, p)});
            }
        }
    }
    std::sort(all.begin(), all.end());
    return all;
}

/// Square of the distance of p from a triangle's plane where p lies over it, else from its nearest edge.
double square_from(const std::array<Vec3, 3>& t, Vec3 normal, Vec3 p) {
    bool over = true;
    double nearest = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < 3; ++i) {
        const Vec3 a = t[i], edge = t[(i + 1) % 3] - a;
        over = over && dot(cross(edge, p - a), normal) >= 0;
        const double square = dot(edge, edge);
        const double s = square > 0 ? std::clamp(dot(p - a, edge) / square, 0.0, 1.0) : 0.0;
        const Vec3 away = p - a - s * edge;
        nearest = std::min(nearest, dot(away, away));
    }
    const double height = dot(p - t[0], normal);
    return over ? height * height : nearest;
}

}  // namespace

std::uint64_t fill_mesh(Dexels& dexels, const MeshStock& mesh) {
    std::uint64_t open = 0;
    std::vector<Interval> intervals;
    for (int axis = 0; axis < 3; ++axis) {
        const std::vector<RayCrossing> all = crossings(dexels, mesh, axis);
        const auto across = static_cast<std::uint32_t>(dexels.rays_a(axis));
        for (std::size_t i = 0; i < all.size();) {
            std::size_t end = i;
            while (end < all.size() && all[end].ray == all[i].ray) ++end;
            if ((end - i) % 2 != 0) ++open;
            intervals.clear();
            for (std::size_t k = i; k + 1 < end; k += 2) {
                if (all[k + 1].at - all[k].at <= thinnest) continue;
                if (!intervals.empty() && all[k].at - intervals.back().end <= thinnest)
                    intervals.back().end = all[k + 1].at;
                else
                    intervals.push_back({all[k].at, all[k + 1].at, 0, 0});
            }
            dexels.set(axis, static_cast<int>(all[i].ray % across), static_cast<int>(all[i].ray / across), intervals);
            i = end;
        }
    }
    return open;
}

MeshPlaces::MeshPlaces(const MeshStock& mesh, const Box3& box) : box_(box) {
    constexpr double most = 64;
    const Vec3 size = box.max - box.min;
    const double longest = std::max({size.x, size.y, size.z});
    const double cells = std::clamp(std::sqrt(static_cast<double>(mesh.triangles.size())), 1.0, most);
    for (int axis = 0; axis < 3; ++axis)
        count_[static_cast<std::size_t>(axis)] = base::clipped<int>(cells * component(size, axis) / longest, 1, 64);
    cells_.resize(static_cast<std::size_t>(count_[0]) * static_cast<std::size_t>(count_[1]) *
                  static_cast<std::size_t>(count_[2]));
    double volume = 0;
    for (std::uint32_t n = 0; n < mesh.triangles.size(); ++n) {
        const auto& t = mesh.triangles[n];
        const Vec3 a = mesh.vertices[t[0]] - box.min, b = mesh.vertices[t[1]] - box.min,
                   c = mesh.vertices[t[2]] - box.min;
        volume += dot(a, cross(b, c));
        const Vec3 margin{margin_, margin_, margin_};
        const auto low = cell_of(
            box.min + Vec3{std::min({a.x, b.x, c.x}), std::min({a.y, b.y, c.y}), std::min({a.z, b.z, c.z})} - margin);
        const auto high = cell_of(
            box.min + Vec3{std::max({a.x, b.x, c.x}), std::max({a.y, b.y, c.y}), std::max({a.z, b.z, c.z})} + margin);
        for (int k = low[2]; k <= high[2]; ++k)
            for (int j = low[1]; j <= high[1]; ++j)
                for (int i = low[0]; i <= high[0]; ++i) cells_[index_of(i, j, k)].push_back(n);
    }
    outwards_ = volume < 0 ? -1 : 1;
}

std::array<int, 3> MeshPlaces::cell_of(Vec3 p) const {
    std::array<int, 3> cell{};
    for (int axis = 0; axis < 3; ++axis) {
        const auto own = static_cast<std::size_t>(axis);
        const double low = component(box_.min, axis), size = component(box_.max, axis) - low;
        const double at = (component(p, axis) - low) / size * count_[own];
        cell[own] = base::clipped<int>(at, 0, count_[own] - 1);
    }
    return cell;
}

std::size_t MeshPlaces::index_of(int i, int j, int k) const {
    return (static_cast<std::size_t>(k) * static_cast<std::size_t>(count_[1]) + static_cast<std::size_t>(j)) *
               static_cast<std::size_t>(count_[0]) +
           static_cast<std::size_t>(i);
}

Vec3 MeshPlaces::normal_at(const MeshStock& mesh, Vec3 p) const {
    const auto cell = cell_of(p);
    Vec3 best{0, 0, 1};
    double nearest = std::numeric_limits<double>::infinity();
    for (const std::uint32_t n : cells_[index_of(cell[0], cell[1], cell[2])]) {
        const auto& c = mesh.triangles[n];
        const std::array<Vec3, 3> t{mesh.vertices[c[0]], mesh.vertices[c[1]], mesh.vertices[c[2]]};
        Vec3 normal = cross(t[1] - t[0], t[2] - t[0]);
        const double size = length(normal);
        if (!(size > 0)) continue;
        normal = (1 / size) * normal;
        const double square = square_from(t, normal, p);
        if (!(square < nearest)) continue;
        nearest = square;
        best = outwards_ * normal;
    }
    return best;
}

}  // namespace obrys::sim::milling
