#pragma once
/// Path functions and program words of Klartext, for the list of what is run. Source: iTNC 530 User's Manual
/// Conversational Programming (606 42x), "Programming: Tools", "Programming contours", "Subprograms and program section
/// repeats", "Multiple axis machining".

#include <span>

#include "dialect/heidenhain/use.hpp"

namespace obrys::dialect::heidenhain {

struct PathFunction {
    std::string_view word;
    Use use = Use::run;
    std::string_view text;
};

/// In the manual's order.
[[nodiscard]] std::span<const PathFunction> all_path_functions();

}  // namespace obrys::dialect::heidenhain
