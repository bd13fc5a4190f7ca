#pragma once
/// Tool lists. File format: docs/job-file.md.

#include "shop/tool.hpp"

namespace obrys::shop {

/// The tools of a tool list ([[tool]] tables); what is wrong is in `diagnostics` and left out.
[[nodiscard]] std::vector<Tool> read_tools(std::uint32_t file, const base::Sources& sources,
                                           base::Diagnostics& diagnostics);

}  // namespace obrys::shop
