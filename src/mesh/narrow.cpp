#include "mesh/narrow.hpp"

#include <algorithm>
#include <atomic>
#include <cmath>

#include "base/parallel.hpp"

namespace obrys::mesh {

using geom::Vec3;

namespace {

constexpr double alike = 0.94;       ///< cosine of normals that do not face each other
constexpr double in_front = 1e-6;    ///< mm
constexpr std::size_t chunk = 1024;  ///< triangles

class Narrow {
public:
    Narrow(const Distance& part, double reach, double size) : part_(part), reach_(reach), size_(size) {}

    void find(std::uint32_t triangle, std::vector<NarrowFace>& out) const {
        const NarrowFace whole{corners(part_.mesh(), triangle), triangle};
        if (!(length(part_.normal(triangle)) > 0)) return;
        std::vector<std::uint32_t> facing;
        const bool small = longest(whole).second <= size_;
        Box around;
        for (const Vec3& c : whole.corners) around.add(c);
        const Vec3 more{reach_, reach_, reach_};
        around.lo = around.lo - more, around.hi = around.hi + more;
        part_.visit([&](const Box& b) { return overlap(b, around); },
                    [&](std::uint32_t other) {
                        if (faces(whole, other)) facing.push_back(other);
                        return !small || facing.empty();
                    });
        split(whole, facing, out);
    }

private:
    /// The corner that the longest side begins at, and that side's length.
    static std::pair<std::size_t, double> longest(const NarrowFace& f) {
        std::pair<std::size_t, double> most{0, -1};
        for (std::size_t i = 0; i < 3; ++i)
            if (const double side = geom::distance(f.corners[i], f.corners[(i + 1) % 3]); side > most.second)
                most = {i, side};
        return most;
    }
    [[nodiscard]] bool faces(const NarrowFace& f, std::uint32_t other) const {
        const Vec3 n = part_.normal(f.triangle), m = part_.normal(other);
        if (dot(n, m) > alike || !(length(m) > 0)) return false;
        const auto theirs = corners(part_.mesh(), other);
        if (std::none_of(theirs.begin(), theirs.end(), [&](Vec3 p) { return dot(n, p - f.corners[0]) > in_front; }) ||
            std::none_of(f.corners.begin(), f.corners.end(), [&](Vec3 p) { return dot(m, p - theirs[0]) > in_front; }))
            return false;
        const Vec3 middle = (1.0 / 3) * (f.corners[0] + f.corners[1] + f.corners[2]);
        double radius = 0;
        for (const Vec3& c : f.corners) radius = std::max(radius, geom::distance(c, middle));
        return nearest_on_triangle(middle, theirs).distance <= reach_ + radius;
    }
    void split(const NarrowFace& f, const std::vector<std::uint32_t>& facing, std::vector<NarrowFace>& out) const {
        if (facing.empty()) return;
        const auto [from, side] = longest(f);
        if (!(side > size_)) {
            out.push_back(f);
            return;
        }
        const Vec3 middle = 0.5 * (f.corners[from] + f.corners[(from + 1) % 3]);
        for (const std::size_t moved : {from, (from + 1) % 3}) {
            NarrowFace half = f;
            half.corners[moved] = middle;
            const bool last = longest(half).second <= size_;  // then one is enough
            std::vector<std::uint32_t> still;
            for (const std::uint32_t other : facing) {
                if (faces(half, other)) still.push_back(other);
                if (last && !still.empty()) break;
            }
            split(half, still, out);
        }
    }

    const Distance& part_;
    double reach_, size_;
};

/// Of a triangle with a ray: +1 where it comes out of the body, -1 where it goes in, 0 where it misses.
int crossing(Vec3 from, Vec3 way, const std::array<Vec3, 3>& c) {
    const Vec3 a = c[1] - c[0], b = c[2] - c[0], normal = cross(a, b), q = from - c[0];
    const double det = dot(way, normal);
    if (det == 0) return 0;
    const Vec3 r = cross(way, q);
    const double u = dot(b, r) / det, v = -dot(a, r) / det, t = -dot(q, normal) / det;
    return u >= 0 && v >= 0 && u + v <= 1 && t > 0 ? (det > 0 ? 1 : -1) : 0;
}

}  // namespace

std::optional<std::vector<NarrowFace>> narrow_faces(const Distance& part, double reach, double size, std::size_t most) {
    const std::size_t n = part.mesh().triangles.size();
    std::vector<std::vector<NarrowFace>> found((n + chunk - 1) / chunk);
    std::atomic<std::size_t> count = 0;
    const Narrow narrow(part, reach, size);
    base::for_all(found.size(), [&](std::size_t k) {
        for (std::size_t t = k * chunk; t < std::min(n, (k + 1) * chunk) && count <= most; ++t) {
            const std::size_t before = found[k].size();
            narrow.find(static_cast<std::uint32_t>(t), found[k]);
            count += found[k].size() - before;
        }
    });
    if (count > most) return std::nullopt;
    std::vector<NarrowFace> all;
    all.reserve(count);
    for (const auto& some : found) all.insert(all.end(), some.begin(), some.end());
    return all;
}

int winding(const Distance& part, Vec3 p) {
    // No ray along faces or through edges that lie straight; of three two must agree, should one meet an edge.
    constexpr std::array<Vec3, 3> ways{
        Vec3{0.2672, 0.5345, 0.8018}, {-0.7071, 0.1234, 0.6963}, {0.5137, -0.8211, 0.2489}};
    std::array<int, 3> sums{};
    for (std::size_t w = 0; w < ways.size(); ++w) {
        const Vec3 way = ways[w];
        const auto passes = [&](const Box& b) {
            double low = 0, high = HUGE_VAL;
            const auto clip = [&](double lo, double hi, double at, double along) {
                const double s = (lo - at) / along, t = (hi - at) / along;
                low = std::max(low, std::min(s, t)), high = std::min(high, std::max(s, t));
            };
            clip(b.lo.x, b.hi.x, p.x, way.x), clip(b.lo.y, b.hi.y, p.y, way.y), clip(b.lo.z, b.hi.z, p.z, way.z);
            return low <= high;
        };
        part.visit(passes, [&](std::uint32_t t) {
            sums[w] += crossing(p, way, corners(part.mesh(), t));
            return true;
        });
        if (w == 1 && sums[0] == sums[1]) return sums[0];
    }
    return sums[2] == sums[0] ? sums[0] : sums[2] == sums[1] ? sums[1] : sums[2];
}

}  // namespace obrys::mesh
