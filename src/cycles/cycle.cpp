#include "cycles/cycle.hpp"

#include <algorithm>

#include "cycles/course.hpp"
#include "cycles/pocket_data.hpp"

namespace obrys::cycles {

namespace {

using Family = void (*)(Course&, const Demand&, const Situation&);

/// The family that expands a kind; none for kinds that are no machining of their own or not simulated.
Family family_of(Kind kind) {
    switch (kind) {
        case Kind::peck:
        case Kind::drill:
        case Kind::universal_drill:
        case Kind::universal_peck:
        case Kind::centre:
        case Kind::single_lip: return expand_drill;
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
        case Kind::ream:
        case Kind::bore:
        case Kind::back_bore:
        case Kind::bore_mill: return expand_bore;
        case Kind::tap_floating_simple:
        case Kind::tap_floating:
        case Kind::tap_rigid_simple:
        case Kind::tap_rigid:
        case Kind::tap_chip_breaking:
        case Kind::thread_cut: return expand_tap;
        case Kind::thread_mill:
        case Kind::thread_mill_countersink:
        case Kind::thread_mill_drill:
        case Kind::thread_mill_helix:
        case Kind::thread_mill_outside: return expand_thread_mill;
        case Kind::multipass:
        case Kind::ruled_surface:
        case Kind::face_mill: return expand_surface;
        case Kind::canned_drill:
        case Kind::canned_chip_break:
        case Kind::canned_peck:
        case Kind::canned_tap_floating:
        case Kind::canned_tap_rigid:
        case Kind::canned_bore_feed:
        case Kind::canned_bore_stop:
        case Kind::canned_bore_orient:
        case Kind::canned_back_bore:
        case Kind::canned_bore_manual: return expand_canned;
        default: return nullptr;
    }
}

}  // namespace

namespace {

/// Where the tool stands in the plane does not matter: the cycle says its place itself, and goes there first.
bool goes_by_itself(const Demand& demand, Family family) {
    if (family == &expand_canned || family == &expand_surface) return true;
    const bool bent = demand.kind == Kind::round_slot && demand.get(cl::CycleRole::position, 0) == 0;
    const bool at_centre = bent || family == &expand_finish || demand.kind == Kind::slot_reciprocating ||
                           demand.kind == Kind::round_slot_reciprocating;
    return at_centre && demand.find(cl::CycleRole::centre_u) && demand.find(cl::CycleRole::centre_v);
}

}  // namespace

std::optional<double> Demand::find(cl::CycleRole role) const {
    const auto found =
        std::find_if(values.rbegin(), values.rend(), [role](const cl::CycleValue& v) { return v.role == role; });
    return found == values.rend() ? std::nullopt : std::optional(found->value);
}

bool is_expanded(Kind kind) { return family_of(kind) != nullptr; }

Expansion expand(const Demand& demand, const Situation& situation) {
    const Family family = family_of(demand.kind);
    if (family == nullptr) {
        Expansion e;
        e.simulated = false;
        e.complaints.push_back({false, "this cycle is not simulated", {}, std::nullopt});
        return e;
    }
    Course course(demand, situation, goes_by_itself(demand, family));
    family(course, demand, situation);
    return course.finish();
}

}  // namespace obrys::cycles
