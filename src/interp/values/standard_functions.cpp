/// M functions that the control itself knows.

#include <algorithm>

#include "interp/values/values.hpp"

namespace obrys::interp {

bool is_own_function(const Saying& run, int m) {
    const auto own = run.traits->own_functions;
    return std::find(own.begin(), own.end(), m) != own.end();
}

bool is_standard_function(const Saying& run, int m) {
    return is_own_function(run, m) || (m >= 0 && m <= 9) || m == 17 || m == 30 || m == 19 || (m >= 40 && m <= 45);
}

}  // namespace obrys::interp
