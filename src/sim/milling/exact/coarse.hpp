#pragma once
/// Cells of a lattice that are too coarse for what lies in them.

#include <cstddef>
#include <vector>

#include "mesh/mesh.hpp"
#include "sim/milling/exact/exact.hpp"

namespace obrys::sim::milling {

/// Two triangles about an edge of the lattice.
struct CoarseQuad {
    std::array<int, 3> node{};
    int axis = 0;
    std::size_t triangle = 0;  ///< the first one of the two
};

/// The cells about edges on which material begins and ends again, or ends and begins, unless that is a blunt edge's
/// outermost: no node tells of it. In the order of rays; the same cell may come more than once.
[[nodiscard]] std::vector<Place> cells_with_narrow_edges(const Simulation& simulation);

/// The cells in which the point of a tool has been, where it is part of the surface: it may lie between all nodes.
[[nodiscard]] std::vector<Place> cells_with_points(const Simulation& simulation, Exact& exact);

/// The cells about quads that leave the exact surface by nearly the tolerance at points of their triangles.
[[nodiscard]] std::vector<Place> cells_off(const mesh::Mesh& mesh, const std::vector<CoarseQuad>& quads, Exact& exact,
                                           double tolerance);

/// Whether what lies between two ends on a line is worth to be resolved: normals out of the material at both, `apart`
/// from each other along `axis`.
[[nodiscard]] bool is_worth(geom::Vec3 first, geom::Vec3 second, int axis, double apart, double tolerance);

/// Of a wedge between two faces that a line along `axis` passes through, `apart` from each other: how far from the line
/// it ends. Infinity where it does not.
[[nodiscard]] double to_tip(geom::Vec3 first, geom::Vec3 second, int axis, double apart);

}  // namespace obrys::sim::milling
