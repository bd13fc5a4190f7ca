#include "base/number.hpp"
#include "read/sinumerik/expression.hpp"

namespace obrys::read::sinumerik {

using program::Expr;
using program::ExprId;
using program::ExprKind;
using program::no_expr;

ExprId add_number(State& s, double value, bool integer, const char* from) {
    return s.build.number(value, integer, s.cursor.from(from), s.cursor.to(s.cursor.p));
}

ExprId add_text(State& s, std::string text, const char* from) {
    return s.build.text(std::move(text), s.cursor.from(from), s.cursor.to(s.cursor.p));
}

/// Hexadecimal and binary constants and single characters: 'H1F', 'B101', 'A'.
ExprId read_quoted_constant(State& s) {
    Cursor& c = s.cursor;
    const char* from = c.p;
    const char* close = from + 1;
    while (close < c.end && *close != '\'') ++close;
    if (close == c.end) {
        fail(s, from, c.end, "the apostrophe is not closed");
        return no_expr;
    }
    const std::string_view body(from + 1, static_cast<std::size_t>(close - from - 1));
    c.p = close + 1;
    const char kind = body.empty() ? '\0' : base::upper(body[0]);
    const double radix = kind == 'H' ? 16 : 2;
    bool good = body.size() > 1 && (kind == 'H' || kind == 'B');
    double value = 0;
    for (std::size_t i = 1; good && i < body.size(); ++i) {
        const char d = base::upper(body[i]);
        const int digit = base::is_digit(d) ? d - '0' : d >= 'A' && d <= 'F' ? d - 'A' + 10 : 99;
        good = digit < radix;
        value = value * radix + digit;
    }
    if (good && value < 4294967296.0) return add_number(s, value, true, from);
    const std::string text = base::as_utf8(body);
    if (base::character_count(text) == 1) return add_text(s, text, from);
    fail(s, from, c.p, "'" + text + "' is neither a hexadecimal nor a binary constant nor one character",
         "write 'H1F', 'B101' or 'A'");
    return no_expr;
}

ExprId read_string(State& s) {
    Cursor& c = s.cursor;
    const char* from = c.p;
    const char* close = from + 1;
    while (close < c.end && *close != '"') ++close;
    if (close == c.end) {
        fail(s, from, c.end, "the string is not closed", "add a quotation mark (\") at its end");
        return no_expr;
    }
    c.p = close + 1;
    return add_text(s, base::as_utf8({from + 1, static_cast<std::size_t>(close - from - 1)}), from);
}

Number read_number(State& s) {
    Cursor& c = s.cursor;
    const std::string_view rest(c.p, static_cast<std::size_t>(c.end - c.p));
    Number n;
    if (rest.empty() || rest[0] == '+' || rest[0] == '-') return n;
    const base::NumberScan scan = base::scan_decimal(rest);
    if (scan.length == 0) return n;
    n.found = true;
    n.value = scan.value;
    n.integer = scan.integer;
    if (scan.decimal) {
        n.plain = true;
        n.mantissa = scan.decimal->mantissa;
        n.decimals = scan.decimal->decimals;
    }
    std::size_t i = scan.length;
    const char* from = c.p;
    c.p += i;
    if (i + 2 >= rest.size() || base::upper(rest[i]) != 'E' || base::upper(rest[i + 1]) != 'X') return n;
    i += 2;
    const std::size_t sign = i;
    if (rest[i] == '+' || rest[i] == '-') ++i;
    if (i >= rest.size() || !base::is_digit(rest[i])) return n;
    while (i < rest.size() && base::is_digit(rest[i])) ++i;
    c.p = from + i;
    std::string text(rest.substr(0, scan.length));
    text += 'e';
    text += rest.substr(sign, i - sign).starts_with('+') ? rest.substr(sign + 1, i - sign - 1)
                                                         : rest.substr(sign, i - sign);
    const auto value = base::parse_double(text);
    n.plain = n.integer = false;
    n.value = value.value_or(0);
    if (!value) fail(s, from, c.p, "the number is out of range");
    return n;
}

ExprId read_text_literal(State& s, std::string_view text, const char* from, const char* to) {
    const char* back = s.cursor.p;
    s.cursor.p = to;
    const ExprId id = add_text(s, std::string(text), from);
    s.cursor.p = back;
    return id;
}

}  // namespace obrys::read::sinumerik
