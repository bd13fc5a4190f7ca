#pragma once
/// What a wrong word most likely stands for.

#include <string>
#include <string_view>
#include <vector>

namespace obrys::shop {

/// The word of `words` that `word` most likely stands for: few edits away, else one that begins like it. Empty where
/// none is near.
[[nodiscard]] std::string nearest(std::string_view word, const std::vector<std::string>& words);

[[nodiscard]] std::string joined(const std::vector<std::string>& words);  ///< "a, b, c"

/// What to do about a word that is none of `words`: the nearest, and all of them behind `lead`.
[[nodiscard]] std::string words_remedy(std::string_view word, const std::vector<std::string>& words,
                                       std::string_view lead = "one of");

}  // namespace obrys::shop
