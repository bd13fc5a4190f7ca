#pragma once
/// Tools of the shop as the milling simulation takes them.

#include "shop/tool.hpp"
#include "sim/milling/cutter.hpp"

namespace obrys::check {

/// What cuts, the shank above it and the holder; dimensions that are not known are what ordinary tools have
/// (docs/job-file.md).
[[nodiscard]] sim::milling::Cutter cutter_of(const shop::Tool& tool);
[[nodiscard]] bool has_shank(const shop::Tool& tool);
[[nodiscard]] bool has_holder(const shop::Tool& tool);

}  // namespace obrys::check
