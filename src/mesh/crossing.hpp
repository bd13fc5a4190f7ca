#pragma once
/// Surfaces that pass through themselves: what is inside is not known there. Millimetres.

#include <optional>

#include "mesh/distance.hpp"

namespace obrys::mesh {

/// A place where a side of a triangle goes through the inside of another one: both ends lie farther from that one's
/// plane than so, and the place lies farther from its border, or by a quarter of the side and of the largest circle in
/// the triangle where these are less. So bodies that touch do not cross. Of the earliest triangle.
[[nodiscard]] std::optional<geom::Vec3> self_crossing(const Distance& surface, double beyond);

}  // namespace obrys::mesh
