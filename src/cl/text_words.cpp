#include "cl/text_words.hpp"

#include <limits>
#include <optional>

#include "base/number.hpp"

namespace obrys::cl {

double Words::number() {
    if (!ok()) return 0;
    const std::string_view w = word();
    // Nearly all are plain decimals.
    if (const base::NumberScan n = base::scan_decimal(w); n.decimal && n.length == w.size()) return n.value;
    if (w == "?") return std::numeric_limits<double>::quiet_NaN();
    if (w == "inf") return std::numeric_limits<double>::infinity();
    if (w == "-inf") return -std::numeric_limits<double>::infinity();
    const std::optional<double> value = base::parse_double(w);
    if (!value) fail("expected a number or ?");
    return value.value_or(0);
}

/// The character an escape stands for; `at_` is behind the backslash.
char Words::escape() {
    const char c = at_ < line_.size() ? line_[at_++] : '\0';
    if (c == '"' || c == '\\') return c;
    if (c == 'n') return '\n';
    unsigned value = 0;
    const char* first = line_.data() + at_;
    if (c == 'x' && at_ + 2 <= line_.size() && std::from_chars(first, first + 2, value, 16).ptr == first + 2) {
        at_ += 2;
        return static_cast<char>(value);
    }
    fail("unknown escape; known are \\\" \\\\ \\n \\xHH");
    return 0;
}

std::string Words::quoted() {
    std::string out;
    if (!ok()) return out;
    skip_blanks();
    begin_ = at_;
    if (at_ == line_.size() || line_[at_] != '"') {
        word();
        fail("expected a text in quotes");
        return out;
    }
    ++at_;
    while (ok() && at_ < line_.size() && line_[at_] != '"') {
        const char c = line_[at_++];
        out += c == '\\' ? escape() : c;
    }
    if (at_ == line_.size()) fail("the closing quote is missing");
    if (ok()) ++at_;
    return out;
}

}  // namespace obrys::cl
