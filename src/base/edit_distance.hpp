#pragma once
/// How unlike two words are.

#include <cstddef>
#include <string_view>

namespace obrys::base {

/// Edits (insert, delete, replace, swap of neighbours) that turn a into b.
[[nodiscard]] std::size_t edit_distance(std::string_view a, std::string_view b);

}  // namespace obrys::base
