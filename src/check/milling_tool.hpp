#pragma once
/// Tools of the shop as the milling simulation takes them.

#include "shop/tool.hpp"
#include "sim/milling/cutter.hpp"

namespace obrys::check {

/// mm: cutting edges, or a body, as long as any cut, where nothing is said.
inline constexpr double unknown_height = 1000;

/// What cuts, the shank above it and the holder; dimensions that are not known are what ordinary tools have
/// (docs/job-file.md). `rub`: mm by which a body that is assumed stands out of the hole that its edges drill.
[[nodiscard]] sim::milling::Cutter cutter_of(const shop::Tool& tool, double rub = 0);
/// The length of the edges is known and no shank is: what stands above them is taken to be as thick as they are.
[[nodiscard]] bool has_assumed_body(const shop::Tool& tool);

}  // namespace obrys::check
