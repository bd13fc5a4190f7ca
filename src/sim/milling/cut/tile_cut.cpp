// One job after the other on the rays of a tile.

#include <algorithm>
#include <cmath>

#include "base/whole.hpp"
#include "sim/milling/cut/job.hpp"
#include "sim/milling/nearest.hpp"
#include "sim/milling/rays/rows.hpp"

namespace obrys::sim::milling {
namespace {

using geom::Vec2;
using geom::Vec3;

constexpr double lower_than_all = -std::numeric_limits<double>::infinity();

/// A tile and where its rays lie.
struct TilePlace {
    Tile& tile;
    int axis = 2;
    int count_a = 0, count_b = 0;  ///< rays of this tile that the lattice has
    Vec3 node, step_a, step_b;     ///< ray (0, 0) where its own coordinate is 0, and the ways to the next rays
    double lowest = 0, highest = lower_than_all;  ///< of the material
};

struct Window {
    int a0 = 0, a1 = 0, b0 = 0, b1 = 0;  ///< first, and one past the last
};

TilePlace place_of(Tile& tile, const Lattice& l, int axis, int ta, int tb) {
    const int first = first_across(axis), second = second_across(axis);
    TilePlace p{tile, axis, 0, 0, {}, {}, {}};
    p.count_a = std::min(Tile::edge, l.count[static_cast<std::size_t>(first)] - ta * Tile::edge);
    p.count_b = std::min(Tile::edge, l.count[static_cast<std::size_t>(second)] - tb * Tile::edge);
    set_component(p.node, first, component(l.origin, first) + ta * Tile::edge * component(l.step, first));
    set_component(p.node, second, component(l.origin, second) + tb * Tile::edge * component(l.step, second));
    set_component(p.step_a, first, component(l.step, first));
    set_component(p.step_b, second, component(l.step, second));
    p.lowest = std::numeric_limits<double>::infinity();
    for (int local = 0; local < Tile::rays; ++local) {
        p.highest = std::max(p.highest, tile.upper(local));
        if (const auto ray = tile.ray(local); !ray.empty()) p.lowest = std::min(p.lowest, ray.front().begin);
    }
    return p;
}

/// Rays of the tile inside the job's box.
Window window_of(const TilePlace& p, const Job& job) {
    const auto range = [&](int across, Vec3 step, int count) {
        const double at = component(p.node, across), s = component(step, across);
        const double low = std::ceil((component(job.box.min, across) - at) / s);
        const double high = std::floor((component(job.box.max, across) - at) / s);
        return std::pair{base::clipped<int>(low, 0, count), base::clipped<int>(high, -1, count - 1) + 1};
    };
    const auto [a0, a1] = range(first_across(p.axis), p.step_a, p.count_a);
    const auto [b0, b1] = range(second_across(p.axis), p.step_b, p.count_b);
    return {a0, a1, b0, b1};
}

/// A row of rays and where its rays are in the tile.
struct RayRow {
    Row row;
    int local = 0, stride = 1;
};

class Worker {
public:
    Worker(const TilePlace& place, const Job& job, Tally& tally)
        : place_(place),
          job_(job),
          tally_(tally),
          aims_(job.aims[static_cast<std::size_t>(place.axis)]),
          measured_(place.axis == job.main),
          base_(component(job.from, place.axis)) {
        const Orientation& f = job.frame;
        d_ = {component(f.x, place.axis), component(f.y, place.axis), component(f.z, place.axis)};
        Vec3 start = place.node - job.from;
        set_component(start, place.axis, 0);
        start_ = normal_part(f.to_tool(start));
        step_a_ = normal_part(f.to_tool(place.step_a));
        step_b_ = normal_part(f.to_tool(place.step_b));
    }

    void run(const Window& w) {
        if (aims_.lie == Lie::along && d_.z > 0 && job_.shape->rising &&
            place_.highest <= base_ + job_.shape->top + std::min(0.0, job_.track.v.z)) {
            from_above(w);
            return;
        }
        // Rows of rays across the tool must be of one height.
        const bool along_b = aims_.lie == Lie::across && job_.frame.along == first_across(place_.axis);
        const int rows = along_b ? w.a1 - w.a0 : w.b1 - w.b0, stride = along_b ? Tile::edge : 1;
        for (int i = 0; i < rows; ++i) {
            int a = along_b ? w.a0 + i : w.a0, b = along_b ? w.b0 : w.b0 + i,
                count = along_b ? w.b1 - w.b0 : w.a1 - w.a0;
            // Rays at the row's ends that are known to be empty all along the job's box.
            int local = b * Tile::edge + a, skipped = 0;
            for (; count > 0 && is_empty(local); local += stride, --count) ++skipped;
            for (; count > 0 && is_empty(local + (count - 1) * stride);) --count;
            if (count == 0) continue;
            (along_b ? b : a) += skipped;
            const RayRow c = course(a, b, count, along_b);
            const auto worth = [&](int n, double low, double high) {
                return place_.tile.first_met(c.local + n * c.stride, base_ + low, base_ + high) >= 0;
            };
            cut_row(*job_.shape, job_.track, c.row, aims_, worth, [&](const Spans& spans) { apply(c, spans); });
        }
    }

private:
    /// Normal to the rays also in the tool's frame, where rounding may have moved it.
    [[nodiscard]] Vec3 normal_part(Vec3 p) const { return aims_.lie == Lie::skew ? p - dot(p, d_) * d_ : p; }

