#pragma once
/// Tool libraries of Autodesk Fusion, exported as JSON. docs/job-file.md says how their fields are taken.

#include "shop/tool.hpp"

namespace obrys::shop {

/// What is not taken is listed in one note. A tool without a number, of a number that is there already or whose
/// dimensions make no tool is left out with a warning; a text that is no such library is an error.
[[nodiscard]] std::vector<Tool> read_fusion_tools(std::uint32_t file, const base::Sources& sources,
                                                  base::Diagnostics& diagnostics);

}  // namespace obrys::shop
