#pragma once
/// What tool types 100 to 299 of SINUMERIK controls are. Private to this room.

#include "shop/tool.hpp"

namespace obrys::shop {

/// Kind and dimensions of a tool whose radius and parameters are read, by its type ($TC_DP1). What neither says is
/// assumed and listed; a type that cannot be taken so stays `other`.
void take_mill(Tool& tool, int type);

}  // namespace obrys::shop
