#pragma once
/// Cost tables from their texts. File format: docs/cost.md.

#include <vector>

#include "base/diagnostic.hpp"
#include "shop/cost.hpp"

namespace obrys::shop {

/// The variants of a text, one at least where nothing is wrong: without [[variant]] the table itself.
[[nodiscard]] std::vector<CostVariant> read_costs(std::uint32_t file, const base::Sources& sources,
                                                  base::Diagnostics& diagnostics);

}  // namespace obrys::shop
