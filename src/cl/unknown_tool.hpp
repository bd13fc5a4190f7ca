#pragma once
/// Tools in the spindle of which it is not known which they are.

#include <cstdint>

#include "cl/record.hpp"

namespace obrys::cl {

/// `number` or `edge` of a ToolChange that depends on a value nobody knows; "?" in texts.
inline constexpr std::uint32_t unknown_tool = 0xFFFFFFFF;

[[nodiscard]] inline bool is_unknown(const ToolChange& tool) {
    return tool.number == unknown_tool || tool.edge == unknown_tool;
}

/// Offsets of the tool that is in the spindle when the program begins (D1 without T): no word has called it, so that
/// nobody knows which it is.
[[nodiscard]] inline bool is_uncalled(const ToolChange& tool) {
    return tool.standing && tool.number == 0 && tool.name.empty() && tool.with_length;
}

}  // namespace obrys::cl
