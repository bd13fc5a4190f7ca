#pragma once
/// std::from_chars, std::to_chars of doubles and std::bit_cast, also where the standard library has none of them
/// (libc++ before 14, 20 and 14: emscripten of Debian 12). The rules are those of the standard: no locale, nearest
/// double, fewest digits that give the same double.

#include <charconv>
#include <system_error>
#include <type_traits>

namespace obrys::base {

enum class CharsFormat : std::uint8_t { fixed, scientific, general };

struct FromChars {
    const char* ptr = nullptr;
    std::errc ec{};
};
struct ToChars {
    char* ptr = nullptr;
    std::errc ec{};
};

/// By the functions of C; its locale must be "C", which it is until somebody sets another one. For the tests always
/// here.
namespace by_c {
[[nodiscard]] FromChars from_chars(const char* first, const char* last, double& value, CharsFormat format);
[[nodiscard]] ToChars to_chars(char* first, char* last, double value, CharsFormat format, int precision);
/// Fewest digits; `general`: whichever of the two forms is shorter, the plain one where they are alike.
[[nodiscard]] ToChars to_chars(char* first, char* last, double value, CharsFormat format);
}  // namespace by_c

#ifdef __cpp_lib_to_chars
[[nodiscard]] constexpr std::chars_format std_format(CharsFormat f) {
    return f == CharsFormat::fixed        ? std::chars_format::fixed
           : f == CharsFormat::scientific ? std::chars_format::scientific
                                          : std::chars_format::general;
}
#endif

/// As std::from_chars, of finite numbers alone: `value` is left as it is where there is none or it does not fit.
[[nodiscard]] inline FromChars from_chars(const char* first, const char* last, double& value,
                                          CharsFormat format = CharsFormat::general) {
#ifdef __cpp_lib_to_chars
    const char* const digit = first != last && *first == '-' ? first + 1 : first;
    if (digit != last && *digit != '.' && (*digit < '0' || *digit > '9')) return {first, std::errc::invalid_argument};
    const auto [ptr, ec] = std::from_chars(first, last, value, std_format(format));
    return {ptr, ec};
#else
    return by_c::from_chars(first, last, value, format);
#endif
}

[[nodiscard]] inline ToChars to_chars(char* first, char* last, double value, CharsFormat format, int precision) {
#ifdef __cpp_lib_to_chars
    const auto [ptr, ec] = std::to_chars(first, last, value, std_format(format), precision);
    return {ptr, ec};
#else
    return by_c::to_chars(first, last, value, format, precision);
#endif
}

[[nodiscard]] inline ToChars to_chars(char* first, char* last, double value,
                                      CharsFormat format = CharsFormat::general) {
#ifdef __cpp_lib_to_chars
    const auto [ptr, ec] = format == CharsFormat::general ? std::to_chars(first, last, value)
                                                          : std::to_chars(first, last, value, std_format(format));
    return {ptr, ec};
#else
    return by_c::to_chars(first, last, value, format);
#endif
}

template <class To, class From>
[[nodiscard]] constexpr To bit_cast(const From& from) {
    static_assert(sizeof(To) == sizeof(From) && std::is_trivially_copyable_v<To> && std::is_trivially_copyable_v<From>);
    return __builtin_bit_cast(To, from);
}

}  // namespace obrys::base
