#include "base/number.hpp"

#include <array>
#include <charconv>
#include <cmath>

#include "base/float_chars.hpp"
#include "base/text.hpp"
#include "base/whole.hpp"

namespace obrys::base {

namespace {
constexpr std::array<double, 19> power_of_ten{1e0,  1e1,  1e2,  1e3,  1e4,  1e5,  1e6,  1e7,  1e8, 1e9,
                                              1e10, 1e11, 1e12, 1e13, 1e14, 1e15, 1e16, 1e17, 1e18};
constexpr std::int64_t exact_in_double = std::int64_t{1} << 53;
}  // namespace

NumberScan scan_decimal(std::string_view s) {
    NumberScan scan;
    std::size_t i = 0;
    const bool negative = !s.empty() && s[0] == '-';
    if (!s.empty() && (s[0] == '-' || s[0] == '+')) ++i;
    const std::size_t first = i;
    std::int64_t mantissa = 0;
    std::size_t digits = 0;
    int decimals = 0;
    bool point = false, fits = true;
    for (; i < s.size(); ++i) {
        if (s[i] == '.' && !point) {
            point = true;
            continue;
        }
        if (!is_digit(s[i])) break;
        ++digits;
        fits = fits && mantissa < 100'000'000'000'000'000;  // one more digit stays below 1e18
        if (fits) mantissa = mantissa * 10 + (s[i] - '0');
        if (point) ++decimals;
    }
    if (digits == 0) return scan;
    scan.length = i;
    scan.integer = !point;
    if (fits && decimals <= 18) scan.decimal = Decimal{negative ? -mantissa : mantissa, decimals};
    if (fits && mantissa <= exact_in_double && decimals <= 18) {
        // Both operands are exact doubles, so one correctly rounded division gives the nearest double.
        const double magnitude = static_cast<double>(mantissa) / power_of_ten[static_cast<std::size_t>(decimals)];
        scan.value = negative ? -magnitude : magnitude;
    } else {
        double magnitude = 0;
        static_cast<void>(from_chars(s.data() + first, s.data() + i, magnitude, CharsFormat::fixed));
        scan.value = negative ? -magnitude : magnitude;
    }
    return scan;
}

std::optional<double> parse_double(std::string_view s) {
    s = trim(s);
    if (s.starts_with('+')) s.remove_prefix(1);
    double value = 0;
    const auto [end, error] = from_chars(s.data(), s.data() + s.size(), value);
    if (s.empty() || error != std::errc{} || end != s.data() + s.size() || !std::isfinite(value)) return std::nullopt;
    return value;
}

std::optional<std::int64_t> parse_integer(std::string_view s) {
    s = trim(s);
    if (s.starts_with('+')) s.remove_prefix(1);
    std::int64_t value = 0;
    const auto [end, error] = std::from_chars(s.data(), s.data() + s.size(), value);
    if (s.empty() || error != std::errc{} || end != s.data() + s.size()) return std::nullopt;
    return value;
}

namespace {

/// The decimal nearest to a value of moderate size, by whole numbers. False where the value lies so near to the middle
/// between two that the product's rounding could decide, and where it has too many digits.
bool append_fixed_by_integers(std::string& out, double value, int decimals) {
    if (decimals < 0 || decimals > 9) return false;
    const double scaled = std::abs(value) * power_of_ten[static_cast<std::size_t>(decimals)];
    const std::optional<std::uint32_t> below = cut<std::uint32_t>(scaled, 0, 1'000'000'000);
    if (!below) return false;
    const double rest = scaled - *below;  // wrong by 1.2e-7 at most, as the product is
    if (std::abs(rest - 0.5) < 1e-6) return false;
    const std::uint32_t digits = *below + (rest > 0.5 ? 1U : 0U);
    std::array<char, 16> buffer;
    char* const end = buffer.data() + buffer.size();
    char* at = end;
    std::uint32_t left = digits;
    for (int i = 0; i < decimals; ++i, left /= 10) *--at = static_cast<char>('0' + left % 10);
    if (decimals > 0) *--at = '.';
    do *--at = static_cast<char>('0' + left % 10);
    while ((left /= 10) != 0);
    if (digits != 0 && std::signbit(value)) *--at = '-';
    out.append(at, static_cast<std::size_t>(end - at));
    return true;
}

}  // namespace

void append_fixed(std::string& out, double value, int decimals) {
    if (append_fixed_by_integers(out, value, decimals)) return;
    std::array<char, 400> buffer;  // 1e308 with 17 decimals needs 327
    const auto [end, error] =
        to_chars(buffer.data(), buffer.data() + buffer.size(), value, CharsFormat::fixed, decimals);
    std::string_view text(buffer.data(), static_cast<std::size_t>(end - buffer.data()));
    if (error != std::errc{}) text = "nan";
    if (text.starts_with('-') && text.find_first_not_of("-0.") == std::string_view::npos) text.remove_prefix(1);
    out += text;
}

std::string fixed(double value, int decimals) {
    std::string out;
    append_fixed(out, value, decimals);
    return out;
}

std::string shortest(double value) {
    if (value == 0) return "0";
    std::array<char, 400> buffer;
    const bool plain = std::abs(value) < 1e15 && std::abs(value) > 1e-7;
    const auto [end, error] = plain ? to_chars(buffer.data(), buffer.data() + buffer.size(), value, CharsFormat::fixed)
                                    : to_chars(buffer.data(), buffer.data() + buffer.size(), value);
    if (error != std::errc{}) return "nan";
    return {buffer.data(), end};
}

}  // namespace obrys::base
