#pragma once
/// Cycles at one hole: drilling, boring, tapping, thread milling, and the canned cycles of RS-274 controls.

#include "cycles/cycle.hpp"

namespace obrys::cycles {

/// The kinds that `expand_hole` knows.
[[nodiscard]] bool is_hole_cycle(cl::CycleKind kind);
/// As `expand` for them; another kind is not simulated.
[[nodiscard]] Expansion expand_hole(const Demand& demand, const Situation& situation);

}  // namespace obrys::cycles
