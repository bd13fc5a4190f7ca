#include "sim/milling/crossings.hpp"

#include <algorithm>
#include <atomic>
#include <bit>
#include <cmath>
#include <functional>
#include <limits>

#include "base/parallel.hpp"

namespace obrys::sim::milling {

namespace {

using geom::Vec3;
/// An edge of the lattice: its nodes lie at `low` and `high` on its ray, material begins between them (`rising`) or
/// ends.
struct Edge {
    double low, high;
    bool rising;
};

/// An end of material on a ray; `found` false: there is none.
struct Found {
    double at = 0;
    std::uint32_t cut = 0;
    bool found = false;
    Vec3 through;  ///< a point of the ray or line
};

/// Ends so far beyond an edge's nodes belong to it, in its lengths: of a face nearly along the ray a rounding error
/// moves them far.
constexpr double beyond_edge = 0.05;

/// The one nearest to an edge's middle.
Found nearest_end(std::span<const Interval> ray, const Edge& e) {
    const double length = e.high - e.low, low = e.low - beyond_edge * length, high = e.high + beyond_edge * length;
    const double middle = 0.5 * (e.low + e.high);
    auto m = std::partition_point(ray.begin(), ray.end(), [&](const Interval& x) { return x.end < low; });
    Found best;
    double best_distance = high - middle;
    for (; m != ray.end() && m->begin <= high; ++m) {
        const double at = e.rising ? m->begin : m->end, d = std::abs(at - middle);
        if (!(d <= best_distance)) continue;
        best_distance = d;
        best = {at, e.rising ? m->begin_cut : m->end_cut, true, {}};
    }
    return best;
}

bool is_material(std::span<const Interval> ray, double at) {
    return std::any_of(ray.begin(), ray.end(), [&](const Interval& m) { return m.begin <= at && at <= m.end; });
}

/// Where nothing else is known: the surface goes through the node on which rays do not agree.
double doubtful_node(std::span<const Interval> ray, const Edge& e) {
    const bool low = is_material(ray, e.low), high = is_material(ray, e.high);
    if (low != high) return 0.5 * (e.low + e.high);
    return low == e.rising ? e.low : e.high;
}

constexpr double beside_slack = 1e-6;  ///< mm

/// The end on a line beside the edge on which it has one.
Found end_beside(Vec3 node, int axis, const Edge& e, const Line& line) {
    constexpr std::array<std::array<int, 2>, 8> ways{
        {{1, 0}, {-1, 0}, {0, 1}, {0, -1}, {1, 1}, {1, -1}, {-1, 1}, {-1, -1}}};
    if (!line) return {};
    const int u = first_across(axis), v = second_across(axis);
    for (const auto& way : ways) {
        Vec3 p = node;
        set_component(p, u, component(p, u) + way[0] * beside_slack);
        set_component(p, v, component(p, v) + way[1] * beside_slack);
        const std::vector<Interval> beside = line(axis, p, e.low, e.high);
        Found f = nearest_end(beside, e);
        f.through = p;
        if (f.found) return f;
    }
    return {};
}

Crossing crossing_of(std::span<const Interval> ray, const Edge& e, Vec3 node, int axis, Normal normal, const Line& line,
                     bool& found) {
    Found f = nearest_end(ray, e);
    f.through = node;
    if (!f.found) f = end_beside(node, axis, e, line);
    found = f.found;
    Crossing c;
    c.at = f.found ? f.at : doubtful_node(ray, e);
    c.cut = f.cut;
    if (!f.found) return c;
    Vec3 p = f.through;
    set_component(p, axis, c.at);
    const Vec3 n = normal(f.cut, p, axis, e.rising ? -1.0 : 1.0);
    if (is_finite(n)) c.normal = {static_cast<float>(n.x), static_cast<float>(n.y), static_cast<float>(n.z)};
    return c;
}

/// Pairs of ends of one ray between the same two nodes.
std::size_t thin_on(std::span<const Interval> ray, double origin, double step) {
    std::size_t pairs = 0, here = 0;
    double last = std::numeric_limits<double>::quiet_NaN();
    for (const Interval& m : ray)
        for (const double end : {m.begin, m.end}) {
            const double edge = std::floor((end - origin) / step);
            if (edge != last) pairs += here / 2, here = 0;
            last = edge;
            ++here;
        }
    return pairs + here / 2;
}

}  // namespace

std::uint32_t Ranks::at(std::size_t row, std::size_t w, std::uint64_t mask, unsigned bit) const {
    const std::uint64_t lower = mask & ((std::uint64_t{1} << bit) - 1);
    return before_[row * words_ + w] + static_cast<std::uint32_t>(std::popcount(lower));
}

Crossings::Crossings(const Lattice& lattice, const NodeBits& nodes, Rays rays, Normal normal, const Line& line)
    : nodes_(nodes) {
    count();
    fill(lattice, rays, normal, line);
}

void Crossings::count() {
    for (std::size_t a = 0; a < 3; ++a) {
        ranks_[a].reserve(nodes_.rows(), nodes_.words());
        row_first_[a].assign(nodes_.rows() + 1, 0);
    }
    base::in_pieces(nodes_.rows(), 64, [&](const base::Piece& some) {
        for (std::size_t row = some.begin(); row < some.end(); ++row)
            for (std::size_t a = 0; a < 3; ++a) {
                std::uint32_t in_row = 0;
                for (std::size_t w = 0; w < nodes_.words(); ++w) {
                    ranks_[a].of(row, w) = in_row;
                    in_row += static_cast<std::uint32_t>(std::popcount(nodes_.crossed(static_cast<int>(a), row, w)));
                }
                row_first_[a][row + 1] = in_row;
            }
    });
    for (std::size_t a = 0; a < 3; ++a) {
        for (std::size_t row = 0; row < nodes_.rows(); ++row) row_first_[a][row + 1] += row_first_[a][row];
        all_[a].resize(row_first_[a].back());
    }
}

void Crossings::fill(const Lattice& lattice, Rays rays, Normal normal, const Line& line) {
    std::atomic<std::size_t> unmatched = 0;
    const auto fill_row = [&](std::size_t row, int axis) {
        const auto a = static_cast<std::size_t>(axis);
        const int j = nodes_.j(row), k = nodes_.k(row);
        std::uint32_t number = row_first_[a][row];
        if (number == row_first_[a][row + 1]) return;
        const std::array<int, 3> further{axis == 0 ? 1 : 0, axis == 1 ? 1 : 0, axis == 2 ? 1 : 0};
        for (std::size_t w = 0; w < nodes_.words(); ++w)
            for (std::uint64_t mask = nodes_.crossed(axis, row, w); mask != 0; mask &= mask - 1) {
                const int i = static_cast<int>(64 * w) + std::countr_zero(mask);
                const Vec3 low = lattice.node(i, j, k),
                           high = lattice.node(i + further[0], j + further[1], k + further[2]);
                const Edge e{component(low, axis), component(high, axis), !nodes_.material(i, j, k)};
                const auto ray = rays(axis, axis == 0 ? j : i, axis == 2 ? j : k);
                bool found = false;
                all_[a][number++] = crossing_of(ray, e, low, axis, normal, line, found);
                if (!found) unmatched.fetch_add(1, std::memory_order_relaxed);
            }
    };
    base::in_pieces(nodes_.rows(), 16, [&](const base::Piece& some) {
        for (std::size_t row = some.begin(); row < some.end(); ++row)
            for (int axis = 0; axis < 3; ++axis) fill_row(row, axis);
    });
    unmatched_ = unmatched;
}

std::uint32_t Crossings::number(int axis, int i, int j, int k) const {
    const std::size_t row = nodes_.row(j, k), w = static_cast<std::size_t>(i) / 64;
    const auto a = static_cast<std::size_t>(axis);
    return row_first_[a][row] + ranks_[a].at(row, w, nodes_.crossed(axis, row, w), static_cast<unsigned>(i) % 64);
}

std::size_t count_thin(const Lattice& lattice, Rays rays) {
    std::size_t all = 0;
    for (int axis = 0; axis < 3; ++axis) {
        const auto size = [&](int other) { return lattice.count[static_cast<std::size_t>(other)]; };
        const int across = size(first_across(axis)), down = size(second_across(axis));
        const double origin = component(lattice.origin, axis), step = component(lattice.step, axis);
        std::vector<std::size_t> rows(static_cast<std::size_t>(down));
        base::in_pieces(rows.size(), 8, [&](const base::Piece& some) {
            for (std::size_t b = some.begin(); b < some.end(); ++b)
                for (int a = 0; a < across; ++a) rows[b] += thin_on(rays(axis, a, static_cast<int>(b)), origin, step);
        });
        for (const std::size_t thin : rows) all += thin;
    }
    return all;
}

}  // namespace obrys::sim::milling
