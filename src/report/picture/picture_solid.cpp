/// The part in space, in parallel projection.
#include <algorithm>
#include <array>
#include <cmath>

#include "report/picture/picture_parts.hpp"

namespace obrys::report::picture::picture {

using geom::Vec2;
using geom::Vec3;

namespace {

/// From front, right and above: the eye 28 degrees to the right of the front and 36 degrees up.
Look from_corner() {
    const double a = geom::radians(28), e = geom::radians(36);
    return {{std::cos(a), std::sin(a), 0},
            {-std::sin(a) * std::sin(e), std::cos(a) * std::sin(e), std::cos(e)},
            {std::sin(a) * std::cos(e), -std::cos(a) * std::cos(e), std::sin(e)}};
}

std::array<Vec3, 8> corners_of(const mesh::Box& b) {
    std::array<Vec3, 8> out;
    for (std::size_t k = 0; k < 8; ++k)
        out[k] = {(k & 1) != 0 ? b.hi.x : b.lo.x, (k & 2) != 0 ? b.hi.y : b.lo.y, (k & 4) != 0 ? b.hi.z : b.lo.z};
    return out;
}

/// The stock's edges that can be seen: all but those at its hidden corner, left, back, below.
void stock_edges(Work& work, const Shot& shot) {
    constexpr std::size_t hidden = 2;
    const auto corner = corners_of(work.box);
    const Pen pen{{110, 116, 124}, 0.06 * work.em, {0.5 * work.em, 0.35 * work.em}};
    for (std::size_t a = 0; a < 8; ++a)
        for (const std::size_t bit : {1U, 2U, 4U}) {
            const std::size_t b = a | bit;
            if (b == a || a == hidden || b == hidden) continue;
            work.sheet.line({shot.place(corner[a]), shot.place(corner[b])}, pen);
        }
}

void stock_dimensions(Work& work, const Shot& shot) {
    const mesh::Box& b = work.box;
    const Vec3 size = b.size();
    const Vec3 front_left{b.lo.x, b.lo.y, b.lo.z}, front_right{b.hi.x, b.lo.y, b.lo.z},
        back_right{b.hi.x, b.hi.y, b.lo.z};
    const double off = 2.2 * work.em;
    const auto along = [&](Vec3 way) {
        const Vec2 flat = shot.place(b.lo + way) - shot.place(b.lo);
        return (1 / std::max(length(flat), 1e-9)) * flat;
    };
    dimension(work, shot.place(front_left), shot.place(front_right), -off * along({0, 1, 0}), size.x);
    dimension(work, shot.place(front_right), shot.place(back_right), off * along({1, 0, 0}), size.y);
    dimension(work, shot.place(front_left), shot.place({b.lo.x, b.lo.y, b.hi.z}), -off * along({1, 0, 0}), size.z);
}

}  // namespace

void solid(Work& work) {
    const double em = work.em;
    const Look look = from_corner();
    double right = 0, up = 0;  // half the extent seen, mm
    const Vec3 centre = work.box.centre();
    for (const Vec3 c : corners_of(work.around)) {
        right = std::max(right, std::abs(dot(c - centre, look.right)));
        up = std::max(up, std::abs(dot(c - centre, look.up)));
    }
    const double beside = work.scene.legend.empty() && work.scene.clamps.empty() ? 4 * em : 19 * em;
    const double free_width = work.width - 4.5 * em - beside, free_height = work.height - 11 * em;
    const double scale = std::min(free_width / (2 * right), free_height / (2 * up));
    const Rect area{4.5 * em + free_width / 2 - scale * right, 5 * em + free_height / 2 - scale * up, 2 * scale * right,
                    2 * scale * up};
    const Shot shot = shoot(
        work, look, area, scale, [&](const Spot& s) { return palette_colour(work.scene, s.triangle); }, 0.35);
    stock_edges(work, shot);
    stock_dimensions(work, shot);
    path(work, shot);
    datum(work, shot);
    marks(work, shot);
    legend(work, {work.width - 17 * em, 7 * em});
    axes(work, look, {3 * em, work.height - 2.6 * em});
    const Vec3 size = work.box.size();
    heading(work,
            "3D; stock " + millimetres(size.x) + " x " + millimetres(size.y) + " x " + millimetres(size.z) + " mm");
}

}  // namespace obrys::report::picture::picture
