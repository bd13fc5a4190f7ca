#pragma once
/// Triangles with their neighbours, so that one can walk around a vertex and draw edges together.
/// Corner 3 t + c is corner c of triangle t. Source: Rossignac, Safonova, Szymczak: "3D Compression Made Simple:
/// Edgebreaker on a Corner Table" (2001).

#include <cstdint>
#include <vector>

#include "mesh/mesh.hpp"

namespace obrys::mesh {

class CornerTable {
public:
    static constexpr std::uint32_t none = 0xffffffff;

    explicit CornerTable(const Mesh& m);

    [[nodiscard]] static std::uint32_t next(std::uint32_t corner) { return corner % 3 == 2 ? corner - 2 : corner + 1; }
    [[nodiscard]] static std::uint32_t before(std::uint32_t corner) {
        return corner % 3 == 0 ? corner + 2 : corner - 1;
    }
    [[nodiscard]] std::uint32_t vertex(std::uint32_t corner) const { return vertex_[corner]; }
    /// The corner of the neighbouring triangle beyond the edge that faces this corner; none where the edge does not
    /// belong to two triangles of opposite direction.
    [[nodiscard]] std::uint32_t opposite(std::uint32_t corner) const { return opposite_[corner]; }
    /// A corner at a vertex; none where no triangle has it.
    [[nodiscard]] std::uint32_t at(std::uint32_t vertex) const { return at_[vertex]; }
    [[nodiscard]] bool alive(std::uint32_t triangle) const { return vertex_[3 * std::size_t{triangle}] != none; }

    /// The corners at a vertex, counter-clockwise; empty where they are no single closed ring (open, or several sheets
    /// that touch) or more than `most`.
    void ring(std::uint32_t vertex, std::vector<std::uint32_t>& corners, std::size_t most = none) const;
    /// Draws the vertex of a ring to the one that follows its corner `k`: the two triangles at that edge vanish.
    void draw(const std::vector<std::uint32_t>& ring, std::size_t k);

private:
    void join();
    void glue(std::uint32_t one, std::uint32_t other);

    std::vector<std::uint32_t> vertex_, opposite_, at_;
    std::vector<std::uint32_t> count_;  ///< of each vertex: its triangles
};

}  // namespace obrys::mesh
