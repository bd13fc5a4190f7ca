#pragma once
/// Bodies that another reader made into triangles (STEP): joined to closed meshes, with what is wrong with them.

#include <cstdint>
#include <vector>

#include "base/diagnostic.hpp"
#include "mesh/mesh.hpp"

namespace obrys::mesh {

/// Joins the equal vertices of a body and leaves out triangles without area; a surface that was inside out is turned
/// over. `closed` becomes false where it does not bound a solid, and `out` says at the beginning of `file` why
/// (`mesh-not-closed`).
[[nodiscard]] Mesh settled(std::uint32_t file, const Mesh& soup, bool& closed, base::Diagnostics& out);

/// All bodies as one mesh. Where the boxes of two meet, so may their surfaces: then inside and outside are not known,
/// `closed` becomes false and `out` names the two.
[[nodiscard]] Mesh united(std::uint32_t file, const std::vector<Mesh>& bodies, bool& closed, base::Diagnostics& out);

}  // namespace obrys::mesh
