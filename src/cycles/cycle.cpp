#include "cycles/cycle.hpp"

#include <algorithm>

namespace obrys::cycles {

std::optional<double> Demand::find(cl::CycleRole role) const {
    const auto found =
        std::find_if(values.rbegin(), values.rend(), [role](const cl::CycleValue& v) { return v.role == role; });
    return found == values.rend() ? std::nullopt : std::optional(found->value);
}

}  // namespace obrys::cycles
