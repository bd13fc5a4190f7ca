#pragma once
/// The tools that a program states itself (TOOL DEF, G99 T), for a job that lists none of that number.

#include <vector>

#include "base/diagnostic.hpp"
#include "program/unit.hpp"
#include "shop/tool.hpp"

namespace obrys::driver {

/// Those whose length and radius are numbers and the same wherever they are defined, mm; each with a note that it is
/// taken. Numbers of `listed` are left to it.
[[nodiscard]] std::vector<shop::Tool> program_tools(const program::Unit& unit, const std::vector<shop::Tool>& listed,
                                                    base::Diagnostics& diagnostics);

}  // namespace obrys::driver
