#pragma once
/// Meshes of simple bodies: clamps, vices, stock; closed, outside to the outside. Millimetres.

#include <optional>

#include "mesh/mesh.hpp"

namespace obrys::mesh {

/// A box; empty mesh where it has no volume.
[[nodiscard]] Mesh box(geom::Vec3 lo, geom::Vec3 hi);

/// The box that a closed mesh is, its sides along x, y and z; nothing where it is another body.
[[nodiscard]] std::optional<Box> as_box(const Mesh& m);

/// Sides that a circle needs so that its chords lie nowhere farther than `tolerance` from it; between 8 and 4096.
[[nodiscard]] int circle_sides(double radius, double tolerance);
/// A cylinder standing on `foot` along z, its corners on the circle; empty mesh where it has no volume.
[[nodiscard]] Mesh cylinder(geom::Vec3 foot, double radius, double height, int sides);
/// A ball, its vertices on the sphere.
[[nodiscard]] Mesh ball(geom::Vec3 centre, double radius, int sides);

}  // namespace obrys::mesh
