#include "base/comment.hpp"

#include <algorithm>
#include <array>
#include <cstdint>

#include "base/text.hpp"

namespace obrys::base {

namespace {

/// Of U+00C0 to U+017F, without their marks; `.`: more than one letter, or none.
constexpr std::string_view letters =
    "AAAA.A.CEEEEIIIIDNOOOO.xOUUU.YT."   // À …
    "aaaa.a.ceeeeiiiidnoooo.-ouuu.yty"   // à …
    "AaAaAaCcCcCcCcDdDdEeEeEeEeEeGgGg"   // Ā …
    "GgGgHhHhIiIiIiIiIi..JjKkkLlLlLlL"   // Ġ …
    "lLlNnNnNnn..OoOoOo..RrRrRrSsSsSs"   // ŀ …
    "SsTtTtTtUuUuUuUuUuUuWwYyYZzZzZzs";  // Š …
struct Several {
    std::uint32_t character;
    std::string_view letters;
};
constexpr std::array several{
    Several{0xC4, "Ae"},  Several{0xC6, "Ae"},   Several{0xD6, "Oe"},   Several{0xDC, "Ue"},   Several{0xDF, "ss"},
    Several{0xE4, "ae"},  Several{0xE6, "ae"},   Several{0xF6, "oe"},   Several{0xFC, "ue"},   Several{0x132, "IJ"},
    Several{0x133, "ij"}, Several{0x14A, "N"},   Several{0x14B, "n"},   Several{0x152, "OE"},  Several{0x153, "oe"},
    Several{0xB5, "u"},   Several{0xB0, " deg"}, Several{0xB1, "+-"},   Several{0x2013, "-"},  Several{0x2014, "-"},
    Several{0x2019, "'"}, Several{0x201C, "\""}, Several{0x201D, "\""}, Several{0x201E, "\""}, Several{0x2026, "..."},
    Several{0x2300, "D"}, Several{0xD8, "D"},  // the sign of diameters, and what stands for it
};

std::string plain_of(std::uint32_t c) {
    for (const Several& s : several)
        if (s.character == c) return std::string(s.letters);
    if (c >= 0xC0 && c - 0xC0 < letters.size() && letters[c - 0xC0] != '.') return {letters[c - 0xC0]};
    return "?";
}

/// Length of the character that begins with this byte of valid UTF-8.
std::size_t length_of(unsigned char c) { return c < 0x80 ? 1 : c < 0xE0 ? 2 : c < 0xF0 ? 3 : 4; }

void keep_to(std::string& text, const CommentRules& rules) {
    for (char& c : text) {
        if (!rules.holds_brackets) c = c == '(' ? '<' : c == ')' ? '>' : c;
        if (!rules.holds_quotes && c == '"') c = '\'';
        if (static_cast<unsigned char>(c) < ' ' || c == '\x7F') c = ' ';
        if (!rules.plain) continue;
        c = upper(c);
        if (c > 'Z' || c == '%') c = ' ';
    }
}

}  // namespace

std::string without_marks(std::string_view text, bool has_cp1252) {
    std::string out;
    for (std::size_t at = 0; at < text.size();) {
        const auto first = static_cast<unsigned char>(text[at]);
        const std::size_t length = std::min(length_of(first), text.size() - at);
        const std::string_view character = text.substr(at, length);
        at += length;
        if (length == 1 || (has_cp1252 && utf8_to_cp1252(character, '\0') != std::string(1, '\0'))) {
            out += character;
            continue;
        }
        std::uint32_t c = first & (0xFFU >> (length + 1));
        for (const char more : character.substr(1)) c = (c << 6) | (static_cast<unsigned char>(more) & 0x3FU);
        out += plain_of(c);
    }
    return out;
}

std::string comment_text(std::string_view text, const CommentRules& rules) {
    std::string out = as_utf8(text);
    if (rules.plain) out = without_marks(out);
    keep_to(out, rules);
    const std::string begin = to_upper(trim(out).substr(0, 32));
    const auto acts = [&](const std::string& active) { return begin.starts_with(active); };
    if (std::any_of(rules.active.begin(), rules.active.end(), acts)) out = "- " + std::string(trim(out));
    cut_utf8(out, rules.longest);
    while (out.ends_with('~') || out.ends_with(' ')) out.pop_back();  // ~: the block would go on in the next line
    return out;
}

}  // namespace obrys::base
