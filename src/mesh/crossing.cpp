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

/// Where the way from `a` to `b` goes through a triangle, far enough on both ends and from its border.
std::optional<Vec3> through(Vec3 a, Vec3 b, const std::array<Vec3, 3>& t, Vec3 normal, double beyond) {
    const double first = dot(a - t[0], normal), last = dot(b - t[0], normal);
    const double least = std::max(rounding, std::min(beyond, short_share * geom::distance(a, b)));
    if (!(first * last < 0) || !(std::min(std::abs(first), std::abs(last)) > least)) return std::nullopt;
    const Vec3 p = a + (first / (first - last)) * (b - a);
    const double around = geom::distance(t[0], t[1]) + geom::distance(t[1], t[2]) + geom::distance(t[2], t[0]),
                 circle = dot(cross(t[1] - t[0], t[2] - t[0]), normal) / around;
    const double inside = std::max(rounding, std::min(beyond, short_share * circle));
    for (std::size_t i = 0; i < 3; ++i) {
        const Vec3 side = t[(i + 1) % 3] - t[i];
        if (!(dot(cross(side, p - t[i]), normal) > inside * length(side))) return std::nullopt;
    }
    return p;
}

std::optional<Vec3> crossing_of(const Distance& surface, std::uint32_t triangle, double beyond) {
    const Mesh& m = surface.mesh();
    const Triangle& t = m.triangles[triangle];
    std::optional<Vec3> found;
    for (std::size_t i = 0; i < 3 && !found; ++i) {
        const std::uint32_t one = t[i], other = t[(i + 1) % 3];
        if (one > other) continue;  // its neighbour has the same side
        const Vec3 a = m.vertices[one], b = m.vertices[other];
        Box around;
        around.add(a);
        around.add(b);
        surface.visit([&](const Box& box) { return boxes_meet(box, around); },
                      [&](std::uint32_t n) {
                          found = through(a, b, corners(m, n), surface.normal(n), beyond);
                          return !found;
                      });
    }
    return found;
}

}  // namespace

std::optional<Vec3> self_crossing(const Distance& surface, double beyond) {
    const std::size_t count = surface.mesh().triangles.size(), pieces = (count + together - 1) / together;
    std::vector<std::optional<Vec3>> found(pieces);
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
