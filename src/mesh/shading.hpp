#pragma once
/// Normals for showing a mesh: corners of one vertex whose faces meet smoothly share one, creases stay sharp.

#include <cstdint>
#include <vector>

#include "mesh/mesh.hpp"

namespace obrys::mesh {

struct Shading {
    static constexpr std::uint32_t none = 0xffffffff;
    /// The shaded vertex of corner c of triangle t at 3 t + c; `none` for triangles without area.
    std::vector<std::uint32_t> corners;
    std::vector<std::uint32_t> vertex;  ///< of each shaded vertex, the mesh's
    std::vector<geom::Vec3> normal;     ///< of each shaded vertex, unit length
};

/// `crease`: the angle between faces, radians, from which an edge is sharp.
[[nodiscard]] Shading shade(const Mesh& m, double crease);

}  // namespace obrys::mesh
