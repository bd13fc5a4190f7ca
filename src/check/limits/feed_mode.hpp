#pragma once
/// Feeds that make sense in the other feed mode only: mm a minute meant, run per revolution, or the reverse.

#include <optional>

#include "check/result.hpp"
#include "shop/machine.hpp"
#include "shop/tool.hpp"

namespace obrys::check {

/// mm a revolution above which no tool cuts: 10, of a mill its diameter where that is more; of a drill 1, or a quarter
/// of its diameter where that is more; 5 of a turning or grooving tool; 50 where nobody says which tool it is. Face
/// mills of high feed take 2 mm a tooth and so stay far below their diameter; drills take a thirtieth of theirs,
/// turning ends at 3.
[[nodiscard]] double widest_feed(const shop::Tool* tool, shop::MachineKind machine);
/// A feed per revolution above `widest`.
[[nodiscard]] std::optional<Finding> too_fast(double feed_per_rev, double widest);
/// A cut at a feed per revolution below what any machine for metal cuts: 0.005 mm, of drills and mills a hundredth of
/// their diameter where that is less.
[[nodiscard]] std::optional<Finding> too_fine(double feed_per_rev, const shop::Tool* tool);
/// A cut below 1 mm a minute, at less than `finest` mm a revolution.
[[nodiscard]] std::optional<Finding> too_slow(double feed_per_minute, double feed_per_rev, double finest);

inline constexpr double finest_milled = 0.01, finest_turned = 0.001;  ///< mm; diamonds turn mirrors with a micrometre

}  // namespace obrys::check
