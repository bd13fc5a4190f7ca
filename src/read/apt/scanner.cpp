#include "read/apt/scanner.hpp"

#include <algorithm>

#include "base/text.hpp"

namespace obrys::read::apt {

namespace {

constexpr std::uint32_t card_columns = 72, card_width = 80;

bool is_word_char(char c) { return base::is_letter(c) || base::is_digit(c) || c == '_'; }

TokenKind sign_kind(char c) {
    switch (c) {
        case '/': return TokenKind::slash;
        case ',': return TokenKind::comma;
        case '(': return TokenKind::open;
        case ')': return TokenKind::close;
        case '=': return TokenKind::equals;
        default: return TokenKind::other;
    }
}

/// E+02 behind a number: how long it is.
std::size_t exponent_length(std::string_view s) {
    if (s.empty() || base::upper(s[0]) != 'E') return 0;
    std::size_t i = 1;
    if (i < s.size() && (s[i] == '+' || s[i] == '-')) ++i;
    const std::size_t digits = i;
    while (i < s.size() && base::is_digit(s[i])) ++i;
    return i > digits && (i == s.size() || !is_word_char(s[i])) ? i : 0;
}

}  // namespace

bool has_card_numbers(std::string_view text) {
    int cards = 0;
    for (std::string_view rest = text.substr(0, base::telling_bytes); !rest.empty();) {
        const std::size_t end = std::min(rest.find('\n'), rest.size());
        std::string_view line = rest.substr(0, end);
        rest.remove_prefix(std::min(end + 1, rest.size()));
        if (line.ends_with('\r')) line.remove_suffix(1);
        if (line.size() <= card_columns) continue;
        if (line.size() > card_width) return false;
        const std::string_view number = base::trim(line.substr(card_columns));
        if (number.empty()) continue;
        if (!std::all_of(number.begin(), number.end(), [](char c) { return is_word_char(c); }) ||
            !base::is_digit(number.back()))
            return false;
        ++cards;
    }
    return cards > 1;
}

Scanner::Scanner(std::string_view text) : text_(text), numbered_(has_card_numbers(text)) {}

std::uint32_t Scanner::line_end(std::uint32_t from) const {
    return static_cast<std::uint32_t>(std::min(text_.find('\n', from), text_.size()));
}

std::uint32_t Scanner::body_end(std::uint32_t from) const {
    std::uint32_t end = line_end(from);
    std::uint32_t begin = from;
    while (begin > 0 && text_[begin - 1] != '\n') --begin;
    if (numbered_) end = std::min(end, begin + card_columns);
    end = std::max(end, from);
    while (end > from && (base::is_blank(text_[end - 1]) || text_[end - 1] == '\r')) --end;
    return end;
}

std::string_view Scanner::rest_of_line(std::uint32_t from) const { return text_.substr(from, body_end(from) - from); }

std::uint32_t Scanner::scan_number_or_word(Line& line, std::uint32_t from, std::uint32_t to) const {
    const std::string_view s = text_.substr(from, to - from);
    Token t;
    t.begin = from;
    const bool may_be_number = base::is_digit(s[0]) || s[0] == '.' || s[0] == '-' || s[0] == '+';
    base::NumberScan n = may_be_number ? base::scan_decimal(s) : base::NumberScan{};
    std::size_t length = n.length;
    if (length > 0) {
        if (const std::size_t e = exponent_length(s.substr(length)); e > 0) {
            length += e;
            if (const auto v = base::parse_double(s.substr(0, length))) n.value = *v;
            n.decimal.reset();
            n.integer = false;
        }
        if (length == s.size() || !is_word_char(s[length])) {
            t.kind = TokenKind::number;
            t.number = n;
            t.end = from + static_cast<std::uint32_t>(length);
            t.chars = s.substr(0, length);
            line.tokens.push_back(t);
            return t.end;
        }
    }
    std::size_t i = 0;
    while (i < s.size() && (is_word_char(s[i]) || (s[i] == '-' && i > 0 && i + 1 < s.size() &&
                                                   base::is_letter(s[i - 1]) && base::is_letter(s[i + 1]))))
        ++i;
    t.kind = i > 0 ? TokenKind::word : sign_kind(s[0]);
    t.end = from + static_cast<std::uint32_t>(std::max<std::size_t>(i, 1));
    t.chars = text_.substr(from, t.end - from);
    line.tokens.push_back(t);
    return t.end;
}

bool Scanner::scan(Line& line, std::uint32_t from, std::uint32_t to) {
    while (from < to) {
        const char c = text_[from];
        if (base::is_blank(c) || c == '\r') {
            ++from;
        } else if (c == '$') {
            if (from + 1 >= to || text_[from + 1] != '$') return true;  // what stands behind it is a note
            line.comment = text_.substr(from + 2, to - from - 2);
            return false;
        } else if (c == '\'' || c == '"') {
            const std::uint32_t close = static_cast<std::uint32_t>(std::min<std::size_t>(text_.find(c, from + 1), to));
            line.tokens.push_back(
                {TokenKind::text, from, std::min(close + 1, to), {}, text_.substr(from + 1, close - from - 1)});
            from = std::min(close + 1, to);
        } else {
            from = scan_number_or_word(line, from, to);
        }
        line.end = std::max(line.end, line.tokens.empty() ? line.begin : line.tokens.back().end);
        if (line.tokens.size() > Line::most_tokens) line.too_long = true, line.tokens.pop_back();
    }
    return false;
}

void Scanner::go_on_with_comment(Line& line) {
    if (!line.comment.starts_with("->")) return;
    while (line.comment.ends_with('$') && at_ < text_.size()) {
        const std::string_view next = base::trim(text_.substr(at_, body_end(at_) - at_));
        const std::string_view digits = next.substr(next.starts_with('-') || next.starts_with('+') ? 1 : 0);
        if (digits.empty() || !(base::is_digit(digits[0]) || digits[0] == '.')) return;
        const auto begin = static_cast<std::uint32_t>(line.comment.data() - text_.data());
        line.comment = text_.substr(begin, body_end(at_) - begin);
        at_ = std::min<std::uint32_t>(line_end(at_) + 1, static_cast<std::uint32_t>(text_.size()));
    }
}

bool Scanner::next(Line& line) {
    line.tokens.clear();
    line.comment = {};
    line.unended = line.too_long = false;
    while (at_ < text_.size() && (base::is_blank(text_[at_]) || text_[at_] == '\r' || text_[at_] == '\n')) ++at_;
    if (at_ >= text_.size()) return false;
    line.begin = line.end = at_;
    for (;;) {
        const bool goes_on = scan(line, at_, body_end(at_));
        at_ = std::min<std::uint32_t>(line_end(at_) + 1, static_cast<std::uint32_t>(text_.size()));
        if (!goes_on) return go_on_with_comment(line), true;
        if (at_ >= text_.size()) {
            line.unended = true;
            return true;
        }
    }
}

}  // namespace obrys::read::apt
