#pragma once
/// Numbers as most words of NC programs hold them, read in one go: at most nine digits, so that the mantissa fits 32
/// bits.

#include <cstddef>
#include <cstdint>

#include "base/text.hpp"

namespace obrys::base {

struct ShortNumber {
    std::int32_t mantissa = 0;
    std::uint32_t decimals = 0;
    const char* end = nullptr;  ///< behind it; null where there is no number, or one with more digits
};

/// `digits [. digits]` at `p`, with a point or, where `comma` is set, a comma. A byte that is no digit must stand
/// behind the text (a NUL does).
[[nodiscard]] inline ShortNumber scan_short_digits(const char* p, bool comma) {
    ShortNumber n;
    std::uint32_t value = 0;
    const char* begin = p;
    for (; is_digit(*p); ++p) value = value * 10 + static_cast<std::uint32_t>(*p - '0');
    if (*p == '.' || (comma && *p == ',')) {
        const char* point = p++;
        for (; is_digit(*p); ++p) value = value * 10 + static_cast<std::uint32_t>(*p - '0');
        n.decimals = static_cast<std::uint32_t>(p - point - 1);
        ++begin;  // so that digits alone are counted
    }
    constexpr std::size_t most = 9;
    if (const auto digits = static_cast<std::size_t>(p - begin); digits - 1 >= most) return n;
    n.mantissa = static_cast<std::int32_t>(value);
    n.end = p;
    return n;
}

/// `[+-] digits [. digits]`, as above.
[[nodiscard]] inline ShortNumber scan_short_number(const char* p, bool comma) {
    const bool negative = *p == '-';
    ShortNumber n = scan_short_digits(negative || *p == '+' ? p + 1 : p, comma);
    if (negative) n.mantissa = -n.mantissa;
    return n;
}

}  // namespace obrys::base
