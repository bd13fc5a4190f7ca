#pragma once
/// Materials from their texts. File format: docs/cutting-data.md.

#include <vector>

#include "base/diagnostic.hpp"
#include "shop/material.hpp"

namespace obrys::shop {

/// Reads a text of materials: what was wrong is in `diagnostics`, and that material is left out.
[[nodiscard]] std::vector<WorkMaterial> read_materials(std::uint32_t file, const base::Sources& sources,
                                                       base::Diagnostics& diagnostics);

/// Those of folder materials/, built in.
[[nodiscard]] const std::vector<WorkMaterial>& shipped_materials();

}  // namespace obrys::shop
