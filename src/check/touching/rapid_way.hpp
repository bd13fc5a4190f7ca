#pragma once
/// Where a rapid comes by: with dog-leg machines every axis goes at its own speed, so that the way bends where one
/// stops.

#include <vector>

#include "geom/vec.hpp"
#include "shop/machine.hpp"

namespace obrys::check {

/// The ends of its straight pieces, the last one `to`; lengths in mm, along the machine's X, Y and Z. Straight, too,
/// where the machine does not say how fast an axis goes.
[[nodiscard]] std::vector<geom::Vec3> corners_of_rapid(const shop::Machine& machine, geom::Vec3 from, geom::Vec3 to);

}  // namespace obrys::check
