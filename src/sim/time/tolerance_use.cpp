#include "sim/time/tolerance_use.hpp"

#include <algorithm>
#include <cmath>

namespace obrys::sim::time {
namespace {

constexpr int first_class = -40;  ///< half doublings: 2^-20 mm

}  // namespace

void ToleranceUse::take(double chord_error) {
    ++places;
    if (chord_error > tolerance) ++coarse;
    int exponent = 0;
    const double mantissa = std::frexp(chord_error, &exponent);  // mantissa 0.5 … 1
    const int half = 2 * exponent - (mantissa < 0.70710678118654752 ? 1 : 0);
    ++errors[static_cast<std::size_t>(std::clamp(half - first_class, 0, static_cast<int>(errors.size()) - 1))];
}

double ToleranceUse::error_of(double share) const {
    const double wanted = share * static_cast<double>(places);
    double count = 0;
    for (std::size_t i = 0; i < errors.size(); ++i) {
        count += errors[i];
        if (count >= wanted && count > 0) return std::exp2((static_cast<int>(i) + first_class) / 2.0);
    }
    return 0;
}

}  // namespace obrys::sim::time
