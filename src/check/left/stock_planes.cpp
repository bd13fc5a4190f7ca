#include "check/left/stock_planes.hpp"

#include <algorithm>
#include <cmath>

namespace obrys::check {

namespace milling = sim::milling;

using geom::Vec3;

namespace {

constexpr std::size_t most_box_corners = 4000;  ///< of a mesh that may be convex
constexpr std::size_t most_faces = 100;         ///< of one

StockPlane outer_plane(const milling::MeshStock& m, const std::array<std::uint32_t, 3>& t, double least, bool& outer) {
    const Vec3 a = m.vertices[t[0]];
    Vec3 n = geom::cross(m.vertices[t[1]] - a, m.vertices[t[2]] - a);
    const double size = geom::length(n);
    outer = true;
    if (!(size > 0)) return {};
    n = (1 / size) * n;
    double low = 0, high = 0;
    for (const Vec3& v : m.vertices)
        low = std::min(low, geom::dot(n, v - a)), high = std::max(high, geom::dot(n, v - a));
    outer = low >= -least || high <= least;
    if (low >= -least) n = -1.0 * n;
    return {n, geom::dot(n, a) + least};
}

}  // namespace

StockPlanes planes_of(const milling::Stock& stock) {
    StockPlanes all;
    const milling::Box3 box = milling::box_of(stock);
    for (int k = 0; k < 3; ++k) {
        Vec3 up;
        milling::set_component(up, k, 1);
        all.planes.push_back({up, milling::component(box.max, k)});
        all.planes.push_back({-1.0 * up, -milling::component(box.min, k)});
    }
    const auto* m = std::get_if<milling::MeshStock>(&stock);
    all.whole = m == nullptr;
    if (m == nullptr || m->vertices.size() > most_box_corners) return all;
    const double least = 1e-7 * geom::distance(box.min, box.max);
    std::vector<StockPlane> planes;
    for (const auto& t : m->triangles) {
        bool outer = false;
        const StockPlane p = outer_plane(*m, t, least, outer);
        if (!outer) return all;
        const bool known = std::any_of(planes.begin(), planes.end(), [&](const StockPlane& q) {
            return geom::distance(p.out, q.out) < 1e-9 && std::abs(p.at - q.at) < least;
        });
        if (!(p.out == Vec3{}) && !known) planes.push_back(p);
    }
    if (planes.size() > most_faces) return all;
    all.planes = std::move(planes);
    all.whole = true;
    return all;
}

}  // namespace obrys::check
