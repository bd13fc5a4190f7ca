#include "mesh/crossing.hpp"

#include <algorithm>
#include <atomic>
#include <cmath>

#include "base/parallel.hpp"

namespace obrys::mesh {

using geom::Vec3;

namespace {

constexpr std::size_t together = 1024;  ///< triangles
constexpr double short_share = 0.25;    ///< of a side
constexpr double rounding = 1e-6;       ///< mm

bool boxes_meet(const Box& a, const Box& b) {
    return a.lo.x <= b.hi.x && b.lo.x <= a.hi.x && a.lo.y <= b.hi.y && b.lo.y <= a.hi.y && a.lo.z <= b.hi.z &&
           b.lo.z <= a.hi.z;
}

/// Where the way from `a` to `b` goes through a triangle, far enough on both ends.
std::optional<SelfCrossing> through(Vec3 a, Vec3 b, const std::array<Vec3, 3>& t, Vec3 normal, double least) {
    const double first = dot(a - t[0], normal), last = dot(b - t[0], normal);
    const double beyond = std::min(std::abs(first), std::abs(last));
    if (!(first * last < 0) || !(beyond > least)) return std::nullopt;
    const Vec3 p = a + (first / (first - last)) * (b - a);
    for (std::size_t i = 0; i < 3; ++i)
        if (dot(cross(t[(i + 1) % 3] - t[i], p - t[i]), normal) < 0) return std::nullopt;
    return SelfCrossing{p, beyond};
}

std::optional<SelfCrossing> crossing_of(const Distance& surface, std::uint32_t triangle, double beyond) {
    const Mesh& m = surface.mesh();
    const Triangle& t = m.triangles[triangle];
    std::optional<SelfCrossing> found;
    for (std::size_t i = 0; i < 3 && !found; ++i) {
        const std::uint32_t one = t[i], other = t[(i + 1) % 3];
        if (one > other) continue;  // its neighbour has the same side
        const Vec3 a = m.vertices[one], b = m.vertices[other];
        const double least = std::max(rounding, std::min(beyond, short_share * geom::distance(a, b)));
        Box around;
        around.add(a);
        around.add(b);
        surface.visit([&](const Box& box) { return boxes_meet(box, around); },
                      [&](std::uint32_t n) {
                          found = through(a, b, corners(m, n), surface.normal(n), least);
                          return !found;
                      });
    }
    return found;
}

}  // namespace

std::optional<SelfCrossing> self_crossing(const Distance& surface, double beyond) {
    const std::size_t count = surface.mesh().triangles.size(), pieces = (count + together - 1) / together;
    std::vector<std::optional<SelfCrossing>> found(pieces);
    std::atomic<std::size_t> least = pieces;
    base::for_all(pieces, [&](std::size_t n) {
        if (n > least) return;  // an earlier one crosses
        for (std::size_t t = n * together; t < std::min(count, (n + 1) * together) && !found[n]; ++t)
            found[n] = crossing_of(surface, static_cast<std::uint32_t>(t), beyond);
        if (!found[n]) return;
        for (std::size_t known = least; n < known && !least.compare_exchange_weak(known, n);) {
        }
    });
    return least < pieces ? found[least] : std::nullopt;
}

}  // namespace obrys::mesh
