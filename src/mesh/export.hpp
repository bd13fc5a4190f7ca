#pragma once
/// Meshes as files for other programs, as bytes. The same mesh gives the same bytes. (STL: stl.hpp)

#include <optional>
#include <string>

#include "mesh/colour.hpp"
#include "mesh/mesh.hpp"

namespace obrys::mesh {

/// 3MF, unit millimetre, coordinates rounded to 1e-6 mm, colours as base materials. Throws std::runtime_error where the
/// archive cannot be made (memory). Source: 3MF Consortium, "3MF Core Specification" 1.3.
[[nodiscard]] std::string write_3mf(const Mesh& m, Palette palette = {});

/// Binary glTF: single precision in mm with z up, which a node turns into metres with y up; one material and one
/// primitive a colour; normals are smooth up to `crease` radians between faces; triangles without area are left out.
/// Nothing where the file would exceed 4 GiB. Source: Khronos, "glTF 2.0 Specification".
[[nodiscard]] std::optional<std::string> write_glb(const Mesh& m, Palette palette = {}, double crease = 0.5);

}  // namespace obrys::mesh
