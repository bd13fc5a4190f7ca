#pragma once
/// What a control takes as the name of a label, a program or a variable.

#include <string>
#include <string_view>

#include "rewrite/language.hpp"

namespace obrys::rewrite {

enum class Named : std::uint8_t { label, program, variable };

/// Letters, digits and `_` in capitals, two letters in front (else behind `prefix`), none of the control's own words
/// nor of the names that it keeps for itself (else behind "U_"), and no longer than it takes.
[[nodiscard]] std::string good_name(std::string_view text, Named, std::string_view prefix, const Language&);

/// The name with something behind it, and still no longer than the control takes.
[[nodiscard]] std::string with_end(std::string name, std::string_view end, Named, const Language&);

}  // namespace obrys::rewrite
