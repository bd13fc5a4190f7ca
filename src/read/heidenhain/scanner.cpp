#include "read/heidenhain/scanner.hpp"

#include <limits>
#include <string>
#include <system_error>

#include "base/float_chars.hpp"

namespace obrys::read::heidenhain {

namespace {

/// A carriage return alone ends a line only in texts that know no other line end; else it is dirt inside a line.
bool is_line_end(const char* p, bool cr_alone) { return *p == '\n' || (*p == '\r' && (cr_alone || p[1] == '\n')); }
/// Blank, or what editors of old leave at the end of a text.
bool is_empty(char c) { return base::is_blank(c) || c == '\r' || c == '\x1A' || c == '\0'; }

/// The nearest double; infinite where the number is too large for one.
double nearest(const std::string& text) {
    double value = 0;
    const auto [end, error] = base::from_chars(text.data(), text.data() + text.size(), value);
    if (error == std::errc{}) return value;
    const auto e = text.find('E');
    const bool small = e != std::string::npos && e + 1 < text.size() && text[e + 1] == '-';
    return small || text.find_first_of("123456789") == std::string::npos ? 0 : std::numeric_limits<double>::infinity();
}

}  // namespace

Scanner::Scanner(std::string_view text, bool star_ends)
    : base_(text.data()),
      p_(text.data()),
      end_(text.data() + base::without_end_signs(text).size()),
      cr_alone_(text.find('\n') == std::string_view::npos),
      star_ends_(star_ends) {}

const char* Scanner::line_end(const char* from) const {
    while (from < end_ && !is_line_end(from, cr_alone_)) ++from;
    return from;
}

bool Scanner::next_line() {
    while (p_ < end_ && (is_line_end(p_, cr_alone_) || is_empty(*p_))) ++p_;
    return p_ < end_;
}

void Scanner::skip_blanks() {
    while (p_ < end_) {
        if (base::is_blank(*p_) || (*p_ == '\r' && !is_line_end(p_, cr_alone_))) {
            ++p_;
            continue;
        }
        if (*p_ != '~') return;
        const char* q = p_ + 1;
        while (q < end_ && base::is_blank(*q)) ++q;
        if (q < end_ && !is_line_end(q, cr_alone_)) return;
        while (q < end_ && is_line_end(q, cr_alone_)) ++q;
        p_ = q;
    }
}

bool Scanner::at_star() const {
    if (!star_ends_ || peek() != '*') return false;
    const char* q = p_ + 1;
    while (q < end_ && base::is_blank(*q)) ++q;
    if (q >= end_ || is_line_end(q, cr_alone_) || std::string_view(";%").find(*q) != std::string_view::npos)
        return true;
    return base::upper(*q) == 'N' && q + 1 < end_ && base::is_digit(q[1]);
}

bool Scanner::at_end() {
    for (;;) {
        skip_blanks();
        if (p_ == end_ || is_line_end(p_, cr_alone_) || at_star()) return true;
        if (*p_ != ';') return false;
        const char* end = line_end(p_);
        const char* last = end;
        while (last > p_ && base::is_blank(last[-1])) --last;
        if (last[-1] != '~') return true;
        while (end < end_ && is_line_end(end, cr_alone_)) ++end;
        p_ = end;
    }
}

void Scanner::skip_comment() {
    for (;;) {
        const char* end = line_end(p_);
        const char* last = end;
        while (last > p_ && base::is_blank(last[-1])) --last;
        const bool goes_on = last > p_ && last[-1] == '~';
        p_ = end;
        if (!goes_on) return;
        while (p_ < end_ && is_line_end(p_, cr_alone_)) ++p_;
    }
}

void Scanner::skip_block() {
    while (!at_end()) ++p_;
    if (!star_ends_) p_ = line_end(p_);
}

void Scanner::leave_block() {
    skip_block();
    if (at_star()) {
        while (p_ < end_ && (base::is_blank(*p_) || *p_ == '*')) ++p_;
        if (base::upper(peek()) == 'N' || peek() == '%') return;
    }
    p_ = line_end(p_);
}

std::string_view Scanner::rest_of_line() {
    const char* from = p_;
    p_ = line_end(p_);
    return {from, static_cast<std::size_t>(p_ - from)};
}

bool Scanner::take(char c) {
    skip_blanks();
    if (peek() != c) return false;
    ++p_;
    return true;
}

bool Scanner::take_prefix(std::string_view upper) {
    skip_blanks();
    if (static_cast<std::size_t>(end_ - p_) < upper.size()) return false;
    for (std::size_t i = 0; i < upper.size(); ++i)
        if (base::upper(p_[i]) != upper[i]) return false;
    p_ += upper.size();
    return true;
}

bool Scanner::take_word(std::string_view upper) {
    const char* before = p_;
    if (take_prefix(upper) && !base::is_letter(peek())) return true;
    p_ = before;
    return false;
}

std::string_view Scanner::letters() const {
    const char* q = p_;
    while (q < end_ && base::is_letter(*q)) ++q;
    return {p_, static_cast<std::size_t>(q - p_)};
}

std::string_view Scanner::token() {
    skip_blanks();
    const char* from = p_;
    while (p_ < end_ && !is_line_end(p_, cr_alone_) && !base::is_blank(*p_) && *p_ != ';') ++p_;
    return {from, static_cast<std::size_t>(p_ - from)};
}

std::string_view Scanner::path() {
    std::string_view all = token();
    all = all.substr(0, all.find('*'));
    p_ = all.data() + all.size();
    return all;
}

int Scanner::integer() {
    const char* from = p_;
    int n = 0;
    for (; p_ < end_ && base::is_digit(*p_); ++p_)
        if (p_ - from < 9) n = n * 10 + (*p_ - '0');
    return p_ == from || p_ - from > 9 ? -1 : n;
}

base::NumberScan Scanner::number() {
    base::NumberScan n;
    const char* from = p_;
    base::Decimal d;
    int digits = 0;
    const auto take_digits = [&] {
        for (; p_ < end_ && base::is_digit(*p_); ++p_, ++digits)
            if (digits < 18) d.mantissa = d.mantissa * 10 + (*p_ - '0');
    };
    take_digits();
    const bool point = (peek() == '.' || peek() == ',') && (digits > 0 || base::is_digit(peek(1)));
    if (point) {
        ++p_;
        const int before = digits;
        take_digits();
        d.decimals = digits - before;
    }
    if (digits == 0) return n;
    n.integer = !point;
    std::string text(from, p_);
    if (point) text[text.find_first_of(".,")] = '.';
    const char sign = peek(1);
    const bool exponent = base::upper(peek()) == 'E' &&
                          (base::is_digit(sign) || ((sign == '+' || sign == '-') && base::is_digit(peek(2))));
    if (exponent) {
        n.integer = false;
        const char* e = p_;
        p_ += 2;
        while (p_ < end_ && base::is_digit(*p_)) ++p_;
        text += 'E';
        text.append(e[1] == '+' ? e + 2 : e + 1, p_);
    } else if (digits <= 15 && d.decimals <= 9) {
        n.decimal = d;
    }
    if (text.ends_with('.')) text += '0';
    n.value = n.decimal && d.decimals == 0 ? static_cast<double>(d.mantissa) : nearest(text);
    n.length = static_cast<std::size_t>(p_ - from);
    return n;
}

std::string_view Scanner::comment() const {
    if (peek() != ';') return {};
    std::string_view c(p_ + 1, static_cast<std::size_t>(line_end(p_) - p_ - 1));
    return base::trim(c);
}

}  // namespace obrys::read::heidenhain#include "base/float_chars.hpp"

