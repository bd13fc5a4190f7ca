// One job after the other on the rays of a tile.

#include <algorithm>
#include <cmath>

#include "sim/milling/job.hpp"
#include "sim/milling/nearest.hpp"
#include "sim/milling/rows.hpp"

namespace obrys::sim::milling {
namespace {

using geom::Vec2;
using geom::Vec3;

constexpr double nothing = -std::numeric_limits<double>::infinity();

/// A tile and where its rays lie.
struct Place {
    Tile& tile;
    int axis = 2;
    int count_a = 0, count_b = 0;          ///< rays of this tile that the lattice has
    Vec3 node, step_a, step_b;             ///< ray (0, 0) where its own coordinate is 0, and the ways to the next rays
    double lowest = 0, highest = nothing;  ///< of the material
};

struct Window {
    int a0 = 0, a1 = 0, b0 = 0, b1 = 0;  ///< first, and one past the last
};

Place place_of(Tile& tile, const Lattice& l, int axis, int ta, int tb) {
    const int first = first_across(axis), second = second_across(axis);
    Place p{tile, axis, 0, 0, {}, {}, {}};
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
Window window_of(const Place& p, const Job& job) {
    const auto range = [&](int across, Vec3 step, int count) {
        const double at = component(p.node, across), s = component(step, across);
        const double low = std::ceil((component(job.box.min, across) - at) / s);
        const double high = std::floor((component(job.box.max, across) - at) / s);
        return std::pair{static_cast<int>(std::clamp(low, 0.0, static_cast<double>(count))),
                         static_cast<int>(std::clamp(high, -1.0, static_cast<double>(count - 1))) + 1};
    };
    const auto [a0, a1] = range(first_across(p.axis), p.step_a, p.count_a);
    const auto [b0, b1] = range(second_across(p.axis), p.step_b, p.count_b);
    return {a0, a1, b0, b1};
}

/// A row of rays with the places they have in the tile.
struct Course {
    Row row;
    int local = 0, stride = 1;
    Vec3 node;  ///< of the first ray, own coordinate 0
    Vec3 step;
    double base = 0;  ///< coordinate on the rays where s is 0
};

class Worker {
public:
    Worker(Place& place, const Job& job, Tally& tally)
        : place_(place),
          job_(job),
          tally_(tally),
          aims_(job.aims[static_cast<std::size_t>(place.axis)]),
          measured_(place.axis == job.main) {
        lie_ = aims_.lie;
        set_component(unit_, place.axis, 1);
        base_ = component(job.from, place.axis);
        d_ = job.frame.to_tool(unit_);
    }

    void run() {
        if (component(job_.box.min, place_.axis) >= place_.highest ||
            component(job_.box.max, place_.axis) <= place_.lowest)
            return;
        const Window w = window_of(place_, job_);
        if (w.a0 >= w.a1 || w.b0 >= w.b1) return;
        if (lie_ == Lie::along && d_.z > 0 && job_.shape->rising &&
            place_.highest <= base_ + job_.shape->top + std::min(0.0, job_.track.v.z)) {
            from_above(w);
            return;
        }
        // Rows of rays across the tool must be of one height.
        const bool along_b = lie_ == Lie::across && job_.frame.along == first_across(place_.axis);
        const int rows = along_b ? w.a1 - w.a0 : w.b1 - w.b0;
        for (int i = 0; i < rows; ++i) {
            const Course c =
                along_b ? course(w.a0 + i, w.b0, w.b1 - w.b0, true) : course(w.a0, w.b0 + i, w.a1 - w.a0, false);
            cut_row(*job_.shape, job_.track, c.row, aims_, [&](const Spans& spans) { apply(c, spans); });
        }
    }

private:
    [[nodiscard]] Course course(int a, int b, int count, bool along_b) const {
        Course c;
        c.local = b * Tile::edge + a;
        c.stride = along_b ? Tile::edge : 1;
        c.node = place_.node + a * place_.step_a + b * place_.step_b;
        c.step = along_b ? place_.step_b : place_.step_a;
        c.base = base_;
        Vec3 start = c.node - job_.from;
        set_component(start, place_.axis, 0);
        c.row = {job_.frame.to_tool(start), job_.frame.to_tool(c.step), d_, count};
        if (lie_ == Lie::skew) {
            // p must be normal to d in the tool's frame as well, where rounding may have moved it.
            c.row.p = c.row.p - dot(c.row.p, d_) * d_;
            c.row.step = c.row.step - dot(c.row.step, d_) * d_;
        }
        return c;
    }

    /// Rays along the axis under a tool that rises: only rows that hold material above the tool's lower side.
    void from_above(const Window& w) {
        const Vec3 end = job_.from + job_.way;
        const double down = std::min(0.0, job_.track.v.z),
                     shift = component(job_.box.max, 0) - std::max(job_.from.x, end.x);
        Spans spans;
        for (int b = w.b0; b < w.b1; ++b) {
            const Course c = course(w.a0, b, w.a1 - w.a0, false);
            const double* upper = place_.tile.uppers() + c.local;
            double highest = nothing;
            for (int i = 0; i < c.row.count; ++i) highest = upper[i] > highest ? upper[i] : highest;
            if (highest <= base_ + down + job_.shape->bottom + thinnest) continue;
            const double room = nearest_of_row(c, shift);
            if (highest <= base_ + down + lower_side(*job_.shape, room) + thinnest) continue;
            cut_row_from_above(*job_.shape, job_.track, c.row, aims_, spans);
            apply(c, spans);
        }
    }

    /// No ray of the row is nearer to the track than this.
    [[nodiscard]] double nearest_of_row(const Course& c, double) const {
        if (job_.track.circular) return 0;
        const int first = first_across(place_.axis), second = second_across(place_.axis);
        const auto gap = [&](int across, double low, double high) {
            const double a = component(job_.from, across), b = a + component(job_.way, across);
            return std::max({0.0, low - std::max(a, b), std::min(a, b) - high});
        };
        const double u = component(c.node, first), last = u + (c.row.count - 1) * component(c.step, first);
        const double v = component(c.node, second);
        const double du = gap(first, u, last), dv = gap(second, v, v);
        return std::sqrt(du * du + dv * dv);
    }

    void apply(const Course& c, const Spans& spans) {
        for (int i = 0; i < c.row.count; ++i) {
            const auto at = static_cast<std::size_t>(i);
            const double low = c.base + spans.low[at], high = c.base + spans.high[at];
            const int local = c.local + i * c.stride;
            if (!(spans.low[at] < spans.high[at]) || place_.tile.upper(local) <= low + thinnest) continue;
            Removed removed;
            if (job_.cuts)
                place_.tile.subtract(local, low, high, job_.cut, removed);
            else
                place_.tile.measure(local, low, high, removed);
            if (removed.length > 0) note(c, i, removed);
        }
    }

    void note(const Course& c, int i, const Removed& removed) {
        tally_.touched = true;
        if (!job_.cuts) note_depth(c.node + i * c.step, removed);
        if (!measured_) return;
        tally_.length += removed.length;
        const double across = dot(c.node + i * c.step, job_.frame.z), along = component(job_.frame.z, place_.axis);
        const double one = across + along * removed.lowest, other = across + along * removed.highest;
        tally_.lowest = std::min({tally_.lowest, one, other});
        tally_.highest = std::max({tally_.highest, one, other});
        const Vec3 p = c.row.p + i * c.row.step + ((removed.lowest + removed.highest) / 2 - c.base) * d_;
        const double left = left_of_way({p.x, p.y});
        tally_.rightmost = std::min(tally_.rightmost, left);
        tally_.leftmost = std::max(tally_.leftmost, left);
    }

    [[nodiscard]] double left_of_way(Vec2 p) const {
        if (job_.track.circular) return offset_from(job_.track, p).left;
        if (job_.heading == Vec2{}) return std::sqrt(p.x * p.x + p.y * p.y);
        return cross(job_.heading, p);
    }

    void note_depth(Vec3 node, const Removed& found) {
        for (const double at : {found.lowest, (found.lowest + found.highest) / 2, found.highest}) {
            Vec3 p = node;
            set_component(p, place_.axis, at);
            const Foot foot = foot_on(*job_.shape, job_.track, job_.frame.to_tool(p - job_.from));
            if (-foot.outside <= tally_.depth) continue;
            tally_.depth = -foot.outside;
            tally_.deepest = p;
        }
    }

    Place& place_;
    const Job& job_;
    Tally& tally_;
    const Aims& aims_;
    bool measured_ = false;
    Lie lie_ = Lie::along;
    Vec3 unit_, d_;
    double base_ = 0;
};

}  // namespace

void cut_tile(Tile& tile, const Lattice& lattice, int axis, int ta, int tb, std::span<const Job> jobs,
              std::span<const std::uint32_t> order, std::span<Tally> tallies) {
    Place place = place_of(tile, lattice, axis, ta, tb);
    for (std::size_t i = 0; i < order.size(); ++i) Worker(place, jobs[order[i]], tallies[i]).run();
}

}  // namespace obrys::sim::milling
