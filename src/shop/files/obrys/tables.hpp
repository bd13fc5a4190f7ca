#pragma once
/// Tables that more than one kind of file has. Private to this room.

#include <map>

#include "shop/files/section.hpp"
#include "shop/job.hpp"

namespace obrys::shop {

/// [[tool]] of a job or a tool list; adds to `tools`, reports a number and edge that is already there.
void read_tool_tables(Section& file, std::vector<Tool>& tools);
/// [defaults] of a job or a machine.
[[nodiscard]] DefaultsOverride read_defaults(Section& file);
/// [datum] G54 = {x, y, z}; by number, x as a radius.
[[nodiscard]] std::map<std::uint32_t, geom::Vec3> read_datums(Section& file);

}  // namespace obrys::shop
