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

struct Face {
    std::array<Vec3, 3> corners;
    Vec3 normal;
    double least = 0;  ///< what counts as beyond
};

/// From where to where a face meets a plane, along a direction in that; none where it does not reach beyond it on both
/// sides.
std::optional<std::array<double, 2>> meets(const Face& f, const Face& plane, Vec3 along) {
    std::array<double, 3> d{};
    for (std::size_t i = 0; i < 3; ++i) d[i] = dot(f.corners[i] - plane.corners[0], plane.normal);
    if (!(std::max({d[0], d[1], d[2]}) > f.least) || !(std::min({d[0], d[1], d[2]}) < -f.least)) return std::nullopt;
    std::array<double, 2> span{HUGE_VAL, -HUGE_VAL};
    for (std::size_t i = 0; i < 3; ++i) {
        const std::size_t k = (i + 1) % 3;
        if ((d[i] < 0) == (d[k] < 0)) continue;
        const double at = dot(f.corners[i] + (d[i] / (d[i] - d[k])) * (f.corners[k] - f.corners[i]), along);
        span = {std::min(span[0], at), std::max(span[1], at)};
    }
    return span;
}

/// The middle of the line in which two faces go through each other.
std::optional<Vec3> middle_of_crossing(const Face& a, const Face& b) {
    Vec3 along = cross(a.normal, b.normal);
    const double size = length(along);
    if (!(size > rounding)) return std::nullopt;
    along = (1 / size) * along;
    const auto one = meets(a, b, along), other = one ? meets(b, a, along) : std::nullopt;
    if (!other) return std::nullopt;
    const double low = std::max((*one)[0], (*other)[0]), high = std::min((*one)[1], (*other)[1]);
    if (!(high - low > std::min(a.least, b.least))) return std::nullopt;
    // The place of both planes at that height.
    const double ca = dot(a.normal, a.corners[0]), cb = dot(b.normal, b.corners[0]), ab = dot(a.normal, b.normal);
    return ((ca - cb * ab) / (size * size)) * a.normal + ((cb - ca * ab) / (size * size)) * b.normal +
           (0.5 * (low + high)) * along;
}

Face face_of(const Distance& surface, std::uint32_t triangle, double beyond) {
    Face f{corners(surface.mesh(), triangle), surface.normal(triangle), 0};
    const auto& c = f.corners;
    const double longest =
        std::max({geom::distance(c[0], c[1]), geom::distance(c[1], c[2]), geom::distance(c[2], c[0])});
    f.least = std::max(rounding, std::min(beyond, short_share * longest));
    return f;
}

std::optional<Vec3> crossing_of(const Distance& surface, std::uint32_t triangle, double beyond) {
    const Face own = face_of(surface, triangle, beyond);
    Box around;
    for (const Vec3& c : own.corners) around.add(c);
    std::optional<Vec3> found;
    surface.visit([&](const Box& box) { return overlap(box, around); },
                  [&](std::uint32_t n) {
                      if (n > triangle) found = middle_of_crossing(own, face_of(surface, n, beyond));
                      return !found;
                  });
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
