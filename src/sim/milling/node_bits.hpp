#pragma once
/// Which nodes of a lattice are material, one bit each, and what follows from it for edges and cells. The rays along z
/// decide; the lattice's outermost nodes always count as air, so that the surface is closed.

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "base/function_ref.hpp"
#include "sim/milling/dexel.hpp"
#include "sim/milling/lattice.hpp"

namespace obrys::sim::milling {

/// Material on ray (axis, a, b), ascending, as `Dexels::ray`. Called from several threads at once.
using Rays = base::FunctionRef<std::span<const Interval>(int axis, int a, int b)>;

class NodeBits {
public:
    NodeBits(const Lattice& lattice, Rays rays);

    /// A row holds the nodes (0, j, k), (1, j, k) …, 64 a word, the lowest bit first.
    [[nodiscard]] std::size_t rows() const { return rows_; }
    [[nodiscard]] std::size_t words() const { return words_; }
    [[nodiscard]] std::size_t row(int j, int k) const {
        return static_cast<std::size_t>(k) * static_cast<std::size_t>(count_[1]) + static_cast<std::size_t>(j);
    }
    [[nodiscard]] int j(std::size_t row) const { return static_cast<int>(row % static_cast<std::size_t>(count_[1])); }
    [[nodiscard]] int k(std::size_t row) const { return static_cast<int>(row / static_cast<std::size_t>(count_[1])); }

    [[nodiscard]] bool material(int i, int j, int k) const {
        return (bits_[row(j, k) * words_ + static_cast<std::size_t>(i) / 64] >> (static_cast<unsigned>(i) % 64) & 1U) !=
               0;
    }
    /// Edges that run from the nodes of word `w` along `axis` and have one end in material.
    [[nodiscard]] std::uint64_t crossed(int axis, std::size_t row, std::size_t w) const;
    /// Cells whose lowest node is in word `w` and whose nodes differ.
    [[nodiscard]] std::uint64_t mixed(std::size_t row, std::size_t w) const;
    /// The nodes of cell (i, j, k): bit 1 stands for the next node in x, 2 in y, 4 in z.
    [[nodiscard]] unsigned corners(int i, int j, int k) const;

private:
    [[nodiscard]] std::uint64_t at(std::size_t row, std::size_t w) const {
        return w < words_ ? bits_[row * words_ + w] : 0;
    }
    void set_rows_of(int j, const Lattice& lattice, Rays rays);

    std::array<int, 3> count_;
    std::size_t words_, rows_;
    std::vector<std::uint64_t> bits_;
};

}  // namespace obrys::sim::milling
