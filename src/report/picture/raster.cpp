#include "report/picture/raster.hpp"

#include <algorithm>
#include <cmath>

#include "base/whole.hpp"

namespace obrys::report::picture {

using geom::Vec3;

namespace {

constexpr double most_samples = 3e9;  ///< pixel tests in one picture: some seconds
constexpr double far_off = 1e7;       ///< px; beyond it differences of coordinates are no longer exact enough

/// A canvas' pixels from the first to the last, both included, whose middles lie within [lo, hi].
struct Range {
    int first, last;
};
Range middles(double lo, double hi, int size) {
    return {base::clipped<int>(std::ceil(lo - 0.5), 0, size), base::clipped<int>(std::floor(hi - 0.5), -1, size - 1)};
}

class Filler {
public:
    Filler(const Camera& camera, Visible& out) : camera_(camera), out_(out) {}

    void fill(std::uint32_t number, Vec3 a, Vec3 b, Vec3 c) {
        const double area = (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
        if (!(std::abs(area) > 1e-12)) return;
        if (area < 0) std::swap(b, c);
        const auto [left, right] = std::minmax({a.x, b.x, c.x});
        const auto [top, bottom] = std::minmax({a.y, b.y, c.y});
        const Range columns = middles(left, right, out_.width), rows = middles(top, bottom, out_.height);
        if (columns.first > columns.last || rows.first > rows.last) return;
        samples_ += (columns.last - columns.first + 1.0) * (rows.last - rows.first + 1.0);
        if (samples_ > most_samples) {
            out_.complete = false;
            return;
        }
        for (int j = rows.first; j <= rows.last; ++j) row(number, j, columns, a, b, c);
    }

private:
    void row(std::uint32_t number, int j, Range columns, Vec3 a, Vec3 b, Vec3 c) {
        const double area = (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
        const auto [back, front] = std::minmax({a.z, b.z, c.z});
        const double y = j + 0.5;
        for (int i = columns.first; i <= columns.last; ++i) {
            const double x = i + 0.5;
            const double u = (c.x - b.x) * (y - b.y) - (c.y - b.y) * (x - b.x);
            const double v = (a.x - c.x) * (y - c.y) - (a.y - c.y) * (x - c.x);
            const double w = (b.x - a.x) * (y - a.y) - (b.y - a.y) * (x - a.x);
            if (!(u >= 0 && v >= 0 && w >= 0)) continue;
            const double z = std::clamp((u * a.z + v * b.z + w * c.z) / area, back, front);
            if (z > camera_.nearest) continue;
            const std::size_t at = out_.at(i, j);
            if (!(static_cast<float>(z) > out_.depth[at])) continue;
            out_.depth[at] = static_cast<float>(z);
            out_.triangle[at] = number;
        }
    }

    const Camera& camera_;
    Visible& out_;
    double samples_ = 0;
};

bool drawable(Vec3 p) { return std::abs(p.x) < far_off && std::abs(p.y) < far_off && std::abs(p.z) < 1e30; }

}  // namespace

Vec3 Camera::project(Vec3 p) const {
    const Vec3 d = p - centre;
    return {x + px_per_mm * dot(d, right), y - px_per_mm * dot(d, up), dot(d, toward)};
}

Visible rasterise(const mesh::Mesh& m, const Camera& camera) {
    Visible out;
    out.width = std::max(camera.width, 0);
    out.height = std::max(camera.height, 0);
    const std::size_t pixels = static_cast<std::size_t>(out.width) * static_cast<std::size_t>(out.height);
    out.triangle.assign(pixels, Visible::none);
    out.depth.assign(pixels, -std::numeric_limits<float>::infinity());
    std::vector<Vec3> seen(m.vertices.size());
    for (std::size_t v = 0; v < seen.size(); ++v) seen[v] = camera.project(m.vertices[v]);
    Filler filler(camera, out);
    for (std::size_t t = 0; t < m.triangles.size(); ++t) {
        const auto [a, b, c] = m.triangles[t];
        if (a >= seen.size() || b >= seen.size() || c >= seen.size()) continue;
        if (drawable(seen[a]) && drawable(seen[b]) && drawable(seen[c]))
            filler.fill(static_cast<std::uint32_t>(t), seen[a], seen[b], seen[c]);
    }
    return out;
}

}  // namespace obrys::report::picture
