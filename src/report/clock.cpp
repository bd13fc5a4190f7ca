#include "report/clock.hpp"

#include <cmath>

#include "base/number.hpp"

namespace obrys::report {

std::string clock(double seconds) {
    if (!std::isfinite(seconds)) return "?";
    const double whole = std::floor(seconds + 0.5), hours = std::floor(whole / 3600),
                 minutes = std::floor((whole - 3600 * hours) / 60);
    return base::fixed(hours, 0) + " h " + base::fixed(minutes, 0) + " min " +
           base::fixed(whole - 3600 * hours - 60 * minutes, 0) + " s";
}

}  // namespace obrys::report
