#pragma once
/// Numbers as most words of NC programs hold them, read in one go: at most nine digits, so that the mantissa fits 32
/// bits.

#include <cstdint>

#include "base/text.hpp"

namespace obrys::base {

struct ShortNumber {
    std::int32_t mantissa = 0;
    std::uint32_t decimals = 0;
    const char* end = nullptr;  ///< behind it; null where there is no number, or one with more digits
};

/// `[+-] digits [. digits]` at `p`, with a point or, where `comma` is set, a comma. A byte that is no digit must stand
/// behind the text (a NUL does).
[[nodiscard]] inline ShortNumber scan_short_number(const char* p, bool comma) {
    ShortNumber n;
    const bool negative = *p == '-';
    if (negative || *p == '+') ++p;
    std::uint32_t value = 0;
    const char* begin = p;
    for (; is_digit(*p); ++p) value = value * 10 + static_cast<std::uint32_t>(*p - '0');
    auto digits = p - begin;
    if (*p == '.' || (comma && *p == ',')) {
        const char* point = p++;
        for (; is_digit(*p); ++p) value = value * 10 + static_cast<std::uint32_t>(*p - '0');
        n.decimals = static_cast<std::uint32_t>(p - point - 1);
        digits += p - point - 1;
    }
    if (digits == 0 || digits > 9) return n;
    n.mantissa = negative ? -static_cast<std::int32_t>(value) : static_cast<std::int32_t>(value);
    n.end = p;
    return n;
}

}  // namespace obrys::base
