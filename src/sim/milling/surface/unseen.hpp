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

/// A short part of a line that a tool's sharp rim, or its point, leaves: straight, or of a circle, up to a quarter of
/// it.
struct SharpPart {
    struct End {
        geom::Vec3 at;
        bool on_surface = false;
    };
    End from, to;  ///< one of them at least is of the surface; both the same: a place alone
    geom::Vec3 centre;
    double radius = 0;    ///< 0: straight
    Place cell{};         ///< that `from` lies in
    bool joined = false;  ///< `from` is where the part before it ends
    /// Halfway, on the line.
    [[nodiscard]] geom::Vec3 middle(geom::Vec3 a, geom::Vec3 b) const;
    /// How far the line between two of its places lies from the chord, at most.
    [[nodiscard]] double bend(geom::Vec3 a, geom::Vec3 b) const;
};

/// Where a tool's rim, or its point, is part of the surface, in cells with nodes in material: all along.
enum class Sharp : std::uint8_t { rims, points };
[[nodiscard]] std::vector<SharpPart> rims(const Simulation& simulation, Exact& exact, const NodeBits& nodes,
                                          Sharp sharp);
/// A place of such a part, no farther from its `from` than the part is long, is of the surface.
[[nodiscard]] bool is_sharp_place(const Exact& exact, const Place& cell, geom::Vec3 p, double tolerance);

}  // namespace obrys::sim::milling
