#pragma once
/// Milling cycles of a given figure: pockets, slots, studs, and surfaces line by line.

#include "cycles/cycle.hpp"

namespace obrys::cycles {

/// The kinds that `expand_mill` knows.
[[nodiscard]] bool is_mill_cycle(cl::CycleKind kind);
/// As `expand` for them; another kind is not simulated.
[[nodiscard]] Expansion expand_mill(const Demand& demand, const Situation& situation);

}  // namespace obrys::cycles
