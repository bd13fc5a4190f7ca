#pragma once
/// Meshes in a compressed package, as bytes. The same mesh gives the same bytes.

#include <string>

#include "mesh/colour.hpp"
#include "mesh/mesh.hpp"

namespace obrys::mesh::package {

/// 3MF, unit millimetre, coordinates rounded to 1e-6 mm, colours as base materials. Throws std::runtime_error where the
/// archive cannot be made (memory). Source: 3MF Consortium, "3MF Core Specification" 1.3.
[[nodiscard]] std::string write_3mf(const Mesh& m, Palette palette = {});

}  // namespace obrys::mesh::package
