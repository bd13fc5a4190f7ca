#pragma once
/// What findings most likely come from, where the program shows it: their remedies say so.

#include <memory>
#include <vector>

#include "base/source.hpp"
#include "check/result.hpp"
#include "interp/interp.hpp"
#include "program/unit.hpp"

namespace obrys::driver {

/// Where a program writes most lengths with a point, a finding at a block with one that is read in increments as less
/// than 1 mm asks for it.
void ask_for_points(const std::vector<std::shared_ptr<const program::Unit>>& units, const base::Sources& sources,
                    check::Result& result);

/// Findings under a radius compensation that a tool change did not end name where it began.
void name_carried_compensation(const interp::Outcome& outcome, check::Result& result);

}  // namespace obrys::driver
