/// Which files with the suffix of definition files are the control's: PGA 04.00 (Siemens, Programming Guide Advanced),
/// 3.4 Defining user data, p. 3-131: reserved names.

#include <algorithm>
#include <array>

#include "base/text.hpp"
#include "read/sinumerik/read.hpp"

namespace obrys::read::sinumerik {

namespace {

constexpr std::array<std::string_view, 12> reserved{"SMAC", "MMAC", "UMAC", "SGUD", "MGUD", "UGUD",
                                                    "GUD4", "GUD5", "GUD6", "GUD7", "GUD8", "GUD9"};

/// "_N_UGUD_DEF", "UGUD.DEF", "UGUD_DEF.DEF": what the control calls it.
bool has_reserved_name(std::string_view name) {
    if (name.starts_with("_N_")) name.remove_prefix(3);
    name = name.substr(0, std::min(name.find('.'), name.find("_DEF")));
    return std::find(reserved.begin(), reserved.end(), name) != reserved.end();
}

bool is_word(char c) { return base::is_letter(c) || base::is_digit(c) || c == '_'; }

/// The next word of a line; empty where there is none.
std::string_view take_word(std::string_view& line) {
    while (!line.empty() && !is_word(line.front())) line.remove_prefix(1);
    std::size_t n = 0;
    while (n < line.size() && is_word(line[n])) ++n;
    const std::string_view word = line.substr(0, n);
    line.remove_prefix(n);
    return word;
}

bool is_scope(std::string_view word) {
    return base::equals_ignoring_case(word, "NCK") || base::equals_ignoring_case(word, "CHAN");
}

/// DEF with a scope (access rights and the like may stand between), or a macro.
bool defines_globally(std::string_view line) {
    line = base::trim(line.substr(0, line.find(';')));
    std::string_view word = take_word(line);
    if (word.size() > 1 && (word[0] == 'N' || word[0] == 'n') && base::is_digit(word[1])) word = take_word(line);
    if (base::equals_ignoring_case(word, "DEFINE") || base::equals_ignoring_case(word, "REDEF")) return true;
    if (!base::equals_ignoring_case(word, "DEF")) return false;
    while (!(word = take_word(line)).empty())
        if (is_scope(word)) return true;
    return false;
}

}  // namespace

bool is_definition_file(std::string_view text, std::string_view upper_name) {
    if (has_reserved_name(upper_name)) return true;
    while (!text.empty()) {
        const auto end = std::min(text.find_first_of("\r\n"), text.size());
        const std::string_view line = text.substr(0, end);
        if (line.starts_with("%_N_") || defines_globally(line)) return true;
        text.remove_prefix(std::min(end + 1, text.size()));
    }
    return false;
}

}  // namespace obrys::read::sinumerik
