#pragma once
/// Places on a mesh where something faces it across a narrow gap: slots, engravings, pockets, holes, and strips beside
/// inner edges. Millimetres.

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "mesh/distance.hpp"

namespace obrys::mesh {

/// A piece of a triangle.
struct NarrowFace {
    std::array<geom::Vec3, 3> corners;
    std::uint32_t triangle = 0;
};

/// All of the surface that lies no farther than `reach` from another triangle in front of it whose own front it is on
/// and whose normal differs by more than 20 degrees; more may be among it. No side is longer than `size`. None where
/// there are more than `most`. In the order of the triangles.
[[nodiscard]] std::optional<std::vector<NarrowFace>> narrow_faces(const Distance& part, double reach, double size,
                                                                  std::size_t most);

/// How many times the surface winds about a point, 0 outside of all: right also where closed bodies overlap, or lie
/// within each other.
[[nodiscard]] int winding(const Distance& part, geom::Vec3 p);

}  // namespace obrys::mesh
