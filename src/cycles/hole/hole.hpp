#pragma once
/// Cycles at one hole: drilling, boring, tapping, thread milling. A call is a struct of between_planes.hpp,
/// below_surface.hpp, tapping_below_surface.hpp or thread_milling.hpp, or the same by roles.

#include <span>

#include "cycles/cycle.hpp"

namespace obrys::cycles {

/// The kinds that `expand_hole` knows.
[[nodiscard]] bool is_hole_cycle(cl::CycleKind kind);
/// What a call of the kind can say, in the order in which it says it; nothing of another kind.
[[nodiscard]] std::span<const cl::CycleRole> roles_of_hole(cl::CycleKind kind);
/// As `expand` for them; another kind is not simulated. A struct goes in by `demand_of`.
[[nodiscard]] Expansion expand_hole(const Demand& demand, const Situation& situation);

}  // namespace obrys::cycles
