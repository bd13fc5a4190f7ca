#pragma once
/// Blades from their texts. File format: docs/blade.md.

#include "base/diagnostic.hpp"
#include "shop/blade.hpp"

namespace obrys::shop {

/// What was wrong is in `diagnostics`; then the blade is of no use.
[[nodiscard]] Blade read_blade(std::uint32_t file, const base::Sources& sources, base::Diagnostics& diagnostics);

}  // namespace obrys::shop
