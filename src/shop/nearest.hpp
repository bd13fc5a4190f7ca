#pragma once
/// What a wrong word most likely stands for.

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace obrys::shop {

/// Edits (insert, delete, replace, swap of neighbours) that turn a into b.
[[nodiscard]] std::size_t edit_distance(std::string_view a, std::string_view b);

/// The word of `words` that `word` most likely stands for; empty where none is near.
[[nodiscard]] std::string nearest(std::string_view word, const std::vector<std::string>& words);

}  // namespace obrys::shop
