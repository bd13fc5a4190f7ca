#pragma once
/// From a double to a whole number, checked. The only way there: a cast of a double that does not fit its target is
/// undefined, and what a file or a program says may be 1e300 or unknown (NaN). The test `house.casts` holds every
/// folder to it.

#include <cstdint>
#include <limits>
#include <optional>
#include <type_traits>
#include <utility>

namespace obrys::base {

// For GCC and Clang alone: other compilers have no such sanitizer, and not this way of saying it.
#if defined(__GNUC__) || defined(__clang__)
#define OBRYS_NO_CAST_CHECK __attribute__((no_sanitize("float-cast-overflow")))
#else
#define OBRYS_NO_CAST_CHECK
#endif

namespace detail {
/// True where the cast below is defined; false for NaN.
[[nodiscard]] constexpr bool fits_int64(double v) { return v >= -9223372036854775808.0 && v < 9223372036854775808.0; }

/// Of values that fit only: nothing is left for the sanitizer to look at.
[[nodiscard]] OBRYS_NO_CAST_CHECK constexpr std::int64_t as_int64(double v) { return static_cast<std::int64_t>(v); }
}  // namespace detail
#undef OBRYS_NO_CAST_CHECK

/// The value cut toward zero; nothing where it is NaN or lies outside `least` to `most` (both included).
template <class T>
[[nodiscard]] constexpr std::optional<T> cut(double v, T least = std::numeric_limits<T>::min(),
                                             T most = std::numeric_limits<T>::max()) {
    static_assert(std::is_integral_v<T> && !std::is_same_v<T, bool>);
    if (!detail::fits_int64(v)) return std::nullopt;
    const std::int64_t n = detail::as_int64(v);
    // Characters are compared as numbers.
    using Wide = std::conditional_t<std::is_signed_v<T>, std::int64_t, std::uint64_t>;
    if (std::cmp_less(n, static_cast<Wide>(least)) || std::cmp_greater(n, static_cast<Wide>(most))) return std::nullopt;
    return static_cast<T>(n);
}

/// A value that is whole and lies within `least` to `most`; nothing otherwise.
template <class T>
[[nodiscard]] constexpr std::optional<T> whole(double v, T least = std::numeric_limits<T>::min(),
                                               T most = std::numeric_limits<T>::max()) {
    const std::optional<T> n = cut(v, least, most);
    return n && static_cast<double>(*n) == v ? n : std::nullopt;
}

/// The value cut toward zero, or the end of `least` to `most` that it lies beyond; `least` for NaN. For what is bounded
/// already and for shares of a picture or a grid; who reads a number that somebody wrote asks `cut` or `whole`.
template <class T>
[[nodiscard]] constexpr T clipped(double v, T least, T most) {
    if (const std::optional<T> n = cut(v, least, most)) return *n;
    return v > static_cast<double>(least) ? most : least;
}

}  // namespace obrys::base
