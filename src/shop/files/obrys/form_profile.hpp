#pragma once
/// The half section of a form tool. Private to this room.

#include <vector>

#include "geom/contour.hpp"
#include "shop/files/section.hpp"

namespace obrys::shop {

/// Key `profile` of a [[tool]]: points `[r, h]`, or `{x, z}` with arcs as in other profiles; x or r the radius, z or h
/// the height above the tip. Empty where it is missing or was reported.
[[nodiscard]] std::vector<geom::Vertex> read_form_profile(Section& tool);

}  // namespace obrys::shop
