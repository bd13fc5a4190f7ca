/// SPRINT: a text with % where values go (SINUMERIK Job Planning 10/2015, p. 92-94: %B %C %D %F %E %G %S %X).

#include <algorithm>
#include <charconv>
#include <cmath>
#include <optional>

#include "base/codes.hpp"
#include "base/float_chars.hpp"
#include "base/number.hpp"
#include "base/text.hpp"
#include "base/whole.hpp"
#include "interp/values/values.hpp"

namespace obrys::interp {

namespace codes = base::codes;

namespace {

struct TextFormat {
    std::size_t width = 0;
    std::optional<int> places;
    char letter = 0;
};

std::size_t read_digits(std::string_view text, std::size_t& at) {
    std::size_t n = 0;
    for (; at < text.size() && base::is_digit(text[at]); ++at)
        n = std::min<std::size_t>(n * 10 + static_cast<std::size_t>(text[at] - '0'), 1000);
    return n;
}

/// What stands behind `%`; `at` is moved behind it.
TextFormat read_text_format(std::string_view text, std::size_t& at) {
    TextFormat f;
    f.width = read_digits(text, at);
    if (at < text.size() && text[at] == '.') {
        ++at;
        f.places = static_cast<int>(std::min<std::size_t>(read_digits(text, at), 15));
    }
    if (at < text.size()) f.letter = base::upper(text[at++]);
    return f;
}

/// 1.234568EX+03
std::string exponential(double v, int places) {
    char buffer[64];
    const auto end = base::to_chars(buffer, buffer + sizeof buffer, v, base::CharsFormat::scientific, places).ptr;
    std::string s(buffer, end);
    if (const auto e = s.find('e'); e != std::string::npos) s.replace(e, 1, "EX");
    return s;
}

std::string general(double v, int places) {
    const int exponent = v == 0 ? 0 : base::clipped<int>(std::floor(std::log10(std::abs(v))), -400, 400);
    return exponent < -4 || exponent >= places ? exponential(v, std::max(places - 1, 0))
                                               : base::fixed(v, std::clamp(places - 1 - exponent, 0, 15));
}

std::string hexadecimal(double v) {
    char buffer[32];
    const auto end = std::to_chars(buffer, buffer + sizeof buffer,
                                   static_cast<std::uint32_t>(base::cut<std::int64_t>(v).value_or(0)), 16)
                         .ptr;
    return base::to_upper({buffer, static_cast<std::size_t>(end - buffer)});
}

/// The value as the format says; nothing where they do not fit.
std::optional<std::string> formatted(const TextFormat& f, const Value& v) {
    if (f.letter == 'S') return f.places ? printed(v).substr(0, static_cast<std::size_t>(*f.places)) : printed(v);
    if (v.is_unknown()) return "?";
    if (f.letter == 'B')
        return v.is_text() ? (v.as_text().empty() ? "FALSE" : "TRUE") : v.number != 0 ? "TRUE" : "FALSE";
    if (f.letter == 'C' && v.is_text()) return v.as_text().substr(0, 1);
    if (!v.is_number() || !(std::abs(v.number) < 9e18)) return std::nullopt;
    switch (f.letter) {
        case 'C': return std::string(1, static_cast<char>(base::cut<std::int64_t>(v.number).value_or(0) & 0xFF));
        case 'D': return base::fixed(std::floor(v.number + 0.5), 0);
        case 'F': return base::fixed(v.number, f.places.value_or(6));
        case 'E': return exponential(v.number, f.places.value_or(6));
        case 'G': return general(v.number, f.places.value_or(6));
        case 'X': return hexadecimal(v.number);
        default: return std::nullopt;
    }
}

}  // namespace

Value format_text(Reckoning& run, const program::Expr& e) {
    const auto argument = [&](std::size_t i) {
        const ExprId id = i < e.count ? run.unit().children[e.b + i] : program::no_expr;
        return id == program::no_expr ? Value::string({}) : evaluate(run, id);
    };
    const base::Span where{run.unit().file, e.begin, e.end};
    const std::string text = printed(argument(0));
    std::string out;
    std::size_t next = 1;
    for (std::size_t at = 0; at < text.size() && !run.stopped;) {
        if (text[at] != '%') {
            out += text[at++];
            continue;
        }
        const TextFormat f = read_text_format(text, ++at);
        if (f.letter == '%') {
            out += '%';
            continue;
        }
        const auto value = next < e.count ? formatted(f, argument(next)) : std::nullopt;
        ++next;
        if (!value) {
            alarm(run, codes::bad_argument, where,
                  std::string("SPRINT: %") + f.letter + " and its value do not fit together, or the value is missing");
            return {};
        }
        out += std::string(f.width > value->size() ? f.width - value->size() : 0, ' ') + *value;
    }
    return Value::string(std::move(out));
}

}  // namespace obrys::interp
