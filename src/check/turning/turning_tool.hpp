#pragma once
/// Tools on a lathe as the removal needs them, in the (z, x) plane relative to the programmed point.

#include <string>

#include "cl/record.hpp"
#include "shop/tool.hpp"

namespace obrys::check {

/// What the insert covers; of a drill, reamer, tap (its core) or mill that stands on the turning axis its section, on
/// both sides of the axis, with the tip at the left. Empty where there is none.
[[nodiscard]] geom::Contour turning_outline(const shop::Tool& tool);
/// The section of a tap with its thread.
[[nodiscard]] geom::Contour whole_tap(const shop::Tool& tap);
/// What stands behind a blade of known length whose holder is not given: wider than the blade on both sides. Empty for
/// other tools, and for blades that go on into a bore.
[[nodiscard]] geom::Contour behind_blade(const shop::Tool& tool);

}  // namespace obrys::check
