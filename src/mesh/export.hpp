#pragma once
/// Meshes as files for other programs, as bytes. The same mesh gives the same bytes. (STL: stl.hpp, 3MF: package/three_mf.hpp)

#include <optional>
#include <string>

#include "mesh/colour.hpp"
#include "mesh/mesh.hpp"

namespace obrys::mesh {

/// Binary glTF: single precision in mm with z up, which a node turns into metres with y up; one material and one
/// primitive a colour; normals are smooth up to `crease` radians between faces; triangles without area are left out.
/// Nothing where the file would exceed 4 GiB. Source: Khronos, "glTF 2.0 Specification".
[[nodiscard]] std::optional<std::string> write_glb(const Mesh& m, Palette palette = {}, double crease = 0.5);

}  // namespace obrys::mesh
