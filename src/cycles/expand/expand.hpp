#pragma once
/// One door to the cycles that need nothing but their parameters, at a hole or of a given figure.

#include <span>

#include "cycles/cycle.hpp"

namespace obrys::cycles {

/// True for cycles that `expand` knows.
[[nodiscard]] bool is_expanded(cl::CycleKind kind);

/// What a call of such a kind can say; nothing of another kind.
[[nodiscard]] std::span<const cl::CycleRole> roles_of(cl::CycleKind kind);

/// The steps from the called position on. A fatal complaint leaves `steps` empty. The feed in force afterwards is the
/// last Feed step; the caller restores its own where the control does.
[[nodiscard]] Expansion expand(const Demand& demand, const Situation& situation);

}  // namespace obrys::cycles
