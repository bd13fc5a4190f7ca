/// The surface on the sheet, and what is drawn over it: path, marks.
#include <algorithm>
#include <cmath>
#include <map>

#include "base/whole.hpp"

#include "report/picture/picture_parts.hpp"

namespace obrys::report::picture::picture {

using geom::Vec2;
using geom::Vec3;

Vec2 Shot::place(Vec3 p) const {
    const Vec3 seen = camera.project(p);
    return {corner.x + seen.x, corner.y + seen.y};
}

Rect Shot::frame() const {
    return {corner.x, corner.y, static_cast<double>(camera.width), static_cast<double>(camera.height)};
}

mesh::Colour palette_colour(const MillingScene& scene, std::uint32_t triangle) {
    if (scene.palette.empty()) return mesh::grey;
    const std::size_t index = triangle < scene.colours.size() ? scene.colours[triangle]
                              : scene.colours.empty()         ? scene.surface.tag(triangle)
                                                              : 0;
    return scene.palette[std::min(index, scene.palette.size() - 1)];
}

namespace {

/// The image on the sheet: the area, and what of the clamps lies beside it.
Rect framed(const Work& work, const Look& look, const Rect& area, double px_per_mm) {
    const double margin = std::ceil(0.5 * work.em);
    Rect out{area.left - margin, area.top - margin, area.width + 2 * margin, area.height + 2 * margin};
    if (work.scene.clamps.empty()) return out;
    double left = out.left, top = out.top, right = out.right(), bottom = out.bottom();
    for (unsigned k = 0; k < 8; ++k) {
        const mesh::Box& b = work.around;
        const Vec3 corner{(k & 1U) != 0 ? b.hi.x : b.lo.x, (k & 2U) != 0 ? b.hi.y : b.lo.y,
                          (k & 4U) != 0 ? b.hi.z : b.lo.z};
        const Vec3 from = corner - work.box.centre();
        const double x = area.centre().x + px_per_mm * dot(from, look.right),
                     y = area.centre().y - px_per_mm * dot(from, look.up);
        left = std::min(left, x - 1), right = std::max(right, x + 1);
        top = std::min(top, y - 1), bottom = std::max(bottom, y + 1);
    }
    left = std::max(left, 0.0), top = std::max(top, 0.0);
    return {left, top, std::min(right, work.width) - left, std::min(bottom, work.height) - top};
}

/// The pixels of the clamps, as far as nothing stands before them, as glass.
void make_glass(Relief& seen, const Visible& before, int finer) {
    constexpr std::uint32_t opaque = 150;  // of 255
    for (int j = 0; j < seen.image.height; ++j)
        for (int i = 0; i < seen.image.width; ++i) {
            std::uint32_t shown = 0;
            for (int k = 0; k < finer * finer; ++k) {
                const std::size_t at = before.at(finer * i + k % finer, finer * j + k / finer);
                shown += seen.visible.depth[at] > before.depth[at] ? 1 : 0;
            }
            const std::uint32_t share = opaque * shown / static_cast<std::uint32_t>(finer * finer);
            std::uint32_t& pixel =
                seen.image.pixels[static_cast<std::size_t>(j) * static_cast<std::size_t>(seen.image.width) +
                                  static_cast<std::size_t>(i)];
            std::uint32_t thin = 0;
            for (const unsigned shift : {0U, 8U, 16U, 24U}) thin |= ((pixel >> shift & 0xFFU) * share / 255) << shift;
            pixel = thin;
        }
}

void shoot_clamps(Work& work, const Shot& shot) {
    const mesh::Mesh& clamps = work.scene.clamps;
    if (clamps.empty()) return;
    ReliefStyle style;
    style.colour = [](const Spot&) { return clamp; };
    style.ambient = 0.5;
    style.finer = shot.finer;
    Relief seen = relief(clamps, relief_normals(clamps), shot.camera, style);
    work.complete = work.complete && seen.visible.complete;
    make_glass(seen, shot.visible, shot.finer);
    work.sheet.image(shot.corner, seen.image);
}

}  // namespace

Shot shoot(Work& work, const Look& look, const Rect& area, double px_per_mm, const ColourOf& colour, double ambient,
           const Vec3* cut) {
    Shot shot;
    const Rect frame = framed(work, look, area, px_per_mm);
    shot.corner = {std::floor(frame.left), std::floor(frame.top)};
    Camera& c = shot.camera;
    c.right = look.right;
    c.up = look.up;
    c.toward = look.toward;
    c.centre = work.box.centre();
    c.px_per_mm = px_per_mm;
    c.x = area.centre().x - shot.corner.x;
    c.y = area.centre().y - shot.corner.y;
    c.width = base::clipped<int>(std::ceil(frame.right() - shot.corner.x), 0, most_pixels);
    c.height = base::clipped<int>(std::ceil(frame.bottom() - shot.corner.y), 0, most_pixels);
    if (cut != nullptr) c.nearest = dot(*cut - c.centre, look.toward);
    ReliefStyle style;
    style.colour = colour;
    style.ambient = ambient;
    style.hatch_cuts = cut != nullptr;
    shot.finer = c.width * double(c.height) > 4e6 ? 1 : 2;
    style.finer = shot.finer;
    Relief seen = relief(work.scene.surface, work.normals, c, style);
    work.sheet.image(shot.corner, seen.image);
    work.complete = work.complete && seen.visible.complete;
    shot.visible = std::move(seen.visible);
    shoot_clamps(work, shot);
    return shot;
}

std::vector<double> flat_heights(const Visible& seen, double base) {
    constexpr double bin = 0.01, flat = 1e-3;  // mm
    constexpr std::int64_t most_bins = 1'000'000'000'000;
    struct Sum {
        std::size_t count = 0;
        double height = 0;
    };
    std::map<std::int64_t, Sum> bins;
    std::size_t pixels = 0;
    for (int j = 0; j + 1 < seen.height; ++j)
        for (int i = 0; i + 1 < seen.width; ++i) {
            const double z = seen.depth[seen.at(i, j)];
            if (!std::isfinite(z)) continue;
            ++pixels;
            if (!(std::abs(seen.depth[seen.at(i + 1, j)] - z) < flat &&
                  std::abs(seen.depth[seen.at(i, j + 1)] - z) < flat))
                continue;
            Sum& sum = bins[base::clipped<std::int64_t>(std::round((base + z) / bin), -most_bins, most_bins)];
            ++sum.count;
            sum.height += base + z;
        }
    std::vector<std::pair<std::size_t, double>> found;
    for (const auto& [key, sum] : bins)
        if (static_cast<double>(sum.count) > 0.003 * static_cast<double>(pixels))
            found.emplace_back(sum.count, std::round(sum.height / static_cast<double>(sum.count) / bin) * bin);
    std::stable_sort(found.begin(), found.end(), [](const auto& a, const auto& b) { return a.first > b.first; });
    std::vector<double> heights;
    for (const auto& [count, z] : found) {
        const auto near = [z = z](double other) { return std::abs(other - z) < 1.5 * bin; };
        if (heights.size() < 8 && std::none_of(heights.begin(), heights.end(), near)) heights.push_back(z);
    }
    return heights;
}

void path(Work& work, const Shot& shot) {
    const Rect r = shot.frame();
    work.sheet.clip({r.left, r.top}, {r.width, r.height});
    const double width = 0.08 * work.em;
    for (const PicturePath& piece : work.scene.path) {
        std::vector<Vec2> points;
        for (const Vec3 p : piece.points) points.push_back(shot.place(p));
        const Pen feed{{20, 110, 50}, width}, rapid{red, width, {0.4 * work.em, 0.3 * work.em}};
        work.sheet.line(points, piece.rapid ? rapid : feed);
    }
    work.sheet.unclip();
}

namespace {

struct Pin {
    Vec2 at;
    std::string label;
    int count = 0;
    bool hidden = false;
};

bool is_hidden(const Shot& shot, const Work& work, Vec3 p) {
    const Vec3 seen = shot.camera.project(p);
    const double i = std::floor(seen.x * shot.finer), j = std::floor(seen.y * shot.finer);
    if (!(i >= 0 && j >= 0 && i < shot.visible.width && j < shot.visible.height)) return false;
    const double nearest = shot.visible.depth[shot.visible.at(base::clipped<int>(i, 0, shot.visible.width - 1),
                                                              base::clipped<int>(j, 0, shot.visible.height - 1))];
    return nearest > seen.z + 0.01 * length(work.box.size());
}

/// Those that lie close together share a pin.
std::vector<Pin> pins(const Work& work, const Shot& shot) {
    constexpr int named = 3;
    std::vector<Pin> all;
    for (const PictureMark& mark : work.scene.marks) {
        if (!is_finite(mark.at)) continue;
        const Vec2 at = shot.place(mark.at);
        const auto near =
            std::find_if(all.begin(), all.end(), [&](const Pin& p) { return distance(p.at, at) < 1.6 * work.em; });
        if (near == all.end()) {
            if (all.size() < 1000) all.push_back({at, mark.label, 1, is_hidden(shot, work, mark.at)});
            continue;
        }
        ++near->count;
        if (near->count <= named) near->label += "," + mark.label;
        if (near->count == named + 1) near->label += ",...";
    }
    return all;
}

}  // namespace

void marks(Work& work, const Shot& shot) {
    const Rect r = shot.frame();
    work.sheet.clip({r.left - 5 * work.em, r.top - 5 * work.em}, {r.width + 10 * work.em, r.height + 10 * work.em});
    const std::vector<Pin> all = pins(work, shot);
    const mesh::Colour white{255, 255, 255};
    for (const Pin& pin : all) {
        const Vec2 head = pin.at + Vec2{1.3 * work.em, -1.3 * work.em};
        work.sheet.line({pin.at, head}, {red, 0.1 * work.em});
        work.sheet.disc(pin.at, 0.25 * work.em, red);
        work.sheet.disc(head, 0.85 * work.em, pin.hidden ? white : red);
        work.sheet.circle(head, 0.85 * work.em, {red, 0.1 * work.em});
    }
    work.sheet.unclip();
    for (const Pin& pin : all) {
        Words words{0.9 * work.em, pin.hidden ? red : white};
        words.share = 0.5;
        words.bold = true;
        if (pin.count > 1) words = {0.9 * work.em, red, 0, false, true, true};
        const Vec2 shift = pin.count > 1 ? Vec2{2.3 * work.em, -work.em} : Vec2{1.3 * work.em, -work.em};
        work.sheet.text(pin.at + shift, pin.label, words);
    }
}

}  // namespace obrys::report::picture::picture
