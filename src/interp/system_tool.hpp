#pragma once
/// System variables of SYSREAD. Private to interp.

#include <optional>

#include "interp/run.hpp"

namespace obrys::interp {

/// Value of a system variable from `inch_program` on (program/expr.hpp), in mm and degrees; nothing where the shop does
/// not say it.
[[nodiscard]] std::optional<double> tool_or_frame(Reckoning&, const program::Expr&);

}  // namespace obrys::interp
