/// Front view and left side view, both cut open, and the plan below: first angle projection (ISO 5456-2), one scale.
#include <algorithm>
#include <cmath>
#include <functional>

#include "report/picture/picture_parts.hpp"

namespace obrys::report::picture::picture {

using geom::Vec2;
using geom::Vec3;

namespace {

struct Sheets {
    double scale = 1;  ///< px/mm
    Rect front, top, side;
};

Sheets arrange(const Work& work) {
    const double em = work.em, gap = 6 * em, left = 5 * em, above = 10 * em;
    const Vec3 size = work.box.size();
    const double free_width = work.width - left - gap - 5 * em, free_height = work.height - above - gap - 6 * em;
    Sheets s;
    s.scale = std::min(free_width / (size.x + size.y), free_height / (size.z + size.y));
    const double x = s.scale * size.x, y = s.scale * size.y, z = s.scale * size.z;
    const double from_left = left + (free_width - x - y) / 2, from_top = above + (free_height - z - y) / 2;
    s.front = {from_left, from_top, x, z};
    s.top = {from_left, from_top + z + gap, x, y};
    s.side = {from_left + x + gap, from_top, y, z};
    return s;
}

/// Where the views are cut: as asked for, else in the middle.
Vec3 cut_of(const Work& work) {
    const Vec3 middle = work.box.centre(), lo = work.box.lo, hi = work.box.hi;
    const Vec2 asked = work.scene.cut;
    const double x = std::isfinite(asked.x) ? std::clamp(asked.x, lo.x, hi.x) : middle.x;
    const double y = std::isfinite(asked.y) ? std::clamp(asked.y, lo.y, hi.y) : middle.y;
    return {x, y, middle.z};
}

/// The cut's line over the plan with the way one looks, and its letter.
void cut_line(Work& work, Vec2 a, Vec2 b, Vec2 look, const char* letter) {
    const double em = work.em, size = distance(a, b);
    if (!(size > 0)) return;
    const Vec2 out = (0.8 * em / size) * (b - a), from = a - out, to = b + out;
    work.sheet.line({from, to}, {red, 0.08 * em, {1.2 * em, 0.3 * em, 0.2 * em, 0.3 * em}});
    Words words{em, red, 0.5, false, true, true};
    for (const Vec2 end : {from, to}) {
        work.sheet.line({end, end + (end == from ? 1.0 : -1.0) * out}, {red, 0.2 * em});
        arrow(work, end, end + 1.5 * em * look, {red, 0.1 * em});
        work.sheet.text(
            end + 0.8 * em * look + 0.9 * em * Vec2{std::abs(look.y), std::abs(look.x)} + Vec2{0, 0.35 * em}, letter,
            words);
    }
}

void title(Work& work, const Rect& view, const std::string& content) {
    Words words{work.em, red};
    words.bold = true;
    work.sheet.text({view.left, view.top - 3.6 * work.em}, content, words);
}

/// The heights of flat areas beside a view, with room for each.
void levels(Work& work, const Rect& view, std::vector<double> heights) {
    const double em = work.em, size = work.box.size().z;
    std::sort(heights.begin(), heights.end(), std::greater<>());
    double free_from = -INFINITY;
    for (const double z : heights) {
        const double at = view.bottom() - view.height * (z - work.box.lo.z) / size;
        const double words_at = std::max(at, free_from);
        free_from = words_at + 1.15 * em;
        const double x = view.right() + 0.3 * em;
        work.sheet.line({{x, at}, {x + 0.5 * em, at}, {x + 1.2 * em, words_at}, {x + 1.6 * em, words_at}},
                        {blue, 0.08 * em});
        work.sheet.text({x + 1.9 * em, words_at + 0.33 * em}, millimetres(z), {0.9 * em, blue});
    }
}

/// The sign of first angle projection: a cone's stump with its thin end to the left, and that seen from the left.
void projection_sign(Work& work, Vec2 at) {
    const double em = work.em, thin = 0.55 * em, thick = 1.1 * em, size = 2.4 * em;
    const Pen pen{ink, 0.1 * em}, axis{ink, 0.06 * em, {0.6 * em, 0.2 * em, 0.15 * em, 0.2 * em}};
    work.sheet.line({{at.x, at.y - thin},
                     {at.x + size, at.y - thick},
                     {at.x + size, at.y + thick},
                     {at.x, at.y + thin},
                     {at.x, at.y - thin}},
                    pen);
    const Vec2 centre{at.x + size + 2.2 * em, at.y};
    work.sheet.circle(centre, thin, pen);
    work.sheet.circle(centre, thick, pen);
    work.sheet.line({{at.x - 0.5 * em, at.y}, {centre.x + 1.6 * em, at.y}}, axis);
    work.sheet.line({{centre.x, at.y - 1.6 * em}, {centre.x, at.y + 1.6 * em}}, axis);
}

void scales(Work& work, const Sheets& s) {
    const mesh::Box& b = work.box;
    const double off = 0.5 * work.em, dim = 1.6 * work.em;
    draw(work, {Side::left, s.front.left - off, b.lo.z, b.hi.z, s.front.bottom(), s.front.top});
    draw(work, {Side::left, s.top.left - off, b.lo.y, b.hi.y, s.top.bottom(), s.top.top});
    draw(work, {Side::bottom, s.top.bottom() + off, b.lo.x, b.hi.x, s.top.left, s.top.right()});
    draw(work, {Side::bottom, s.side.bottom() + off, b.lo.y, b.hi.y, s.side.right(), s.side.left});
    const Vec3 size = b.size();
    dimension(work, {s.front.left, s.front.top}, {s.front.right(), s.front.top}, {0, -dim}, size.x);
    dimension(work, {s.side.left, s.side.top}, {s.side.right(), s.side.top}, {0, -dim}, size.y);
    dimension(work, {s.side.right(), s.side.bottom()}, {s.side.right(), s.side.top}, {1.3 * dim, 0}, size.z);
}

}  // namespace

void projections(Work& work) {
    const double em = work.em;
    const Sheets s = arrange(work);
    const Vec3 cut = cut_of(work);
    const auto colour = [&](const Spot& spot) { return palette_colour(work.scene, spot.triangle); };
    const Pen thin{{110, 116, 124}, 0.06 * em, {0.5 * em, 0.35 * em}};
    const Shot front = shoot(work, from_front, s.front, s.scale, colour, 0.35, &cut);
    const Shot side = shoot(work, from_left, s.side, s.scale, colour, 0.35, &cut);
    const Shot top = shoot(work, from_above, s.top, s.scale, colour, 0.35);
    for (const Rect& view : {s.front, s.side, s.top}) outline(work, view, thin);
    for (const Shot* shot : {&front, &side, &top}) path(work, *shot);
    scales(work, s);
    levels(work, s.front, flat_heights(top.visible, work.box.centre().z));
    const double x = top.place(cut).x, y = top.place(cut).y;
    cut_line(work, {s.top.left, y}, {s.top.right(), y}, {0, -1}, "A");
    cut_line(work, {x, s.top.top}, {x, s.top.bottom()}, {1, 0}, "B");
    title(work, s.front, "A-A   Y " + millimetres(cut.y));
    title(work, s.side, "B-B   X " + millimetres(cut.x));
    for (const Shot* shot : {&front, &side, &top}) datum(work, *shot);
    for (const Shot* shot : {&front, &side, &top}) marks(work, *shot);
    legend(work, {s.side.left, s.side.bottom() + 6 * em});
    axes(work, from_above, {2 * em, work.height - 1.6 * em});
    scale_bar(work, s.scale, {9 * em, work.height - 1.6 * em});
    projection_sign(work, {work.width - 7.5 * em, work.height - 2.4 * em});
    heading(work, "three projections; cut at the lines A and B, heights of flat areas in blue");
}

}  // namespace obrys::report::picture::picture
