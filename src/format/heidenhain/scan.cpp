#include "format/heidenhain/scan.hpp"

#include "base/text.hpp"

namespace obrys::format::heidenhain {

using base::is_blank;
using base::is_digit;
using base::is_letter;

void Scan::skip_blanks() {
    while (is_blank(peek())) ++at_;
}

bool Scan::at_end() {
    skip_blanks();
    return at_ >= code_.size();
}

char Scan::peek(std::size_t k) const { return at_ + k < code_.size() ? code_[at_ + k] : '\0'; }
char Scan::upper(std::size_t k) const { return base::upper(peek(k)); }

std::string Scan::letters() const {
    std::size_t n = 0;
    while (is_letter(peek(n))) ++n;
    return base::to_upper(code_.substr(at_, n));
}

bool Scan::take_word(std::string_view word) {
    const std::size_t before = at_;
    skip_blanks();
    if (letters() == word) {
        at_ += word.size();
        return true;
    }
    at_ = before;
    return false;
}

bool Scan::take(char c) {
    const std::size_t before = at_;
    skip_blanks();
    if (peek() == c) {
        ++at_;
        return true;
    }
    at_ = before;
    return false;
}

bool Scan::parameter(std::string& out) {
    if (upper() != 'Q') return false;
    const char kind = upper(1);
    std::size_t n = kind == 'L' || kind == 'R' || kind == 'S' ? 2 : 1;
    if (!is_digit(peek(n))) return false;
    while (is_digit(peek(n))) ++n;
    out += base::to_upper(code_.substr(at_, n));
    at_ += n;
    return true;
}

bool Scan::number(std::string& out) {
    std::size_t n = 0;
    const auto digits = [&] {
        const std::size_t from = n;
        while (is_digit(peek(n))) ++n;
        return n - from;
    };
    const bool whole = digits() > 0;
    std::size_t sign = std::string_view::npos;
    if ((peek(n) == '.' || peek(n) == ',') && (whole || is_digit(peek(n + 1)))) {
        sign = n++;
        digits();
    }
    if (n == 0) return false;
    const bool signed_exponent = (peek(n + 1) == '+' || peek(n + 1) == '-') && is_digit(peek(n + 2));
    if (upper(n) == 'E' && (is_digit(peek(n + 1)) || signed_exponent)) {
        n += 2;
        digits();
    }
    std::string text = base::to_upper(code_.substr(at_, n));
    if (sign != std::string_view::npos && decimal_ != Decimal::keep)
        text[sign] = decimal_ == Decimal::point ? '.' : ',';
    out += text;
    at_ += n;
    return true;
}

bool Scan::value(std::string& out, Sign sign) {
    const std::size_t before = at_;
    std::string word;
    skip_blanks();
    if (peek() == '+' || peek() == '-') {
        word = peek();
        ++at_;
        skip_blanks();
    } else if (sign == Sign::always) {
        word = '+';
    }
    if (!parameter(word) && !number(word)) {
        at_ = before;
        return false;
    }
    out += word;
    return true;
}

bool Scan::text(std::string& out) {
    if (peek() != '"') return false;
    const std::size_t end = code_.find('"', at_ + 1);
    if (end == std::string_view::npos) return false;
    out += code_.substr(at_, end + 1 - at_);
    at_ = end + 1;
    return true;
}

void append_word(std::string& out, std::string_view word) {
    if (!out.empty()) out += ' ';
    out += word;
}

std::optional<std::string> collapsed(std::string_view code, bool upper_case) {
    std::string out;
    bool inside = false;
    for (const char c : code) {
        if (c == '\'' && !inside) return std::nullopt;
        if (c == '"') inside = !inside;
        if (!inside && is_blank(c)) {
            if (!out.empty() && out.back() != ' ') out += ' ';
            continue;
        }
        out += upper_case && !inside ? base::upper(c) : c;
    }
    if (inside) return std::nullopt;
    if (out.ends_with(' ')) out.pop_back();
    return out;
}

std::string with_decimals(std::string code, Decimal decimal) {
    if (decimal == Decimal::keep) return code;
    bool inside = false;
    for (std::size_t i = 0; i < code.size(); ++i) {
        if (code[i] == '"') inside = !inside;
        if (inside || (code[i] != '.' && code[i] != ',')) continue;
        const bool before = i > 0 && is_digit(code[i - 1]), behind = i + 1 < code.size() && is_digit(code[i + 1]);
        if (behind || (before && code[i] == '.')) code[i] = decimal == Decimal::point ? '.' : ',';
    }
    return code;
}

}  // namespace obrys::format::heidenhain
