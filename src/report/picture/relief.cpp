#include "report/picture/relief.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/whole.hpp"

namespace obrys::report::picture {

using geom::Vec3;
using mesh::Colour;

namespace {

constexpr double crease = geom::radians(30);       ///< sharper edges of the mesh are not smoothed over
const double drawn = std::cos(geom::radians(22));  ///< normals of neighbouring pixels farther apart make a line
constexpr double depth_step = 2.5;                 ///< px: a jump of the depth that makes a line
constexpr double line_share = 0.3;                 ///< what a line leaves of the colour
constexpr Colour cut_light{236, 214, 170}, cut_dark{196, 150, 80};
constexpr int hatch_pitch = 12;  ///< px of the image between the hatch's lines

using Normal = std::array<float, 3>;

struct Pixel {
    double red = 0, green = 0, blue = 0;
};

class Painter {
public:
    Painter(const mesh::Mesh& m, const mesh::Shading& normals, const Camera& camera, const ReliefStyle& style,
            const Visible& visible)
        : mesh_(m), shading_(normals), camera_(camera), style_(style), visible_(visible) {
        normal_.resize(visible.triangle.size());
        cut_.resize(visible.triangle.size());
        for (int j = 0; j < visible.height; ++j)
            for (int i = 0; i < visible.width; ++i)
                if (seen(visible.at(i, j))) set_normal(i, j);
        key_ = unit(camera.toward + 0.6 * camera.up + -0.5 * camera.right);
        fill_ = unit(0.7 * camera.toward + -0.3 * camera.up + 0.6 * camera.right);
        full_ = light(camera.toward);
    }

    [[nodiscard]] bool seen(std::size_t at) const { return visible_.triangle[at] != Visible::none; }

    [[nodiscard]] Pixel colour(int i, int j) const {
        const std::size_t at = visible_.at(i, j);
        Pixel p = cut_[at] != 0 ? hatch(i, j) : lit(at);
        if (on_line(i, j)) p = {line_share * p.red, line_share * p.green, line_share * p.blue};
        return p;
    }

private:
    static Vec3 unit(Vec3 v) { return (1 / length(v)) * v; }

    void set_normal(int i, int j) {
        const std::size_t at = visible_.at(i, j);
        const std::uint32_t t = visible_.triangle[at];
        const Vec3 flat = area_vector(mesh_, t);
        const bool back = dot(flat, camera_.toward) < 0;
        cut_[at] = back && style_.hatch_cuts;
        Vec3 n = back ? -1.0 * flat : flat;
        if (cut_[at] != 0)
            n = camera_.toward;
        else if (shading_.corners[3 * std::size_t{t}] != mesh::Shading::none)
            n = smooth(i, j, t, back);
        const double size = length(n);
        if (!(size > 0)) n = camera_.toward;
        const double k = size > 0 ? 1 / size : 1;
        normal_[at] = {static_cast<float>(k * n.x), static_cast<float>(k * n.y), static_cast<float>(k * n.z)};
    }

