#pragma once
/// Small text helpers for NC programs: ASCII case, blanks, CP1252 and UTF-8. Nothing here depends on the locale.

#include <string>
#include <string_view>

namespace obrys::base {

[[nodiscard]] constexpr char upper(char c) { return c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c; }
[[nodiscard]] constexpr bool is_digit(char c) { return c >= '0' && c <= '9'; }
[[nodiscard]] constexpr bool is_letter(char c) { return (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z'); }
[[nodiscard]] constexpr bool is_blank(char c) { return c == ' ' || c == '\t'; }

[[nodiscard]] std::string to_upper(std::string_view s);  ///< ASCII letters only
[[nodiscard]] bool equals_ignoring_case(std::string_view a, std::string_view b);
[[nodiscard]] std::string_view trim(std::string_view s);  ///< blanks, tabs, CR and LF off both ends
[[nodiscard]] bool is_utf8(std::string_view s);
[[nodiscard]] std::string cp1252_to_utf8(std::string_view s);
/// Valid UTF-8 as CP1252; `instead` for each character that it does not have.
[[nodiscard]] std::string utf8_to_cp1252(std::string_view s, char instead);
/// No longer than so many bytes, by whole characters; 0: as long as it is.
void cut_utf8(std::string& s, std::size_t most);
/// The text as UTF-8 whatever it was: unchanged where it is valid UTF-8, else taken as CP1252.
[[nodiscard]] std::string as_utf8(std::string_view s);
/// Characters in valid UTF-8; bytes otherwise.
[[nodiscard]] std::size_t character_count(std::string_view s);
/// A field of a CSV row: in quotes where it needs them (RFC 4180).
[[nodiscard]] std::string csv_field(std::string_view s);
/// A program's text without what old editors leave behind its last line: Ctrl-Z (CP/M's end of text) and NUL, with the
/// blanks and line ends around them. Behind them nothing is left out that says something.
[[nodiscard]] std::string_view without_end_signs(std::string_view text);
/// True where the text holds bytes no NC program holds (NUL and most control characters).
[[nodiscard]] bool looks_binary(std::string_view s);
inline constexpr std::size_t telling_bytes = 65536;  ///< of a text, at its begin, that tell what it is
/// The name of a file without its folders, which / and \ part, and without its suffix.
[[nodiscard]] std::string_view stem(std::string_view path);

}  // namespace obrys::base
