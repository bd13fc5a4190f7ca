#include "sim/milling/lattice.hpp"

#include <algorithm>
#include <cmath>

#include "base/whole.hpp"
#include "sim/milling/dexel.hpp"

namespace obrys::sim::milling {
namespace {

constexpr int most_nodes = 1 << 20;
/// Lengths in programs, stocks and parts are multiples of a millionth: six decimals of mm, five of inches. Nodes lie
/// half of that beside them, so that a plane face does not lie on a ray, where rounding would say on which side.
constexpr double per_mm = 1e6;
constexpr double finest_on_grid = 1e-3;  ///< mm; a finer step is not put on the grid

/// Nodes along one axis: about half a step outside the box at both ends.
struct Spread {
    double origin = 0, step = 0, cells = 0;
};

Spread spread_over(double low, double size, double step) {
    const double cells = std::max(1.0, std::ceil(size / step - 1e-9));
    Spread s{0, size / cells, cells};
    if (s.step < finest_on_grid) return {low - s.step / 2, s.step, s.cells};
    s.step = std::floor(s.step * per_mm) / per_mm;
    const auto margin = [&] { return ((s.cells + 1) * s.step - size) / 2; };
    while (margin() < s.step / 4) ++s.cells;
    s.origin = (std::floor((low - margin()) * per_mm) + 0.5) / per_mm;
    return s;
}

}  // namespace

std::optional<Lattice> make_lattice(const Box3& box, double step) {
    Lattice lattice;
    if (!(step > 0) || !std::isfinite(step)) return std::nullopt;
    for (int axis = 0; axis < 3; ++axis) {
        const double low = component(box.min, axis), size = component(box.max, axis) - low;
        if (!(size > 0) || !std::isfinite(low) || !std::isfinite(size)) return std::nullopt;
        if (!(size / step + 3 < most_nodes)) return std::nullopt;
        const Spread s = spread_over(low, size, step);
        if (s.cells + 2 > most_nodes) return std::nullopt;
        set_component(lattice.step, axis, s.step);
        set_component(lattice.origin, axis, s.origin);
        lattice.count[static_cast<std::size_t>(axis)] = base::clipped<int>(s.cells, 0, most_nodes) + 2;
    }
    return lattice;
}

double step_for(double tolerance, double smallest_radius) {
    if (!(tolerance > 0) || !(smallest_radius > 0)) return 0;
    return std::sqrt(2 * smallest_radius * tolerance);
}

bool matters(double radius, double tolerance) { return radius * (std::sqrt(2.0) - 1) > tolerance; }

double bytes_for(const Lattice& lattice, double pieces) {
    double rays = 0;
    for (int axis = 0; axis < 3; ++axis) {
        const auto in_tiles = [&](int across) {
            const int count = lattice.count[static_cast<std::size_t>(across)];
            return std::ceil(static_cast<double>(count) / Tile::edge) * Tile::edge;
        };
        rays += in_tiles(first_across(axis)) * in_tiles(second_across(axis));
    }
    // Room for growth: a ray's place doubles, and what it leaves is given back when half of a tile's pool is unused.
    constexpr double spare = 2;
    return rays * (spare * pieces * sizeof(Interval) + static_cast<double>(sizeof(Tile)) / Tile::rays);
}

double tolerance_that_fits(const Box3& box, double smallest_radius, double bytes) {
    const double size = std::max({box.max.x - box.min.x, box.max.y - box.min.y, box.max.z - box.min.z});
    const auto coarsest = make_lattice(box, size);
    if (!coarsest || !(bytes_for(*coarsest) <= bytes)) return std::nan("");
    if (!(size > 0) || !(bytes > 0) || !(smallest_radius > 0)) return std::nan("");
    double low = size / most_nodes, high = size;  // of the step
    for (int i = 0; i < 60; ++i) {
        const double middle = std::sqrt(low * high);
        const auto lattice = make_lattice(box, middle);
        (lattice && bytes_for(*lattice) <= bytes ? high : low) = middle;
    }
    return high * high / (2 * smallest_radius);
}

Resolution resolve(const Box3& box, double tolerance, double smallest_radius, double most_bytes) {
    Resolution r;
    r.step = step_for(tolerance, smallest_radius);
    r.lattice = make_lattice(box, r.step);
    r.bytes = r.lattice ? bytes_for(*r.lattice) : std::nan("");
    if (r.lattice && r.bytes <= most_bytes) return r;
    r.lattice.reset();
    r.fits = tolerance_that_fits(box, smallest_radius, most_bytes);
    return r;
}

}  // namespace obrys::sim::milling
