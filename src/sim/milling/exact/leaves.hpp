#pragma once
/// Cells of a lattice, some of them halved along all three axes again and again: an octree in each cell of the lattice.

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "base/function_ref.hpp"
#include "sim/milling/exact/key_map.hpp"
#include "sim/milling/lattice.hpp"

namespace obrys::sim::milling {

/// A node, or a smallest cell by its lowest node: counted in smallest cells along each axis from the lattice's origin.
using Place = std::array<std::int32_t, 3>;

/// 21 bits an axis; `kind` less than 2.
[[nodiscard]] constexpr std::uint64_t key_of(const Place& p, std::uint64_t kind = 0) {
    return static_cast<std::uint64_t>(p[0]) | static_cast<std::uint64_t>(p[1]) << 21U |
           static_cast<std::uint64_t>(p[2]) << 42U | kind << 63U;
}

/// One number of points, the same where these are the same to the last digit.
[[nodiscard]] std::uint64_t mixed_of(std::span<const geom::Vec3> points, std::uint64_t with);

/// The cell of a lattice that a point lies in.
[[nodiscard]] std::optional<Place> cell_at(const Lattice& lattice, geom::Vec3 p);

/// A cell that is not divided further.
struct Leaf {
    Place at{};             ///< its lowest node
    std::int32_t size = 0;  ///< of its edges
    bool operator==(const Leaf&) const = default;
};

/// A part of an edge of cells that belongs to no shorter one.
struct ShortEdge {
    Place at{};
    std::int32_t size = 0;
    int axis = 0;
};

class Leaves {
public:
    /// So many times the cells may be halved; less where the lattice has too many cells for the keys.
    Leaves(const Lattice& lattice, int levels);

    [[nodiscard]] std::int32_t unit() const { return unit_; }  ///< size of the lattice's own cells
    [[nodiscard]] geom::Vec3 node(const Place& p) const;
    [[nodiscard]] Place cell_of(const Place& p) const;  ///< the lattice's own cell, in its own count
    /// The leaf that a smallest cell lies in.
    [[nodiscard]] Leaf leaf_at(const Place& p) const;
    /// Of leaves that can be halved; `round` counts from 1.
    void split(const Leaf& leaf, std::uint32_t round);
    /// The leaf came about in that round.
    [[nodiscard]] bool is_of(const Leaf& leaf, std::uint32_t round) const;
    [[nodiscard]] bool is_split(const Place& at, std::int32_t size) const;
    /// The lattice's own cells that are split, in the order in which they were.
    [[nodiscard]] const std::vector<Place>& split_cells() const { return split_cells_; }
    /// The lattice's own cells that are not split and share an edge with one that is: ascending.
    [[nodiscard]] std::vector<Place> cells_beside() const;
    void each_leaf(const Place& cell, base::FunctionRef<void(const Leaf&)> take) const;

    /// The leaves about an edge, counter-clockwise seen against the axis where that is x or z.
    [[nodiscard]] std::array<Leaf, 4> around(const Place& at, int axis) const;
    static constexpr std::array<std::array<int, 2>, 4> quadrants{{{1, 1}, {0, 1}, {0, 0}, {1, 0}}};
    /// The short edges of which a stretch consists, upwards.
    void pieces(const Place& at, std::int32_t size, int axis, std::vector<ShortEdge>& out) const;
    [[nodiscard]] bool is_short(const Place& at, std::int32_t size, int axis) const;

private:
    [[nodiscard]] int level_of(std::int32_t size) const;

    Lattice lattice_;
    int levels_ = 0;
    std::int32_t unit_ = 1;
    std::vector<KeyMap> split_;  ///< the round, by level
    std::vector<Place> split_cells_;
};

}  // namespace obrys::sim::milling