    [[nodiscard]] bool is_empty(int local) const {
        return place_.tile.gaps_low()[local] <= component(job_.box.min, place_.axis) &&
               component(job_.box.max, place_.axis) <= place_.tile.gaps_high()[local];
    }

    [[nodiscard]] RayRow course(int a, int b, int count, bool along_b) const {
        RayRow c;
        c.local = b * Tile::edge + a;
        c.stride = along_b ? Tile::edge : 1;
        c.row.p = start_ + a * step_a_ + b * step_b_;
        c.row.step = along_b ? step_b_ : step_a_;
        c.row.d = d_;
        c.row.count = count;
        return c;
    }

    /// Rays along the axis under a tool that rises: only rows that hold material above the tool's lower side.
    void from_above(const Window& w) {
        const double level = base_ + std::min(0.0, job_.track.v.z);
        Spans spans;
        for (int b = w.b0; b < w.b1; ++b) {
            const double* upper = place_.tile.uppers() + b * Tile::edge;
            double highest = lower_than_all;
            for (int a = w.a0; a < w.a1; ++a) highest = upper[a] > highest ? upper[a] : highest;
            if (highest <= level + job_.shape->bottom + thinnest) continue;
            if (highest <= level + lower_side(*job_.shape, least_distance(w, b)) + thinnest) continue;
            const RayRow c = course(w.a0, b, w.a1 - w.a0, false);
            cut_row_from_above(*job_.shape, job_.track, c.row, aims_, spans);
            apply(c, spans);
        }
    }

    /// No ray of the row is nearer to the tip's way than this.
    [[nodiscard]] double least_distance(const Window& w, int b) const {
        if (job_.track.circular) return 0;
        const int first = first_across(place_.axis), second = second_across(place_.axis);
        const auto gap = [&](int across, double low, double high) {
            const double at = component(job_.from, across), moved = at + component(job_.way, across);
            return std::max({0.0, low - std::max(at, moved), std::min(at, moved) - high});
        };
        const double u = component(place_.node, first),
                     v = component(place_.node, second) + b * component(place_.step_b, second);
        const double step = component(place_.step_a, first);
        const double du = gap(first, u + w.a0 * step, u + (w.a1 - 1) * step), dv = gap(second, v, v);
        return std::sqrt(du * du + dv * dv);
    }

    void apply(const RayRow& c, const Spans& spans) {
        std::array<int, Row::most> rays;
        const double* low_gaps = place_.tile.gaps_low() + c.local;
        const double* high_gaps = place_.tile.gaps_high() + c.local;
        std::array<double, Row::most> low_copy, high_copy;
        if (c.stride != 1) {
            low_copy.fill(0);
            high_copy.fill(0);
            for (int i = 0; i < c.row.count; ++i) {
                low_copy[static_cast<std::size_t>(i)] = low_gaps[i * c.stride];
                high_copy[static_cast<std::size_t>(i)] = high_gaps[i * c.stride];
            }
            low_gaps = low_copy.data();
            high_gaps = high_copy.data();
        }
        const int count = detail::candidates(spans, base_, low_gaps, high_gaps, c.row.count, rays);
        for (int n = 0; n < count; ++n) {
            const int i = rays[static_cast<std::size_t>(n)], local = c.local + i * c.stride;
            const auto at = static_cast<std::size_t>(i);
            const double low = base_ + spans.low[at], high = base_ + spans.high[at];
            const int met = place_.tile.first_met(local, low, high);
            if (met < 0) continue;
            Removed removed;
            if (job_.cuts)
                place_.tile.subtract(local, met, low, high, job_.cut, removed);
            else
                place_.tile.measure(local, low, high, removed);
            tally_.touched = true;
            if (measured_) note(c.row.p + i * c.row.step, local, removed);
            if (job_.cuts) continue;
            place_.tile.each_met(local, low, high, [&](double from, double to) { note_depth(local, from, to); });
            if (measured_) note_stack(c.row.p + i * c.row.step, local, removed);
        }
    }

