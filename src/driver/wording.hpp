#pragma once
/// Messages in the words of the control: stages that know no control by name say things once, this table puts in the
/// words that its programmers have.

#include <string>
#include <string_view>

#include "check/result.hpp"

namespace obrys::driver {

/// The text with the phrases of this control in the place of the general ones.
[[nodiscard]] std::string in_words_of(std::string_view control, std::string text);
/// The same of a message and what helps, with tools as the control's programmer writes them. `offset_numbers`: what its
/// T names beside a tool is the number of an offset (program::Traits::edge_is_offset_number).
void reword(std::string& text, std::string& remedy, std::string_view control, bool offset_numbers);
/// The same of all of a result.
void reword(check::Result& result, std::string_view control, bool offset_numbers = false);

}  // namespace obrys::driver
