#pragma once
/// Fewer triangles for what is flat.

#include "mesh/mesh.hpp"

namespace obrys::mesh {

/// The same surface with vertices left out that lie within one plane, or on a straight border between two planes or two
/// tags; no vertex is moved or added. Every point of either surface lies within `deviation` mm of the other, and a
/// border between tags moves by at most that. Where the mesh is closed it stays so; no triangle becomes turned over or
/// thinner than `deviation` that was not. What is curved stays as it is. Triangles keep their order and tags as far as
/// they stay. Without a positive deviation the mesh as it is. Time grows linearly with the triangles.
[[nodiscard]] Mesh merge_flat(const Mesh& m, double deviation);

}  // namespace obrys::mesh
