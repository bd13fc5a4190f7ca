#include "base/float_chars.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <string>

#include "base/text.hpp"

namespace obrys::base::by_c {

namespace {

const char* behind_digits(const char* at, const char* last) { return std::find_if_not(at, last, is_digit); }

/// One past the number that begins at `first`; `first` where none does.
const char* end_of_number(const char* first, const char* last, CharsFormat format) {
    const char* at = first;
    if (at != last && *at == '-') ++at;
    const char* const whole = at;
    at = behind_digits(at, last);
    std::ptrdiff_t digits = at - whole;
    if (at != last && *at == '.') {
        const char* const fraction = at + 1;
        const char* const end = behind_digits(fraction, last);
        digits += end - fraction;
        if (digits > 0) at = end;
    }
    if (digits == 0) return first;
    if (format == CharsFormat::fixed || at == last || (*at != 'e' && *at != 'E')) return at;
    const char* exponent = at + 1;
    if (exponent != last && (*exponent == '+' || *exponent == '-')) ++exponent;
    const char* const end = behind_digits(exponent, last);
    return end == exponent ? at : end;
}

ToChars put(char* first, char* last, const std::string& text) {
    if (last - first < static_cast<std::ptrdiff_t>(text.size())) return {last, std::errc::value_too_large};
    return {std::copy(text.begin(), text.end(), first), std::errc{}};
}

std::string printed(double value, const char* format, int precision) {
    std::string text(static_cast<std::size_t>(std::snprintf(nullptr, 0, format, precision, value)) + 1, '\0');
    static_cast<void>(std::snprintf(text.data(), text.size(), format, precision, value));
    text.pop_back();
    return text;
}

/// "1.25e+03" with the fewest digits that are read back as the same double.
std::string shortest_scientific(double value) {
    for (int digits = 0; digits < 16; ++digits) {
        std::string text = printed(value, "%.*e", digits);
        if (std::strtod(text.c_str(), nullptr) == value) return text;
    }
    return printed(value, "%.*e", 16);
}

/// The same digits without an exponent.
std::string without_exponent(const std::string& scientific) {
    const bool negative = scientific.front() == '-';
    const std::size_t e = scientific.find('e');
    std::string digits;
    for (std::size_t i = negative ? 1 : 0; i < e; ++i)
        if (scientific[i] != '.') digits += scientific[i];
    int exponent = 0;
    const char* const sign = scientific.data() + e + 1;
    static_cast<void>(std::from_chars(sign + 1, scientific.data() + scientific.size(), exponent));
    if (*sign == '-') exponent = -exponent;
    if (exponent < 0)
        digits = "0." + std::string(static_cast<std::size_t>(-exponent - 1), '0') + digits;
    else if (const auto whole = static_cast<std::size_t>(exponent) + 1; whole < digits.size())
        digits.insert(whole, ".");
    else
        digits.append(whole - digits.size(), '0');
    return (negative ? "-" : "") + digits;
}

std::string not_finite(double value) {
    return std::string(std::signbit(value) ? "-" : "") + (std::isnan(value) ? "nan" : "inf");
}

}  // namespace

FromChars from_chars(const char* first, const char* last, double& value, CharsFormat format) {
    const char* const end = end_of_number(first, last, format);
    if (end == first) return {first, std::errc::invalid_argument};
    const std::string text(first, end);
    const double read = std::strtod(text.c_str(), nullptr);
    const bool is_zero = text.find_first_of("123456789") >= text.find_first_of("eE");
    if (std::isinf(read) || (read == 0 && !is_zero)) return {end, std::errc::result_out_of_range};
    value = read;
    return {end, std::errc{}};
}

ToChars to_chars(char* first, char* last, double value, CharsFormat format, int precision) {
    if (!std::isfinite(value)) return put(first, last, not_finite(value));
    const char* const how = format == CharsFormat::fixed ? "%.*f" : format == CharsFormat::scientific ? "%.*e" : "%.*g";
    return put(first, last, printed(value, how, precision));
}

ToChars to_chars(char* first, char* last, double value, CharsFormat format) {
    if (!std::isfinite(value)) return put(first, last, not_finite(value));
    const std::string scientific = shortest_scientific(value);
    if (format == CharsFormat::scientific) return put(first, last, scientific);
    const std::string plain = without_exponent(scientific);
    const bool shorter = format == CharsFormat::general && scientific.size() < plain.size();
    return put(first, last, shorter ? scientific : plain);
}

}  // namespace obrys::base::by_c
