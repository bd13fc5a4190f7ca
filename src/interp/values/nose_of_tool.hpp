#pragma once
/// Where the programmed point lies on the nose that radius compensation works with.

#include <optional>

#include "shop/tool.hpp"

namespace obrys::interp {

/// 1-9 as path::nose_offset counts; nothing where the tool list does not say it: a tool of no kind without $TC_DP2.
/// A mill or drill moves the point of its axis.
[[nodiscard]] std::optional<int> nose_orientation(const shop::Tool&);
/// The same as the orientation Q of LinuxCNC's tool table, 0-9: the table's own number where the tool has one.
[[nodiscard]] std::optional<int> table_orientation(const shop::Tool&);

}  // namespace obrys::interp
