#pragma once
/// What a program says to people, in the characters that another control has for it.

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace obrys::base {

struct CommentRules {
    bool plain = false;                 ///< capitals, digits and signs of the seven bit code alone
    bool holds_quotes = true;           ///< it may hold "
    bool holds_brackets = true;         ///< it may hold ( and )
    std::size_t longest = 0;            ///< bytes; 0: as long as it is
    std::vector<std::string> active{};  ///< beginnings, in capitals, with which a comment would do something
};

/// Letters with marks become those without, "ü" of German texts two. `has_cp1252`: but those of Windows-1252.
[[nodiscard]] std::string without_marks(std::string_view text, bool has_cp1252 = false);
/// On one line, and a comment of that control wherever it came from.
[[nodiscard]] std::string comment_text(std::string_view text, const CommentRules& rules);

}  // namespace obrys::base
