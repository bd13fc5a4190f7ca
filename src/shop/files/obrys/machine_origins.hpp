#pragma once
/// [origin] of a machine file: where the values that decide times come from. Private to this room.

#include "shop/files/section.hpp"
#include "shop/machine.hpp"

namespace obrys::shop {

/// After the values themselves; reports origins of values that the file does not say.
void read_origins(Section& file, Machine& machine);

}  // namespace obrys::shop
