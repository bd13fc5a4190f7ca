#pragma once
/// What a length in a job file or a tool file may be.

#include <cmath>
#include <string>

#include "base/number.hpp"

namespace obrys::shop {

inline constexpr double largest_size = 1e6, smallest_size = 1e-6;  ///< mm
inline constexpr double largest_radius = 1e5;                      ///< mm

/// Why a length cannot be one, or nothing. `radius`: of a tool; 0 says that nothing was entered.
[[nodiscard]] inline std::string size_problem(double value, bool radius) {
    if (!std::isfinite(value)) return "must be a finite number";
    const double largest = radius ? largest_radius : largest_size;
    if (std::abs(value) > largest) return "is too large: at most " + base::shortest(largest);
    if (radius && value != 0 && std::abs(value) < smallest_size)
        return "is too small: at least " + base::fixed(smallest_size, 6);
    return {};
}

}  // namespace obrys::shop
