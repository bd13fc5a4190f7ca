#pragma once
/// A tool that is in the spindle, where it is not known which.

#include <cstdint>

#include "cl/record.hpp"

namespace obrys::cl {

/// `number` or `edge` of a ToolChange that depends on a value nobody knows; "?" in texts.
inline constexpr std::uint32_t unknown_tool = 0xFFFFFFFF;

[[nodiscard]] inline bool is_unknown(const ToolChange& tool) {
    return tool.number == unknown_tool || tool.edge == unknown_tool;
}

}  // namespace obrys::cl
