#pragma once
/// A closed mesh met by the rays of a lattice, and its normals.

#include <array>
#include <cstdint>
#include <vector>

#include "sim/milling/stock.hpp"

namespace obrys::sim::milling {

/// Fills the rays; returns how many of them enter the mesh and do not leave it. An edge belongs to its triangles by a
/// rule that gives the same answer for each of them, so a ray through an edge or a corner of a closed mesh is counted
/// right.
[[nodiscard]] std::uint64_t fill_mesh(Dexels& dexels, const MeshStock& mesh);

/// Which triangles are near a point.
class MeshPlaces {
public:
    MeshPlaces(const MeshStock& mesh, const Box3& box);
    /// Normal of the nearest triangle, turned outwards as the mesh's signed volume says.
    [[nodiscard]] geom::Vec3 normal_at(const MeshStock& mesh, geom::Vec3 p) const;

private:
    static constexpr double margin_ = 1e-6;  ///< mm
    [[nodiscard]] std::array<int, 3> cell_of(geom::Vec3 p) const;
    [[nodiscard]] std::size_t index_of(int i, int j, int k) const;

    Box3 box_;
    std::array<int, 3> count_{1, 1, 1};
    std::vector<std::vector<std::uint32_t>> cells_;
    double outwards_ = 1;
};

}  // namespace obrys::sim::milling
