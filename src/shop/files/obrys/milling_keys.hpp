#pragma once
/// [[tool]] of a milling kind: its keys and what is wrong with them. Private to this room.

#include <string_view>

#include "shop/files/section.hpp"
#include "shop/tool.hpp"

namespace obrys::shop {

/// Takes the keys that only milling tools have into `tool`, whatever its kind is; `holder` is left to turning tools.
void read_milling_keys(Section& section, Tool& tool);
/// Complains about keys of milling tools in a tool of a kind that is none.
void refuse_milling_keys(const Section& section, std::string_view kind);
/// Complains about missing and foreign keys of a milling tool, and fills in what its kind lets one leave out. `plain`:
/// of kind "mill", which may have a corner radius or none.
void check_milling_keys(const Section& section, Tool& tool, bool plain);
/// Complains about dimensions that make no tool.
void check_dimensions(const Section& section, const Tool& tool);

}  // namespace obrys::shop