    /// Between the corners' normals by the pixel's place in the triangle.
    [[nodiscard]] Vec3 smooth(int i, int j, std::uint32_t t, bool back) const {
        const auto corner = mesh::corners(mesh_, t);
        const Vec3 a = camera_.project(corner[0]), b = camera_.project(corner[1]), c = camera_.project(corner[2]);
        const double x = i + 0.5, y = j + 0.5;
        const double area = (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
        const double u = ((c.x - b.x) * (y - b.y) - (c.y - b.y) * (x - b.x)) / area;
        const double v = ((a.x - c.x) * (y - c.y) - (a.y - c.y) * (x - c.x)) / area;
        const auto of = [&](std::size_t k) { return shading_.normal[shading_.corners[3 * std::size_t{t} + k]]; };
        const Vec3 n = u * of(0) + v * of(1) + (1 - u - v) * of(2);
        return back ? -1.0 * n : n;
    }

    [[nodiscard]] double light(Vec3 n) const {
        return 0.8 * std::max(0.0, dot(n, key_)) + 0.3 * std::max(0.0, dot(n, fill_));
    }

    /// What faces the eye has its full colour.
    [[nodiscard]] Pixel lit(std::size_t at) const {
        const Colour c = style_.colour({visible_.triangle[at], static_cast<double>(visible_.depth[at])});
        const Vec3 n{normal_[at][0], normal_[at][1], normal_[at][2]};
        const double k = style_.ambient + (1 - style_.ambient) * std::min(1.0, light(n) / full_);
        return {k * c.red, k * c.green, k * c.blue};
    }

    [[nodiscard]] Pixel hatch(int i, int j) const {
        const int pitch = hatch_pitch * style_.finer;
        const bool dark = (i + j) % pitch < style_.finer;
        const Colour c = dark ? cut_dark : cut_light;
        return {double(c.red), double(c.green), double(c.blue)};
    }

    [[nodiscard]] bool inside(int i, int j) const {
        return i >= 0 && j >= 0 && i < visible_.width && j < visible_.height;
    }

    /// Between this pixel and the next one lies an outline, a crease or a jump in depth.
    [[nodiscard]] bool on_line(int i, int j) const {
        constexpr int ways[2][2] = {{1, 0}, {0, 1}};
        for (const auto& way : ways) {
            const int i0 = i - way[0], j0 = j - way[1], i1 = i + way[0], j1 = j + way[1];
            const bool before = inside(i0, j0) && seen(visible_.at(i0, j0));
            const bool after = inside(i1, j1) && seen(visible_.at(i1, j1));
            if (!before || !after) return true;
            if (breaks(visible_.at(i0, j0), visible_.at(i, j), visible_.at(i1, j1))) return true;
        }
        return false;
    }

    [[nodiscard]] bool breaks(std::size_t before, std::size_t at, std::size_t after) const {
        if (cut_[at] != cut_[after] || cut_[at] != cut_[before]) return true;
        if (cut_[at] != 0) return false;
        const auto cosine = [&](std::size_t k) {
            const Normal &a = normal_[at], &b = normal_[k];
            return double(a[0]) * b[0] + double(a[1]) * b[1] + double(a[2]) * b[2];
        };
        if (cosine(after) < drawn) return true;
        // Of a plane the middle one of three depths is the mean of the others.
        const double bend = double(visible_.depth[before]) + visible_.depth[after] - 2 * double(visible_.depth[at]);
        return std::abs(bend) * camera_.px_per_mm > depth_step;
    }

    const mesh::Mesh& mesh_;
    const mesh::Shading& shading_;
    const Camera& camera_;
    const ReliefStyle& style_;
    const Visible& visible_;
    std::vector<Normal> normal_;
    std::vector<std::uint8_t> cut_;
    Vec3 key_, fill_;
    double full_ = 1;  ///< light of a face that looks at the eye
};

/// `finer` x `finer` pixels of the relief to one of the image.
std::uint32_t mixed(const Painter& painter, const Visible& v, int i, int j, int finer) {
    Pixel sum;
    int covered = 0;
    for (int y = j * finer; y < (j + 1) * finer; ++y)
        for (int x = i * finer; x < (i + 1) * finer; ++x) {
            if (!painter.seen(v.at(x, y))) continue;
            const Pixel p = painter.colour(x, y);
            sum = {sum.red + p.red, sum.green + p.green, sum.blue + p.blue};
            ++covered;
        }
    const double share = 1.0 / (finer * finer);
    const auto byte = [&](double value) { return base::clipped<std::uint32_t>(share * value + 0.5, 0, 255); };
    return byte(255.0 * covered) << 24 | byte(sum.red) << 16 | byte(sum.green) << 8 | byte(sum.blue);
}

}  // namespace

mesh::Shading relief_normals(const mesh::Mesh& m) { return mesh::shade(m, crease); }

Relief relief(const mesh::Mesh& m, const mesh::Shading& normals, const Camera& camera, const ReliefStyle& style) {
    Camera fine = camera;
    const int finer = std::max(style.finer, 1);
    fine.x *= finer;
    fine.y *= finer;
    fine.px_per_mm *= finer;
    fine.width *= finer;
    fine.height *= finer;
    Relief out;
    out.visible = rasterise(m, fine);
    ReliefStyle used = style;
    used.finer = finer;
    const Painter painter(m, normals, fine, used, out.visible);
    out.image.width = std::max(camera.width, 0);
    out.image.height = std::max(camera.height, 0);
    out.image.pixels.reserve(static_cast<std::size_t>(out.image.width) * static_cast<std::size_t>(out.image.height));
    for (int j = 0; j < out.image.height; ++j)
        for (int i = 0; i < out.image.width; ++i) out.image.pixels.push_back(mixed(painter, out.visible, i, j, finer));
    return out;
}

}  // namespace obrys::report::picture
