#pragma once
/// Surfaces that pass through themselves: what is inside is not known there. Millimetres.

#include <optional>

#include "mesh/distance.hpp"

namespace obrys::mesh {

/// A place where two triangles go through each other: each reaches farther than so to both sides of the other's plane,
/// and the line in which they meet is longer, or by a quarter of its longest side where that is less. So bodies that
/// touch do not cross. Of the earliest triangle.
[[nodiscard]] std::optional<geom::Vec3> self_crossing(const Distance& surface, double beyond);

}  // namespace obrys::mesh
