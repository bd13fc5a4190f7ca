#include "sim/milling/cut/job.hpp"

#include <algorithm>
#include <cmath>

#include "base/whole.hpp"

namespace obrys::sim::milling {
namespace {

using geom::Vec3;

/// Half the width of the shape's shadow beside its axis, seen along x, y or z.
double spread(const Shape& shape, Vec3 axis, int of) {
    const double along = component(axis, of);
    return shape.radius * std::sqrt(std::max(0.0, 1 - along * along));
}

struct Reach {
    double low = 0, high = 0;
};

/// Extent of the shape's heights along a direction, from the tip.
Reach extent(Reach heights, double axis_along, double beside) {
    const double a = heights.low * axis_along, b = heights.high * axis_along;
    return {std::min(a, b) - beside, std::max(a, b) + beside};
}

/// Heights of the shape that can lie in the box at some time of its way; of a long tool that leans a small part.
Reach heights_in(const Box3& box, const Job& job, double bulge) {
    Reach heights{job.shape->bottom, job.shape->top};
    for (int axis = 0; axis < 3; ++axis) {
        const double lean = component(job.frame.z, axis);
        if (std::abs(lean) < 1e-6) continue;
        const double at = component(job.from, axis), moved = at + component(job.way, axis);
        const double beside = spread(*job.shape, job.frame.z, axis) + bulge + 1e-9;
        const double one = (component(box.min, axis) - beside - std::max(at, moved)) / lean;
        const double other = (component(box.max, axis) + beside - std::min(at, moved)) / lean;
        heights.low = std::max(heights.low, std::min(one, other));
        heights.high = std::min(heights.high, std::max(one, other));
    }
    return heights;
}

int clamped(double v, int count) { return base::clipped<int>(v, -1, count); }

}  // namespace

Job make_job(const Shape& shape, const Orientation& frame, const Track& track, Vec3 from, const Box3& stock) {
    Job job;
    job.shape = &shape;
    job.frame = frame;
    job.track = track;
    job.from = from;
    job.way = frame.to_stock(track.v);
    const Vec3 a{std::abs(frame.z.x), std::abs(frame.z.y), std::abs(frame.z.z)};
    job.main = a.z >= a.x && a.z >= a.y ? 2 : a.y >= a.x ? 1 : 0;
    const geom::Vec2 flat{track.v.x, track.v.y};
    const double way = geom::length(flat);
    // Along the axis but for what turning the frame rounds: there is no side.
    constexpr double rounding = 1e-9;
    if (way > rounding * std::abs(track.v.z)) job.heading = (1 / way) * flat;
    // An arc of at most a quarter turn stands off its chord by this much.
    const double bulge =
        track.circular ? track.radius - std::sqrt(std::max(0.0, track.radius * track.radius - way * way / 4)) : 0;
    const Reach heights = heights_in(stock, job, bulge);
    for (int axis = 0; axis < 3; ++axis) {
        Vec3 unit;
        set_component(unit, axis, 1);
        const Lie lie = frame.along < 0 ? Lie::skew : frame.along == axis ? Lie::along : Lie::across;
        job.aims[static_cast<std::size_t>(axis)] = aims_of(track, frame.to_tool(unit), lie);
        const Reach r = extent(heights, component(frame.z, axis), spread(shape, frame.z, axis));
        const double at = component(from, axis), moved = at + component(job.way, axis);
        const double room = bulge * std::sqrt(std::max(0.0, 1 - component(frame.z, axis) * component(frame.z, axis)));
        set_component(job.box.min, axis, std::min(at, moved) + r.low - room);
        set_component(job.box.max, axis, std::max(at, moved) + r.high + room);
        if (heights.low > heights.high)
            set_component(job.box.max, axis, -never), set_component(job.box.min, axis, never);
    }
    return job;
}

void join(Tally& into, const Tally& t) {
    into.touched = into.touched || t.touched;
    into.length += t.length;
    into.lowest = std::min(into.lowest, t.lowest);
    into.highest = std::max(into.highest, t.highest);
    into.rightmost = std::min(into.rightmost, t.rightmost);
    into.leftmost = std::max(into.leftmost, t.leftmost);
    if (t.depth > into.depth) {
        into.depth = t.depth;
        into.deepest = t.deepest;
    }
    if (t.stacks.to_tip.height > 0) into.stacks.to_tip.take(t.stacks.to_tip);
    if (t.stacks.seen.height > 0) into.stacks.seen.take(t.stacks.seen);
}

TileRange tiles_of(const Job& job, const Dexels& dexels, int axis) {
    const Lattice& l = dexels.lattice();
    const auto indices = [&](int across, int count) {
        const double low = (component(job.box.min, across) - component(l.origin, across)) / component(l.step, across);
        const double high = (component(job.box.max, across) - component(l.origin, across)) / component(l.step, across);
        return std::pair{std::max(0, clamped(std::ceil(low), count)),
                         std::min(count - 1, clamped(std::floor(high), count))};
    };
    const double own_low = component(l.origin, axis);
    const double own_high = own_low + (l.count[static_cast<std::size_t>(axis)] - 1) * component(l.step, axis);
    if (component(job.box.max, axis) < own_low || component(job.box.min, axis) > own_high) return {};
    const auto [a0, a1] = indices(first_across(axis), dexels.rays_a(axis));
    const auto [b0, b1] = indices(second_across(axis), dexels.rays_b(axis));
    if (a0 > a1 || b0 > b1) return {};
    return {a0 / Tile::edge, a1 / Tile::edge + 1, b0 / Tile::edge, b1 / Tile::edge + 1};
}

bool may_touch(const Job& job, const Lattice& lattice, int axis, int ta, int tb) {
    const int first = first_across(axis), second = second_across(axis);
    const double vu = component(job.way, first), vv = component(job.way, second), way = std::hypot(vu, vv);
    if (!(way > Tile::edge * component(lattice.step, first)) || job.track.circular) return true;
    const double nu = -vv / way, nv = vu / way;  // across the way
    const auto middle = [&](int across, int tile) {
        return component(lattice.origin, across) +
               (tile * Tile::edge + 0.5 * (Tile::edge - 1)) * component(lattice.step, across);
    };
    const double half = 0.5 * (Tile::edge - 1);
    const double tile_half =
        half * (component(lattice.step, first) * std::abs(nu) + component(lattice.step, second) * std::abs(nv));
    const double at =
        (middle(first, ta) - component(job.from, first)) * nu + (middle(second, tb) - component(job.from, second)) * nv;
    const double lean = component(job.frame.z, first) * nu + component(job.frame.z, second) * nv;
    const Reach r = extent({job.shape->bottom, job.shape->top}, lean, job.shape->radius);
    return at + tile_half >= r.low && at - tile_half <= r.high;
}

}  // namespace obrys::sim::milling
