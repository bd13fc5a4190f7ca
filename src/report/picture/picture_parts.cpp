#include "report/picture/picture_parts.hpp"

#include <algorithm>
#include <cmath>

#include "base/number.hpp"
#include "report/svg_window.hpp"

namespace obrys::report::picture::picture {

using geom::Vec2;
using geom::Vec3;

std::string millimetres(double value) { return base::shortest(std::round(value * 1000) / 1000 + 0.0); }

void arrow(Work& work, Vec2 from, Vec2 to, const Pen& pen) {
    const double size = distance(from, to);
    if (!(size > 0)) return;
    const Vec2 along = (1 / size) * (to - from), aside = geom::left_of(along);
    const double head = 0.55 * work.em;
    work.sheet.line({from, to - head * along}, pen);
    work.sheet.area({to, to - head * along + 0.3 * head * aside, to - head * along - 0.3 * head * aside}, pen.colour);
}

void outline(Work& work, const Rect& r, const Pen& pen) {
    work.sheet.line(
        {{r.left, r.top}, {r.right(), r.top}, {r.right(), r.bottom()}, {r.left, r.bottom()}, {r.left, r.top}}, pen);
}

void hatch(Work& work, const Rect& r, const Pen& pen) {
    work.sheet.clip({r.left, r.top}, {r.width, r.height});
    const double pitch = 0.7 * work.em;
    for (double x = r.left - r.height; x < r.right(); x += pitch)
        work.sheet.line({{x, r.bottom()}, {x + r.height, r.top}}, pen);
    work.sheet.unclip();
}

void draw(Work& work, const Ruler& ruler) {
    const double span = ruler.to - ruler.from, px = std::abs(ruler.last - ruler.first);
    if (!(span > 0) || !(px > 0)) return;
    const bool below = ruler.side == Side::bottom;
    const double step = svg::round_step((below ? 4.5 : 2.6) * work.em * span / px);
    const double tick = 0.4 * work.em;
    for (double i = std::ceil(ruler.from / step - 1e-9); i <= std::floor(ruler.to / step + 1e-9); ++i) {
        const double mm = i * step;
        const double at = ruler.first + (ruler.last - ruler.first) * (mm - ruler.from) / span;
        Words words{0.85 * work.em, ink};
        if (below) {
            work.sheet.line({{at, ruler.at}, {at, ruler.at + tick}}, {ink});
            words.share = 0.5;
            work.sheet.text({at, ruler.at + tick + work.em}, millimetres(mm), words);
        } else {
            work.sheet.line({{ruler.at - tick, at}, {ruler.at, at}}, {ink});
            words.share = 1;
            work.sheet.text({ruler.at - 1.4 * tick, at + 0.3 * work.em}, millimetres(mm), words);
        }
    }
}

void dimension(Work& work, Vec2 a, Vec2 b, Vec2 offset, double mm) {
    const double size = distance(a, b), off = length(offset);
    if (!(size > 0) || !(off > 0)) return;
    const Vec2 out = (1 / off) * offset, along = (1 / size) * (b - a);
    const Pen thin{ink, 0.7 * work.em / 13};
    for (const Vec2 end : {a, b})
        work.sheet.line({end + 0.25 * work.em * out, end + offset + 0.4 * work.em * out}, thin);
    const Vec2 from = a + offset, to = b + offset, middle = 0.5 * (from + to);
    if (size > 2.5 * work.em) {
        arrow(work, middle, from, thin);
        arrow(work, middle, to, thin);
    } else {
        arrow(work, from - 1.2 * work.em * along, from, thin);
        arrow(work, to + 1.2 * work.em * along, to, thin);
        work.sheet.line({from, to}, thin);
    }
    Words words{work.em, ink};
    words.share = 0.5;
    words.halo = true;
    words.upward = std::abs(along.x) < 0.02;
    const Vec2 base = words.upward ? Vec2{-0.4 * work.em, 0} : Vec2{0, -0.4 * work.em};
    work.sheet.text(middle + base, millimetres(mm), words);
}

void axes(Work& work, const Look& look, Vec2 at) {
    const struct {
        Vec3 axis;
        const char* name;
        mesh::Colour colour;
    } all[] = {{{1, 0, 0}, "X", {190, 40, 40}}, {{0, 1, 0}, "Y", {30, 130, 50}}, {{0, 0, 1}, "Z", {30, 70, 180}}};
    for (const auto& one : all) {
        const Vec2 way{dot(one.axis, look.right), -dot(one.axis, look.up)};
        if (length(way) < 0.05) continue;
        const Pen pen{one.colour, 0.12 * work.em};
        arrow(work, at, at + 3.2 * work.em * way, pen);
        Words words{work.em, one.colour};
        words.share = 0.5;
        words.bold = true;
        work.sheet.text(at + (3.2 * work.em + 0.8 * work.em / length(way)) * way + Vec2{0, 0.35 * work.em}, one.name,
                        words);
    }
}

void scale_bar(Work& work, double px_per_mm, Vec2 at) {
    const double mm = svg::round_step(7 * work.em / px_per_mm), size = mm * px_per_mm, tick = 0.35 * work.em;
    const Pen pen{ink, 0.12 * work.em};
    work.sheet.line({{at.x, at.y - tick}, {at.x, at.y}, {at.x + size, at.y}, {at.x + size, at.y - tick}}, pen);
    Words words{0.9 * work.em, ink};
    words.share = 0.5;
    work.sheet.text({at.x + size / 2, at.y - 0.5 * work.em}, millimetres(mm) + " mm", words);
}

void datum(Work& work, const Shot& shot) {
    const Vec3 zero{0, 0, 0}, size = work.box.size();
    const double slack = 1e-6 * (size.x + size.y + size.z);
    const auto shown = [&](double lo, double hi, double sees) {
        return std::abs(sees) > 0.999 || (lo <= slack && hi >= -slack);
    };
    const Vec3 t = shot.camera.toward;
    if (!shown(work.box.lo.x, work.box.hi.x, t.x) || !shown(work.box.lo.y, work.box.hi.y, t.y) ||
        !shown(work.box.lo.z, work.box.hi.z, t.z))
        return;
    const Vec2 at = shot.place(zero);
    const double r = 0.55 * work.em;
    work.sheet.disc(at, r, {255, 255, 255});
    for (const double turn : {0.0, geom::pi}) {
        std::vector<Vec2> quarter{at};
        for (int k = 0; k <= 8; ++k) {
            const double angle = turn + k * geom::pi / 16;
            quarter.push_back(at + Vec2{r * std::cos(angle), r * std::sin(angle)});
        }
        work.sheet.area(quarter, ink);
    }
    work.sheet.circle(at, r, {ink, 0.08 * work.em});
}

namespace {

void legend_entry(Work& work, Vec2 at, mesh::Colour colour, const std::string& text) {
    const Rect box{at.x, at.y - 0.85 * work.em, 1.5 * work.em, work.em};
    work.sheet.area(
        {{box.left, box.top}, {box.right(), box.top}, {box.right(), box.bottom()}, {box.left, box.bottom()}}, colour);
    outline(work, box, {ink, 0.6});
    work.sheet.text({at.x + 2.1 * work.em, at.y}, text, {work.em, ink});
}

}  // namespace

void clamp_legend(Work& work, Vec2 at) {
    if (!work.scene.clamps.empty()) legend_entry(work, at, clamp, work.scene.clamp_name);
}

void legend(Work& work, Vec2 at) {
    for (const PictureLegend& entry : work.scene.legend) {
        if (at.y > work.height - work.em) return;
        legend_entry(work, at, entry.colour, entry.text);
        at.y += 1.6 * work.em;
    }
    if (at.y <= work.height - work.em) clamp_legend(work, at);
}

void heading(Work& work, const std::string& what) {
    Words title{1.25 * work.em, ink};
    title.bold = true;
    work.sheet.text({1.2 * work.em, 1.9 * work.em}, work.scene.title, title);
    const std::string short_of = work.complete ? "" : "; not complete: the surface overlaps itself too often";
    work.sheet.text({1.2 * work.em, 3.5 * work.em}, what + short_of, {work.em, {90, 96, 104}});
}

}  // namespace obrys::report::picture::picture
