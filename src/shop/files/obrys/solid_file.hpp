#pragma once
/// The bodies of [stock], [part] and [[clamp]]. Private to this room.

#include <optional>
#include <vector>

#include "shop/files/section.hpp"
#include "shop/solid.hpp"

namespace obrys::shop {

/// Keys `box`, `cylinder`, `file` (with `unit`), `offset`; nothing where none of them is there or one was reported.
[[nodiscard]] std::optional<Solid> read_solid(Section& section);
/// Keys `file`, `unit`, `offset` of [part].
[[nodiscard]] std::optional<Part> read_part_file(Section& section);
/// [[clamp]].
[[nodiscard]] std::vector<Clamp> read_clamps(Section& file);

/// Three numbers in an array; nothing where there are none or they were reported.
[[nodiscard]] std::optional<geom::Vec3> read_vector(Section& section, std::string_view key);

}  // namespace obrys::shop
