#include "base/slip.hpp"

#include "base/text.hpp"

namespace obrys::base {

std::string_view slip_in_number(std::string_view text, std::size_t at) {
    if (at == 0 || at >= text.size()) return {};
    const char before = text[at - 1], after = at + 1 < text.size() ? text[at + 1] : ' ';
    const bool in_number = is_digit(before) || before == '.' || before == '+' || before == '-';
    if (text[at] == ',' && in_number && is_digit(after)) return "write a decimal point in place of the comma";
    if (is_letter(after)) return {};
    if (upper(text[at]) == 'O' && (in_number || is_letter(before)))
        return "the letter O stands here: write the digit 0 if a zero is meant";
    if ((text[at] == 'l' || text[at] == 'I') && in_number)
        return "a letter stands here: write the digit 1 if a one is meant";
    return {};
}

}  // namespace obrys::base
