#pragma once
/// Convex bodies of revolution and what they sweep on straight ways. Millimetres.

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "geom/vec.hpp"
#include "mesh/mesh.hpp"

namespace obrys::sim::certify {

/// The hull of two rings about the tool's axis, grown by a ball: cylinder, cone, ball (two points on the axis), the
/// end of a bull nose. Heights count from the programmed point upwards, z0 <= z1.
struct Body {
    double r0 = 0, z0 = 0, r1 = 0, z1 = 0;
    double rounding = 0;
};
/// A part of a tool: all it consists of.
using Shape = std::vector<Body>;

/// How a body's corners go inwards when it is made smaller.
enum class Inwards : std::uint8_t {
    middle,         ///< halfway between the faces that meet there
    along,          ///< nearly along the axis
    across,         ///< nearly towards the axis
    flank,          ///< off the flank: that moves as far as it may, the ends along it
    rather_along,   ///< 30 degrees off the axis
    rather_across,  ///< 60 degrees off it
};
inline constexpr std::array all_ways{Inwards::middle, Inwards::along,        Inwards::across,
                                     Inwards::flank,  Inwards::rather_along, Inwards::rather_across};
/// A body that covers `body` again when it is grown by a ball of radius `depth`, and stands off its faces.
[[nodiscard]] Body shrunk(const Body& body, double depth, Inwards how);
/// What lies at least `depth` deep in a body; nothing where it is nowhere so thick.
[[nodiscard]] std::optional<Body> core_of(const Body& body, double depth);

/// What a body sweeps on a straight way, its axis held.
struct Swept {
    Body body;
    geom::Vec3 from, way;
    geom::Vec3 axis{0, 0, 1};  ///< unit length
};
/// The point farthest along `u` (any length), before it is grown by the ball.
[[nodiscard]] geom::Vec3 support(const Swept& swept, geom::Vec3 u);
/// The largest dot(u, p) of all its points, `u` of unit length.
[[nodiscard]] double extent(const Swept& swept, geom::Vec3 u);
[[nodiscard]] mesh::Box box_of(const Swept& swept);
/// A unit vector from the swept body towards a point outside of it, nearly the one in which the two lie farthest apart;
/// zero where the point may lie within.
[[nodiscard]] geom::Vec3 towards(const Swept& swept, geom::Vec3 p);
/// The point of the swept body, grown by its ball, nearest to `p`: `p` itself where it lies within. To 1e-9 of the way.
[[nodiscard]] geom::Vec3 nearest_within(const Swept& swept, geom::Vec3 p);

}  // namespace obrys::sim::certify
