#pragma once
/// Findings at blocks with a number that may lack its decimal point.

#include <memory>
#include <vector>

#include "base/source.hpp"
#include "check/result.hpp"
#include "program/unit.hpp"

namespace obrys::driver {

/// Where a program writes most lengths with a point, a finding at a block with one that is read in increments as less
/// than 1 mm asks for it.
void ask_for_points(const std::vector<std::unique_ptr<program::Unit>>& units, const base::Sources& sources,
                    check::Result& result);

}  // namespace obrys::driver
