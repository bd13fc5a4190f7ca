#pragma once
/// Reading and printing numbers, always with a decimal point, never by the locale.

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace obrys::base {

/// A decimal as written: `mantissa / 10^decimals`, exact. What NC words hold: optional sign, digits, point, digits.
struct Decimal {
    std::int64_t mantissa = 0;
    int decimals = 0;
};

/// Result of reading a number at the start of a text: how many bytes it took; 0 where there is none.
struct NumberScan {
    double value = 0;
    std::size_t length = 0;
    bool integer = false;            ///< written without point and exponent
    std::optional<Decimal> decimal;  ///< set where mantissa and decimals fit (at most 18 digits)
};

/// Reads `[+-] digits [. digits]`, also `.5` and `5.`. The value is the nearest double. No exponent.
[[nodiscard]] NumberScan scan_decimal(std::string_view s);
/// The whole text as a number (exponent allowed), blanks around it ignored; nothing otherwise.
[[nodiscard]] std::optional<double> parse_double(std::string_view s);
[[nodiscard]] std::optional<std::int64_t> parse_integer(std::string_view s);

/// Fixed decimals, rounded half to even on the exact value, without "-0".
[[nodiscard]] std::string fixed(double value, int decimals);
void append_fixed(std::string& out, double value, int decimals);
/// Shortest text that reads back to the same double, without exponent below 1e15, without "-0".
[[nodiscard]] std::string shortest(double value);

}  // namespace obrys::base
