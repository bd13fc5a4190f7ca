#include "cycles/mill/mill.hpp"

#include "cycles/mill/families.hpp"

namespace obrys::cycles {

namespace {

Family mill_family_of(Kind kind) {
    switch (kind) {
        case Kind::rectangular_pocket:
        case Kind::circular_pocket:
        case Kind::rectangular_pocket_simple:
        case Kind::circular_pocket_simple: return expand_pocket;
        case Kind::slot:
        case Kind::round_slot:
        case Kind::slot_reciprocating:
        case Kind::round_slot_reciprocating: return expand_slot;
        case Kind::rectangular_stud:
        case Kind::circular_stud: return expand_stud;
        case Kind::rectangular_pocket_finish:
        case Kind::rectangular_stud_finish:
        case Kind::circular_pocket_finish:
        case Kind::circular_stud_finish: return expand_finish;
        case Kind::multipass:
        case Kind::ruled_surface:
        case Kind::face_mill: return expand_surface;
        default: return nullptr;
    }
}

/// Where the tool stands in the plane does not matter: the cycle says its place itself, and goes there first.
bool goes_by_itself(const Demand& demand, Family family) {
    if (family == &expand_surface) return true;
    const bool bent = demand.kind == Kind::round_slot && demand.get(cl::CycleRole::position, 0) == 0;
    const bool at_centre = bent || family == &expand_finish || demand.kind == Kind::slot_reciprocating ||
                           demand.kind == Kind::round_slot_reciprocating;
    return at_centre && demand.find(cl::CycleRole::centre_u) && demand.find(cl::CycleRole::centre_v);
}

}  // namespace

bool is_mill_cycle(Kind kind) { return mill_family_of(kind) != nullptr; }

Expansion expand_mill(const Demand& demand, const Situation& situation) {
    const Family family = mill_family_of(demand.kind);
    return expand_by(family, demand, situation, goes_by_itself(demand, family));
}

}  // namespace obrys::cycles
