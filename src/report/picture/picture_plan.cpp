/// Plan view: heights as colours, the deeper the darker.
#include <algorithm>
#include <array>
#include <cmath>

#include "base/whole.hpp"
#include "report/picture/picture_parts.hpp"
#include "report/svg_window.hpp"

namespace obrys::report::picture::picture {

using geom::Vec2;
using geom::Vec3;
using mesh::Colour;

namespace {

/// Heights and the colours they have: the first one at `top`, the last one at `bottom`.
struct HeightScale {
    double top = 0, bottom = 0;

    [[nodiscard]] Colour colour(double z) const {
        constexpr std::array<Colour, 5> stops{
            {{248, 244, 226}, {176, 212, 192}, {84, 158, 184}, {40, 92, 154}, {18, 34, 88}}};
        const double share = top - bottom > 1e-9 ? std::clamp((top - z) / (top - bottom), 0.0, 1.0) : 0;
        const double place = share * (stops.size() - 1);
        const auto first = base::clipped<std::size_t>(place, 0, stops.size() - 2);
        const double k = place - static_cast<double>(first);
        const auto mix = [k](int a, int b) { return base::clipped<std::uint8_t>(a + k * (b - a) + 0.5, 0, 255); };
        const Colour &a = stops[first], &b = stops[first + 1];
        return {mix(a.red, b.red), mix(a.green, b.green), mix(a.blue, b.blue)};
    }
};

/// From the highest to the lowest place that is seen from above.
HeightScale heights(const Work& work, const Rect& area, double px_per_mm) {
    Camera c;
    c.centre = work.box.centre();
    c.px_per_mm = px_per_mm / 2;
    c.width = base::clipped<int>(area.width / 2, 0, most_pixels);
    c.height = base::clipped<int>(area.height / 2, 0, most_pixels);
    c.x = area.width / 4;
    c.y = area.height / 4;
    const Visible seen = rasterise(work.scene.surface, c);
    HeightScale out{-INFINITY, INFINITY};
    std::uint32_t deepest = Visible::none;
    for (std::size_t at = 0; at < seen.depth.size(); ++at) {
        if (seen.triangle[at] == Visible::none) continue;
        const double z = c.centre.z + static_cast<double>(seen.depth[at]);
        out.top = std::max(out.top, z);
        if (z < out.bottom) deepest = seen.triangle[at];
        out.bottom = std::min(out.bottom, z);
    }
    // A drill's tip lies between the middles of pixels.
    if (deepest != Visible::none)
        for (const Vec3 corner : mesh::corners(work.scene.surface, deepest))
            out.bottom = std::min(out.bottom, corner.z);
    if (!(out.bottom <= out.top)) return {work.box.hi.z, work.box.lo.z};
    return out;
}

void label(Work& work, const Rect& bar, double at, double mm, bool strong) {
    work.sheet.line({{bar.right(), at}, {bar.right() + 0.5 * work.em, at}}, {ink});
    Words words{0.95 * work.em, strong ? ink : faint};
    words.bold = strong;
    work.sheet.text({bar.right() + 0.9 * work.em, at + 0.33 * work.em}, millimetres(mm), words);
}

/// The levels of flat areas in strong letters, round heights between them.
void height_labels(Work& work, const Rect& bar, const HeightScale& scale, const std::vector<double>& levels) {
    std::vector<double> taken;
    const auto put = [&](double mm, bool strong) {
        const double span = scale.top - scale.bottom;
        const double at = span > 1e-9 ? bar.top + bar.height * (scale.top - mm) / span : bar.top;
        for (const double other : taken)
            if (std::abs(other - at) < 1.35 * work.em) return;
        taken.push_back(at);
        label(work, bar, at, mm, strong);
    };
    for (const double z : levels)
        if (z <= scale.top + 0.01 && z >= scale.bottom - 0.01) put(std::clamp(z, scale.bottom, scale.top), true);
    put(scale.top, false);
    put(scale.bottom, false);
    if (!(scale.top - scale.bottom > 1e-6)) return;
    const double step = svg::round_step((scale.top - scale.bottom) * 3 * work.em / bar.height);
    for (double i = std::ceil(scale.bottom / step); i <= std::floor(scale.top / step); ++i) put(i * step, false);
}

void height_legend(Work& work, const HeightScale& scale, const std::vector<double>& levels, Rect bar) {
    constexpr int bands = 96;
    work.sheet.text({bar.left, bar.top - 1.4 * work.em}, "Z mm", {work.em, ink});
    const double span = scale.top - scale.bottom;
    for (int k = 0; k < bands; ++k) {
        const double y = bar.top + bar.height * k / bands, below = bar.top + bar.height * (k + 1.0) / bands;
        const Colour c = scale.colour(scale.top - span * (k + 0.5) / bands);
        work.sheet.area({{bar.left, y}, {bar.right(), y}, {bar.right(), below + 0.5}, {bar.left, below + 0.5}}, c);
    }
    outline(work, bar, {ink, 0.8});
    height_labels(work, bar, scale, levels);
    const Rect swatch{bar.left, bar.bottom() + 2.2 * work.em, bar.width, 1.2 * work.em};
    hatch(work, swatch, {faint, 0.7});
    outline(work, swatch, {ink, 0.8});
    work.sheet.text({swatch.right() + 0.9 * work.em, swatch.bottom() - 0.2 * work.em}, "through",
                    {0.95 * work.em, ink});
    const double longer = std::max(0.0, static_cast<double>(work.scene.clamp_name.size()) - 8);  // letters
    clamp_legend(work, {bar.left - 0.55 * work.em * longer, swatch.bottom() + 2 * work.em});
}

}  // namespace

void plan(Work& work) {
    const double em = work.em;
    const Vec3 size = work.box.size();
    const double free_width = work.width - 18 * em, free_height = work.height - 14 * em;
    const Vec3 whole = work.around.size();
    const double scale = std::min(free_width / whole.x, free_height / whole.y);
    const Rect area{5 * em + (free_width - scale * whole.x) / 2 + scale * (work.box.lo.x - work.around.lo.x),
                    7 * em + (free_height - scale * whole.y) / 2 + scale * (work.around.hi.y - work.box.hi.y),
                    scale * size.x, scale * size.y};
    hatch(work, area, {{214, 218, 224}, 0.8});
    const HeightScale colours = heights(work, area, scale);
    const double base = work.box.centre().z;
    const Shot shot = shoot(
        work, from_above, area, scale, [&](const Spot& s) { return colours.colour(base + s.depth); }, 0.7);
    outline(work, area, {ink, 0.8, {0.6 * em, 0.35 * em}});
    draw(work, {Side::bottom, area.bottom() + 0.5 * em, work.box.lo.x, work.box.hi.x, area.left, area.right()});
    draw(work, {Side::left, area.left - 0.5 * em, work.box.lo.y, work.box.hi.y, area.bottom(), area.top});
    dimension(work, {area.left, area.top}, {area.right(), area.top}, {0, -1.6 * em}, size.x);
    dimension(work, {area.right(), area.bottom()}, {area.right(), area.top}, {1.9 * em, 0}, size.y);
    path(work, shot);
    datum(work, shot);
    marks(work, shot);
    const double top = 9 * em;
    height_legend(work, colours, flat_heights(shot.visible, base),
                  {work.width - 7.5 * em, top, 1.6 * em, std::max(work.height - top - 11 * em, 3 * em)});
    axes(work, from_above, {2 * em, work.height - 1.6 * em});
    scale_bar(work, scale, {9 * em, work.height - 1.6 * em});
    heading(work, "plan view; Z above workpiece zero, stock " + millimetres(size.x) + " x " + millimetres(size.y) +
                      " x " + millimetres(size.z) + " mm");
}

}  // namespace obrys::report::picture::picture
