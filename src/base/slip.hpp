#pragma once
/// Slips of the pen in the numbers of NC programs.

#include <cstddef>
#include <string_view>

namespace obrys::base {

/// What to write in place of the character at `at`, which cannot be read there, where it looks like part of a number: a
/// decimal comma, the letter O for a zero, I or l for a one. Empty: it does not look so.
[[nodiscard]] std::string_view slip_in_number(std::string_view text, std::size_t at);

}  // namespace obrys::base
