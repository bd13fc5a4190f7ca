#pragma once
/// Milling cycles that need nothing but their parameters: pockets, slots, studs, surfaces. A call is a struct of
/// figures.hpp, old_figures.hpp or surfaces.hpp, or the same by roles.

#include <span>

#include "cycles/cycle.hpp"

namespace obrys::cycles {

/// The kinds that `expand_mill` knows.
[[nodiscard]] bool is_mill_cycle(cl::CycleKind kind);
/// What a call of the kind can say, in the order in which it says it; nothing of another kind.
[[nodiscard]] std::span<const cl::CycleRole> roles_of_mill(cl::CycleKind kind);
/// As `expand` for them; another kind is not simulated. A struct goes in by `demand_of`.
[[nodiscard]] Expansion expand_mill(const Demand& demand, const Situation& situation);

}  // namespace obrys::cycles
