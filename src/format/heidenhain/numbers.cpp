#include "format/heidenhain/numbers.hpp"

#include "base/text.hpp"
#include "format/heidenhain/lines.hpp"

namespace obrys::format::heidenhain {

Numbered split_number(std::string_view line, bool n_word) {
    Numbered n;
    std::string_view s = trim_left(line);
    const auto skip_sign = [&] {
        if (!s.starts_with('/')) return false;
        s = trim_left(s.substr(1));
        return true;
    };
    n.skip_before = skip_sign();
    const bool letter = n_word && !s.empty() && base::upper(s[0]) == 'N';
    std::size_t digits = letter ? 1 : 0;
    while (digits < s.size() && base::is_digit(s[digits])) ++digits;
    n.number = n_word ? letter && digits > 1 : digits > 0;
    if (n.number) {
        n.digits = s.substr(letter ? 1 : 0, digits - (letter ? 1 : 0));
        s.remove_prefix(digits);
        n.understood = s.empty() || base::is_blank(s[0]) || base::is_letter(s[0]) ||
                       std::string_view(";*/%~").find(s[0]) != std::string_view::npos;
        s = trim_left(s);
    }
    n.skip_behind = skip_sign();
    n.body = s;
    return n;
}

std::string Counter::next(const Numbered& n) {
    std::string out = n.skip_before ? "/" : "";
    if (!kept_ || n.number) {
        out += letter_;
        out += kept_ ? std::string(n.digits) : std::to_string(next_);
    }
    next_ += step_;
    if ((!n.body.empty() || n.skip_behind) && !out.empty() && out != "/") out += ' ';
    if (n.skip_behind) out += '/';
    return out;
}

}  // namespace obrys::format::heidenhain
