#pragma once
/// The vertices of a surface, cell by cell.

#include <vector>

#include "sim/milling/crossings.hpp"
#include "sim/milling/sheets.hpp"

namespace obrys::sim::milling {

class CellVertices {
public:
    CellVertices(const Lattice& lattice, const NodeBits& nodes, const Crossings& crossings);

    /// The vertex of the piece of surface that crosses an edge (`cell_edge`) of cell (i, j, k).
    [[nodiscard]] std::uint32_t vertex(int i, int j, int k, int edge) const;
    [[nodiscard]] std::vector<geom::Vec3> take() { return std::move(vertices_); }

private:
    struct Cell {
        std::uint32_t first = 0;   ///< of its vertices
        std::uint8_t corners = 0;  ///< as of NodeBits::corners
        bool joined = false;       ///< as of `sheets`
    };
    [[nodiscard]] Cell describe(int i, int j, int k) const;
    void find_cells();
    void place(const Lattice& lattice, const Crossings& crossings);

    const NodeBits& nodes_;
    Ranks ranks_;
    std::vector<std::uint32_t> row_first_;
    std::vector<Cell> cells_;
    std::vector<geom::Vec3> vertices_;
};

}  // namespace obrys::sim::milling
