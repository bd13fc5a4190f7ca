#pragma once
/// How a control wants its numbers written.

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "cl/cycle.hpp"
#include "write/values.hpp"

namespace obrys::write {

struct NumberStyle {
    int decimals = 3;            ///< at most; zeros at the end are left out
    int least = 0;               ///< decimals that are always there: "10.0"
    bool point = false;          ///< also behind whole numbers: "10."
    int digits = 1;              ///< before the point, at least
    bool plus = false;           ///< "+10"
    double factor = 1;           ///< what is written is the value times this
    double most = 99999.0;       ///< largest amount that the word can hold, as written
    bool of_increments = false;  ///< its decimals are those of the control's least input increment
    bool exact = false;          ///< a number with more decimals than these is refused, not rounded
    std::string at_rapid{};      ///< what stands for an infinite value ("MAX"); empty: it cannot be written
};

/// Styles that values have where a template names none, by their names in [numbers].
inline constexpr std::array<std::string_view, 7> usual_styles{"length",  "angle", "feed",  "speed",
                                                              "seconds", "whole", "factor"};
enum class Usual : std::uint8_t { length, angle, feed, speed, seconds, whole, factor };
[[nodiscard]] Usual usual_style(Value v);
[[nodiscard]] Usual usual_style(cl::CycleRole role);

/// The value that the written number stands for.
[[nodiscard]] double as_written(double value, const NumberStyle& style);

/// Appends the number; false, and nothing is appended, where the word cannot hold it.
[[nodiscard]] bool append_number(std::string& out, double value, const NumberStyle& style);

}  // namespace obrys::write
