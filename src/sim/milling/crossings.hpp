#pragma once
/// Where the surface crosses the edges of a lattice, in the order of rows and nodes, found again by node and axis.

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

#include "sim/milling/node_bits.hpp"

namespace obrys::sim::milling {

/// Direction away from the material, unit length, at a place of the surface made by a cut. `axis`: that of the ray on
/// which the place lies; `sign`: -1 where the ray enters material, 1 where it leaves it. A zero or NaN stands for not
/// known. Called from several threads at once.
using Normal = base::FunctionRef<geom::Vec3(std::uint32_t cut, geom::Vec3 at, int axis, double sign)>;

/// Material on the line along `axis` through a point that lies on no ray, between two of its coordinates; called from
/// several threads at once. Empty function: not to be had.
using Line = std::function<std::vector<Interval>(int axis, geom::Vec3 through, double low, double high)>;

struct Crossing {
    double at = 0;                  ///< on its axis; by rounding it may lie beside its edge
    std::array<float, 3> normal{};  ///< zero where not known
    std::uint32_t cut = 0;
};

/// The words of all rows, and in each how many of some things come before it.
class Ranks {
public:
    void reserve(std::size_t rows, std::size_t words) { words_ = words, before_.assign(rows * words, 0); }
    [[nodiscard]] std::uint32_t& of(std::size_t row, std::size_t w) { return before_[row * words_ + w]; }
    /// The number of the thing at bit `bit` of `mask`, which is the word (row, w).
    [[nodiscard]] std::uint32_t at(std::size_t row, std::size_t w, std::uint64_t mask, unsigned bit) const;

private:
    std::size_t words_ = 0;
    std::vector<std::uint32_t> before_;
};

class Crossings {
public:
    /// Where a node lies on a face but for rounding, rays of different directions may not agree on which side it is,
    /// and a ray in the face sees all of it or nothing. The rays along z decide; what such a ray does not know is taken
    /// from `line`, a nanometre beside it on the side that they decided for.
    Crossings(const Lattice& lattice, const NodeBits& nodes, Rays rays, Normal normal, const Line& line);

    /// All edges along an axis, ordered by row, then by i.
    [[nodiscard]] const std::vector<Crossing>& along(int axis) const { return all_[static_cast<std::size_t>(axis)]; }
    /// The number in `along(axis)` of the edge that starts at node (i, j, k); its ends must differ.
    [[nodiscard]] std::uint32_t number(int axis, int i, int j, int k) const;
    /// The number of the first edge of a row along an axis.
    [[nodiscard]] std::uint32_t first(int axis, std::size_t row) const {
        return row_first_[static_cast<std::size_t>(axis)][row];
    }
    /// Edges whose ends differ though the ray along them has no end near: rays that contradict each other.
    [[nodiscard]] std::size_t unmatched() const { return unmatched_; }

private:
    void count();
    void fill(const Lattice& lattice, Rays rays, Normal normal, const Line& line);

    const NodeBits& nodes_;
    std::array<Ranks, 3> ranks_;
    std::array<std::vector<std::uint32_t>, 3> row_first_;
    std::array<std::vector<Crossing>, 3> all_;
    std::size_t unmatched_ = 0;
};

/// Pairs of ray ends that lie between the same two nodes: walls or gaps thinner than a step, which the surface leaves
/// out.
[[nodiscard]] std::size_t count_thin(const Lattice& lattice, Rays rays);

}  // namespace obrys::sim::milling
