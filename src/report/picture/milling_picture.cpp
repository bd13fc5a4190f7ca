#include "report/picture/milling_picture.hpp"

#include <algorithm>
#include <cmath>

#include "report/picture/picture_parts.hpp"

namespace obrys::report::picture {

using geom::Vec3;

namespace {

constexpr int smallest_picture = 200, largest_picture = 4000;  ///< px
constexpr double furthest = 1e6;                               ///< mm from zero that a picture can show
constexpr double beyond = 4;  ///< stocks: a surface that reaches farther out is shown as far as the stock goes

bool within_reach(Vec3 p) { return std::max({std::abs(p.x), std::abs(p.y), std::abs(p.z)}) < furthest && is_finite(p); }

bool within_reach(const mesh::Box& b) { return !b.empty() && within_reach(b.lo) && within_reach(b.hi); }

/// Of the vertices whose place can be shown.
mesh::Box extent(const mesh::Mesh& m) {
    mesh::Box box;
    for (const Vec3 v : m.vertices)
        if (within_reach(v)) box.add(v);
    return box;
}

/// What the picture shows: the stock and what sticks out of it a little. Empty where nothing can be shown.
mesh::Box shown(const MillingScene& scene) {
    const mesh::Box surface = extent(scene.surface);
    if (surface.empty()) return {};
    mesh::Box box = surface;
    if (within_reach(scene.stock)) {
        mesh::Box both = scene.stock;
        both.add(surface);
        box = length(both.size()) <= beyond * length(scene.stock.size()) ? both : scene.stock;
    }
    // Something flat would have no middle and no scale.
    const double least = std::max(1e-3, 1e-4 * length(box.size()));
    const Vec3 size = box.size(), middle = box.centre();
    if (size.x < least) box.lo.x = middle.x - least / 2, box.hi.x = middle.x + least / 2;
    if (size.y < least) box.lo.y = middle.y - least / 2, box.hi.y = middle.y + least / 2;
    if (size.z < least) box.lo.z = middle.z - least / 2, box.hi.z = middle.z + least / 2;
    return box;
}

/// The box and what of the clamps lies not far from it.
mesh::Box with_clamps(const mesh::Box& box, const mesh::Mesh& clamps, double room) {
    mesh::Box around = box;
    if (clamps.empty()) return around;
    const mesh::Box all = extent(clamps);
    const Vec3 size = box.size();
    const double most = room * std::max({size.x, size.y, size.z});
    const auto reach = [&](double Vec3::*axis) {
        around.lo.*axis = std::max(std::min(box.lo.*axis, all.lo.*axis), box.lo.*axis - most);
        around.hi.*axis = std::min(std::max(box.hi.*axis, all.hi.*axis), box.hi.*axis + most);
    };
    for (const auto axis : {&Vec3::x, &Vec3::y, &Vec3::z}) reach(axis);
    return around;
}

/// Every corner is a vertex.
bool whole(const mesh::Mesh& m) {
    return std::all_of(m.triangles.begin(), m.triangles.end(), [&](const mesh::Triangle& t) {
        return std::max({t[0], t[1], t[2]}) < m.vertices.size();
    });
}

/// A sheet that says that there is nothing to show, with a sign that is understood without letters.
void nothing(picture::Work& work) {
    const double em = work.em;
    const picture::Rect r{work.width / 2 - 8 * em, work.height / 2 - 5 * em, 16 * em, 10 * em};
    const Pen pen{picture::faint, 0.15 * em};
    outline(work, r, pen);
    work.sheet.line({{r.left, r.top}, {r.right(), r.bottom()}}, pen);
    work.sheet.line({{r.left, r.bottom()}, {r.right(), r.top}}, pen);
    Words words{1.1 * em, picture::ink};
    words.share = 0.5;
    work.sheet.text({work.width / 2, r.bottom() + 3 * em}, "no machined surface to show", words);
    heading(work, "");
}

std::string draw(SheetFormat format, MillingView view, const MillingScene& scene, PictureSize size) {
    const int width = std::clamp(size.width, smallest_picture, largest_picture),
              height = std::clamp(size.height, smallest_picture, largest_picture);
    Sheet sheet(format, width, height);
    mesh::Box box;
    mesh::Shading normals;
    if (!scene.surface.empty() && whole(scene.surface)) box = shown(scene);
    if (!box.empty()) normals = relief_normals(scene.surface);
    // The projections stand close together.
    const double room = view == MillingView::projections ? 0.05 : 0.35;
    const mesh::Box around = box.empty() ? box : with_clamps(box, scene.clamps, room);
    picture::Work work{scene, sheet, normals, box, around, double(width), double(height), 13, true};
    work.em = 13 * std::min(width / 1200.0, height / 900.0);
    if (box.empty())
        nothing(work);
    else if (view == MillingView::plan)
        plan(work);
    else if (view == MillingView::projections)
        projections(work);
    else
        solid(work);
    return sheet.finish();
}

}  // namespace

std::string milling_png(MillingView view, const MillingScene& scene, PictureSize size) {
    return draw(SheetFormat::png, view, scene, size);
}

std::string milling_svg(MillingView view, const MillingScene& scene, PictureSize size) {
    return draw(SheetFormat::svg, view, scene, size);
}

}  // namespace obrys::report::picture
