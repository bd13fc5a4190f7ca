#pragma once
/// Which triangles of a mesh lie in one plane together, and what remains of the borders between such regions.

#include <cstdint>
#include <vector>

#include "mesh/corner_table.hpp"
#include "mesh/mesh.hpp"

namespace obrys::mesh {

inline constexpr std::uint32_t no_region = 0xffffffff;

struct FlatRegions {
    std::vector<std::uint32_t> of;   ///< of each triangle; `no_region`: curved there
    std::vector<geom::Vec3> normal;  ///< of each region, unit length
};
/// Connected triangles of one tag whose corners all lie within `off` mm of one plane and that face the same way. Only
/// regions of `fewest` triangles count. Linear in the number of triangles.
[[nodiscard]] FlatRegions flat_regions(const Mesh& m, const CornerTable& corners, double off, std::size_t fewest = 4);

/// What may become of a vertex.
enum class Role : std::uint8_t {
    fixed,   ///< where three regions meet, or curved ones, or a border turns; where the surface is no manifold
    border,  ///< between two regions, on a straight stretch of their border
    inside,  ///< of one region
};
/// A stretch of border is straight where all its vertices lie within `off` mm of the line between its ends, in order.
[[nodiscard]] std::vector<Role> roles_of(const Mesh& m, const CornerTable& corners, const FlatRegions& regions,
                                         double off);

}  // namespace obrys::mesh
