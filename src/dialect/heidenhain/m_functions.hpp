#pragma once
/// M functions M0 … M204 of the HEIDENHAIN iTNC 530. Sources: iTNC 530 User's Manual Conversational Programming
/// (606 42x), "Programming: Miscellaneous functions" and the overview at its end; thesis 2010 on the FV 25 CNC A,
/// appendix 2 (same list, in Czech). Numbers that are not here belong to the machine's builder.

#include <span>

#include "dialect/heidenhain/use.hpp"

namespace obrys::dialect::heidenhain {

/// When a block's M function acts, seen from the block's motion.
enum class When : std::uint8_t { start, end };

struct MFunction {
    int number = 0;
    When when = When::start;
    Use use = Use::refused;
    std::string_view text;             ///< what it does, and why it is refused
    std::string_view parameters = {};  ///< words that belong to it and stand behind it: "F", "LA", "MB"
    bool block_only = false;           ///< acts in its block only; else until it is cancelled
};

/// Nothing for numbers the control leaves to the machine's builder.
[[nodiscard]] const MFunction* find_m(int number);
/// Sorted by number.
[[nodiscard]] std::span<const MFunction> all_m();

}  // namespace obrys::dialect::heidenhain