    /// The ray's point whose own coordinate is 0.
    [[nodiscard]] Vec3 node(int local) const {
        return place_.node + (local % Tile::edge) * place_.step_a + (local / Tile::edge) * place_.step_b;
    }

    /// `p`: the ray in the tool's frame.
    void note(Vec3 p, int local, const Removed& removed) {
        tally_.length += removed.length;
        const double along = d_.z, across = along == 1 ? 0 : dot(node(local), job_.frame.z);
        const double one = across + along * removed.lowest, other = across + along * removed.highest;
        tally_.lowest = std::min({tally_.lowest, one, other});
        tally_.highest = std::max({tally_.highest, one, other});
        if (aims_.lie == Lie::skew) p = p + ((removed.lowest + removed.highest) / 2 - base_) * d_;
        const double left = left_of_way({p.x, p.y});
        tally_.rightmost = std::min(tally_.rightmost, left);
        tally_.leftmost = std::max(tally_.leftmost, left);
    }

    [[nodiscard]] double left_of_way(Vec2 p) const {
        if (job_.track.circular) return offset_from(job_.track, p).left;
        if (job_.heading == Vec2{}) return std::sqrt(p.x * p.x + p.y * p.y);
        return cross(job_.heading, p);
    }

    /// Of a piece of material on the ray: between two pieces there is none that could be deep.
    void note_depth(int local, double from, double to) {
        for (const double at : {from, (from + to) / 2, to}) {
            Vec3 p = node(local);
            set_component(p, place_.axis, at);
            const Foot foot = foot_on(*job_.shape, job_.track, job_.frame.to_tool(p - job_.from));
            if (-foot.outside <= tally_.depth) continue;
            tally_.depth = -foot.outside;
            tally_.deepest = p;
        }
    }

    /// `p`: the ray in the tool's frame. Rays stand beside the axis, so a point reaches lower than they say.
    void note_stack(Vec3 p, int local, const Removed& found) {
        const double along = d_.z, across = along == 1 ? 0 : dot(node(local), job_.frame.z);
        const double one = across + along * found.lowest, other = across + along * found.highest;
        if (aims_.lie == Lie::skew) p = p + ((found.lowest + found.highest) / 2 - base_) * d_;
        const double off = offset_from(job_.track, {p.x, p.y}).distance;
        if (!(off <= rim * job_.shape->radius)) return;
        const Vec2 lower = job_.track.v.z < 0 ? Vec2{job_.track.v.x, job_.track.v.y} : Vec2{};
        const double beside = job_.track.level() ? off : geom::distance({p.x, p.y}, lower);
        const bool nearest = beside <= 0.51 * length(place_.step_a + place_.step_b);
        const double tip = dot(job_.from, job_.frame.z) + std::min(0.0, job_.track.v.z) + job_.shape->bottom;
        const double least = std::min(one, other), room = 2 * length(place_.step_a + place_.step_b);
        const double low = nearest && least - tip < room ? std::min(least, tip) : least;
        Vec3 foot = node(local);
        set_component(foot, place_.axis, one < other ? found.lowest : found.highest);
        const double high = std::max(one, other);
        tally_.stacks.seen.take({high - least, off, foot});
        tally_.stacks.to_tip.take({high - low, off, foot + (low - least) * job_.frame.z});
    }

    static constexpr double rim = 0.9;  ///< of the radius: what lies farther out may be a wall along which it rubs

    const TilePlace& place_;
    const Job& job_;
    Tally& tally_;
    const Aims& aims_;
    bool measured_ = false;
    double base_ = 0;  ///< coordinate on the rays where s is 0
    Vec3 d_;           ///< the rays' direction and, in the tool's frame, ray (0, 0) and the ways to the next
    Vec3 start_, step_a_, step_b_;
};

}  // namespace

void cut_tile(Tile& tile, const Lattice& lattice, int axis, int ta, int tb, std::span<const Job> jobs,
              std::span<const std::uint32_t> order, std::span<Tally> tallies) {
    const TilePlace place = place_of(tile, lattice, axis, ta, tb);
    for (std::size_t i = 0; i < order.size(); ++i) {
        const Job& job = jobs[order[i]];
        if (component(job.box.min, axis) >= place.highest || component(job.box.max, axis) <= place.lowest) continue;
        const Window w = window_of(place, job);
        if (w.a0 < w.a1 && w.b0 < w.b1) Worker(place, job, tallies[i]).run(w);
    }
}

}  // namespace obrys::sim::milling
