#pragma once
/// The vertex of a cell: the point nearest to all tangent planes of the surface at the cell's crossings.
/// Source: Ju, Losasso, Schaefer, Warren: "Dual Contouring of Hermite Data" (2002).

#include <array>
#include <cstddef>
#include <vector>

#include "geom/vec.hpp"

namespace obrys::sim::milling {

class PlaneFit {
public:
    /// A crossing at `p`; `within` is the same, moved onto the cell's edge where it lies beside it.
    void add(geom::Vec3 p, geom::Vec3 within, geom::Vec3 unit_normal);
    /// A crossing whose plane is not known: it only draws the vertex.
    void add(geom::Vec3 within);

    /// The vertex, within the box `lo` … `hi`. Along directions that the planes hardly determine it stays by the mean
    /// of the crossings. At least one crossing must have been added.
    [[nodiscard]] geom::Vec3 vertex(geom::Vec3 lo, geom::Vec3 hi) const;
    /// The largest distance of a point from one of the planes.
    [[nodiscard]] double miss(geom::Vec3 p) const;

    /// The cosine of the largest angle between two of the normals.
    [[nodiscard]] double sharpest() const;
    /// The largest distance of a crossing from the plane of another one; infinite where a plane is not known.
    [[nodiscard]] double spread() const;

private:
    [[nodiscard]] bool is_flat() const;
    struct Plane {
        geom::Vec3 point, normal;
    };
    [[nodiscard]] const Plane& plane(std::size_t i) const { return i < few ? planes_[i] : more_[i - few]; }
    static constexpr std::size_t few = 12;  ///< a cell of a lattice has no more edges
    std::array<Plane, few> planes_;
    std::vector<Plane> more_;
    std::size_t count_ = 0, crossings_ = 0;
    geom::Vec3 sum_;
};

}  // namespace obrys::sim::milling
