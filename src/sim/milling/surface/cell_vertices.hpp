#pragma once
/// The vertices of a surface, cell by cell.

#include <vector>

#include "sim/milling/crossings.hpp"
#include "sim/milling/surface/sheets.hpp"

namespace obrys::sim::milling {

class CellVertices {
public:
    /// `tolerance` 0: it is not asked what is rough.
    CellVertices(const Lattice& lattice, const NodeBits& nodes, const Crossings& crossings, double tolerance = 0);

    /// The vertex of the piece of surface that crosses an edge (`cell_edge`) of cell (i, j, k).
    [[nodiscard]] std::uint32_t vertex(int i, int j, int k, int edge) const;
    /// The surface in the vertex's cell is not known to be flat within the tolerance.
    [[nodiscard]] bool is_rough(std::uint32_t vertex) const { return !rough_.empty() && rough_[vertex] != 0; }
    [[nodiscard]] std::vector<geom::Vec3> take() { return std::move(vertices_); }

private:
    struct Cell {
        std::uint32_t first = 0;   ///< of its vertices
        std::uint8_t corners = 0;  ///< as of NodeBits::corners
        bool joined = false;       ///< as of `sheets`
    };
    [[nodiscard]] Cell describe(int i, int j, int k) const;
    void find_cells();
    void place(const Lattice& lattice, const Crossings& crossings, double tolerance);

    const NodeBits& nodes_;
    Ranks ranks_;
    std::vector<std::uint32_t> row_first_;
    std::vector<Cell> cells_;
    std::vector<geom::Vec3> vertices_;
    std::vector<std::uint8_t> rough_;
};

}  // namespace obrys::sim::milling
