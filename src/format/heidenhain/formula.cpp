/// Formulas `Q1 = …` and FN functions.

#include <array>

#include "base/number.hpp"
#include "base/text.hpp"
#include "format/heidenhain/structure.hpp"

namespace obrys::format::heidenhain {

namespace {

// Longer names before their beginnings.
constexpr std::array<std::string_view, 17> functions{"SQRT", "SQ",  "ASIN", "ACOS", "ATAN", "SIN", "COS", "TAN", "LN",
                                                     "LOG",  "EXP", "INT",  "ABS",  "FRAC", "SGN", "NEG", "PI"};

bool formula_token(Scan& in, std::string& token) {
    if (in.parameter(token) || in.number(token) || in.text(token)) return true;
    if (in.peek() == '|' && in.peek(1) == '|') {
        token = "||";
        in.step(2);
        return true;
    }
    if (in.peek() != '\0' && std::string_view("+-*/%^()=").find(in.peek()) != std::string_view::npos) {
        token = in.peek();
        in.step();
        return true;
    }
    const std::string word = in.letters();
    for (const std::string_view f : functions)
        if (word == f) {
            token = f;
            in.step(f.size());
            return true;
        }
    return false;
}

}  // namespace

bool formula_words(Scan& in, std::string& out) {
    while (!in.at_end()) {
        std::string token;
        if (!formula_token(in, token)) return false;
        append_word(out, token);
    }
    return true;
}

namespace {

/// `=` with a blank on both sides; LBL and what it names with one between.
std::string spaced(const std::string& code) {
    std::string out;
    bool inside = false;
    for (std::size_t i = 0; i < code.size(); ++i) {
        const char c = code[i];
        if (c == '"') inside = !inside;
        if (inside || c != '=') {
            out += c;
        } else {
            if (!out.ends_with(' ')) out += ' ';
            out += '=';
            if (i + 1 < code.size() && code[i + 1] != ' ') out += ' ';
        }
        const std::size_t n = out.size();
        const bool label = !inside && n >= 4 && (base::is_digit(c) || c == '"') && out.compare(n - 4, 3, "LBL") == 0;
        if (label) out.insert(n - 1, " ");
    }
    return out;
}

}  // namespace

std::optional<std::string> function_block(Scan& in, Decimal decimal) {
    std::string number;
    in.skip_blanks();
    while (base::is_digit(in.peek())) number += in.peek(), in.step();
    if (number.empty() || number.size() > 2 || !in.take(':')) return std::nullopt;
    const auto n = static_cast<int>(base::parse_integer(number).value_or(0));
    in.skip_blanks();
    std::string out = "FN " + std::to_string(n) + ":";
    const bool words_only = n <= 14 || n == 18 || n == 19;
    if (!words_only) {  // masks, tables, files, messages
        const auto rest = collapsed(in.rest(), false);
        if (!rest) return std::nullopt;
        append_word(out, *rest);
        return out;
    }
    const auto rest = collapsed(in.rest(), true);
    if (!rest || rest->find('~') != std::string::npos) return std::nullopt;
    append_word(out, with_decimals(spaced(*rest), decimal));
    return out;
}

}  // namespace obrys::format::heidenhain
