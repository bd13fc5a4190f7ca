#pragma once
/// Parameters and cycles in words, for complaints and brackets.

#include <string_view>

#include "cl/cycle.hpp"

namespace obrys::cycles {

/// In words a programmer of any control knows: "set-up clearance", "plunging depth".
[[nodiscard]] std::string_view name(cl::CycleRole role);

}  // namespace obrys::cycles
