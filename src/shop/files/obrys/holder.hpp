#pragma once
/// `holder` of a turning tool: bodies that do not cut, relative to the programmed point. Private to this room.

#include "shop/files/section.hpp"
#include "shop/tool.hpp"

namespace obrys::shop {

/// The bodies, counter-clockwise; what is wrong is reported and left out. `tool` has its kind and the dimensions of its
/// insert.
[[nodiscard]] std::vector<geom::Contour> read_holder(Section& section, const Tool& tool);

}  // namespace obrys::shop
