#pragma once
/// The blank: box, cylinder or closed mesh, and the rays it is made into. Frame of the stock, millimetres.

#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <variant>
#include <vector>

#include "sim/milling/dexel.hpp"

namespace obrys::sim::milling {

/// Round bar along x, y or z (0, 1, 2) from `centre` (of its lower face) over `length`.
struct CylinderStock {
    int axis = 2;
    geom::Vec3 centre;
    double radius = 0, length = 0;
};
/// Closed surface. Which way triangles turn does not matter: what lies inside is found by parity.
struct MeshStock {
    std::vector<geom::Vec3> vertices;
    std::vector<std::array<std::uint32_t, 3>> triangles;
};
using Stock = std::variant<Box3, CylinderStock, MeshStock>;

/// What is wrong with a stock ("the box has no height"); empty: nothing. A mesh may still turn out to be open.
[[nodiscard]] std::string problem_of(const Stock& stock);
[[nodiscard]] Box3 box_of(const Stock& stock);

struct Filled {
    Dexels dexels;
    std::uint64_t open_rays = 0;  ///< of a mesh: rays that enter and do not leave; their last crossing was left out
};
/// `stock` has no problem and lies in the lattice.
[[nodiscard]] Filled fill(const Stock& stock, const Lattice& lattice);

/// Normals of the stock's own faces.
class StockFaces {
public:
    explicit StockFaces(const Stock& stock);
    /// Unit normal out of the material at a point of the surface; at edges that of one of the faces.
    [[nodiscard]] geom::Vec3 normal_at(geom::Vec3 p) const;

private:
    struct Mesh;
    std::variant<Box3, CylinderStock, std::shared_ptr<const Mesh>> faces_;
};

}  // namespace obrys::sim::milling
