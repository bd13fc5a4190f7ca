#pragma once
/// How a control wants its numbers written.

#include <optional>
#include <string>

namespace obrys::write {

struct NumberStyle {
    int decimals = 3;        ///< at most; zeros at the end are left out
    int least = 0;           ///< decimals that are always there: "10.0"
    bool point = false;      ///< also behind whole numbers: "10."
    int digits = 1;          ///< before the point, at least
    bool plus = false;       ///< "+10"
    double factor = 1;       ///< what is written is the value times this
    double most = 99999.0;   ///< largest amount that the word can hold, as written
    bool exact = false;      ///< a number with more decimals than these is refused, not rounded
    std::string at_rapid{};  ///< what stands for an infinite value ("MAX"); empty: it cannot be written
};

/// The value that the written number stands for.
[[nodiscard]] double as_written(double value, const NumberStyle& style);

/// Appends the number; false, and nothing is appended, where the word cannot hold it.
[[nodiscard]] bool append_number(std::string& out, double value, const NumberStyle& style);

}  // namespace obrys::write
