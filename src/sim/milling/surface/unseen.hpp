#pragma once
/// Places of the exact surface that the nodes of a lattice may not tell of: edges and corners of the material where
/// faces of several cuts meet, and the sharp rims of tools that ended or passed in the material.

#include <cstdint>
#include <vector>

#include "sim/milling/exact/exact.hpp"
#include "sim/milling/node_bits.hpp"

namespace obrys::sim::milling {

/// Of the tolerance: how far other bodies may reach over a place of the surface.
inline constexpr double bare_share = 0.3;

/// The cells whose nodes differ.
[[nodiscard]] std::vector<Place> mixed_cells(const NodeBits& nodes);

struct Edges {
    std::vector<geom::Vec3> places;
    std::vector<geom::Vec3> unjudged;  ///< where more faces meet than were looked at, pair by pair
};
/// Places on edges and at corners of the material in or near these cells, in their order. `together`: so many cells,
/// along each axis, are looked at as one; 1, 2 or 4. `follow`: also in the cells that edges lead into, on and on.
[[nodiscard]] Edges edges_in(const std::vector<Place>& cells, Exact& exact, double tolerance, std::int32_t together,
                             bool follow);

/// Places where a tool's rim, or its point, is part of the surface, in cells with nodes in material.
enum class Sharp : std::uint8_t { rims, points };
[[nodiscard]] std::vector<geom::Vec3> rims(const Simulation& simulation, Exact& exact, const NodeBits& nodes,
                                           Sharp sharp);

}  // namespace obrys::sim::milling
