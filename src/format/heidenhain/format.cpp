#include "format/heidenhain/format.hpp"

#include "base/text.hpp"
#include "format/heidenhain/klartext.hpp"
#include "format/heidenhain/lines.hpp"
#include "format/heidenhain/numbers.hpp"

namespace obrys::format::heidenhain {

namespace {

/// BEGIN and PGM with blanks between, anywhere.
bool has_begin(std::string_view text) {
    const std::string upper = base::to_upper(text);
    for (std::size_t at = upper.find("BEGIN"); at != std::string::npos; at = upper.find("BEGIN", at + 5))
        if (trim_left(std::string_view(upper).substr(at + 5)).starts_with("PGM")) return true;
    return false;
}

/// The first line that is no comment: %NAME G71 * or a block with an N number and a star at its end.
bool has_iso_block(std::string_view text) {
    for (const Line& line : split_lines(text)) {
        const Numbered n = split_number(line.text, true);
        if (n.body.empty() || n.body.starts_with(';')) continue;
        if (n.body.starts_with('%')) return true;
        return n.number && trim_right(split_comment(n.body, true).code).ends_with('*');
    }
    return false;
}

}  // namespace

std::optional<Language> language_of(std::string_view text, std::string_view file_name) {
    const std::string name = base::to_upper(file_name);
    const bool klartext = has_begin(text), iso = has_iso_block(text);
    if (iso && (name.ends_with(".I") || !klartext)) return Language::iso;
    if (klartext) return Language::klartext;
    return std::nullopt;
}

Formatted formatted(std::string_view text, Language language, const Options& options) {
    return language == Language::klartext ? formatted_klartext(text, options) : formatted_iso(text, options);
}

}  // namespace obrys::format::heidenhain
