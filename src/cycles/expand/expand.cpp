#include "cycles/expand/expand.hpp"

#include "cycles/hole/hole.hpp"
#include "cycles/mill/mill.hpp"

namespace obrys::cycles {

bool is_expanded(cl::CycleKind kind) { return is_hole_cycle(kind) || is_mill_cycle(kind); }

std::span<const cl::CycleRole> roles_of(cl::CycleKind kind) {
    return is_mill_cycle(kind) ? roles_of_mill(kind) : roles_of_hole(kind);
}

Expansion expand(const Demand& demand, const Situation& situation) {
    return is_mill_cycle(demand.kind) ? expand_mill(demand, situation) : expand_hole(demand, situation);
}

}  // namespace obrys::cycles
