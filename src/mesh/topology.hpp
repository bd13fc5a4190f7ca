#pragma once
/// Whether a mesh bounds a solid: every edge belongs to two triangles that run along it in opposite directions.

#include <cstddef>
#include <cstdint>
#include <vector>

#include "mesh/mesh.hpp"

namespace obrys::mesh {

/// How many edges break a rule, and the first of them: that of the earliest triangle.
struct EdgeFault {
    std::size_t count = 0;
    std::uint32_t triangle = 0;
    geom::Vec3 from, to;
};

struct Topology {
    EdgeFault open;     ///< one triangle only: the surface ends here
    EdgeFault crowded;  ///< more than two triangles, or a triangle with two equal corners
    EdgeFault turned;   ///< two triangles that run along it in the same direction
    std::size_t edges = 0;

    [[nodiscard]] bool closed() const { return open.count == 0 && crowded.count == 0 && turned.count == 0; }
};

[[nodiscard]] Topology topology(const Mesh& m);

/// At 3 t + c the triangle that shares with triangle t the edge from its corner c on; t itself where there is none or
/// more than one.
[[nodiscard]] std::vector<std::uint32_t> neighbours(const Mesh& m);

}  // namespace obrys::mesh
