#pragma once
/// What a wrong word most likely stands for.

#include <string>
#include <string_view>
#include <vector>

namespace obrys::shop {

/// The word of `words` that `word` most likely stands for; empty where none is near.
[[nodiscard]] std::string nearest(std::string_view word, const std::vector<std::string>& words);

}  // namespace obrys::shop
