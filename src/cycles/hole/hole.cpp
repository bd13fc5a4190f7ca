#include "cycles/hole/hole.hpp"

#include "cycles/hole/families.hpp"

namespace obrys::cycles {

namespace {

Family hole_family_of(Kind kind) {
    switch (kind) {
        case Kind::peck:
        case Kind::drill:
        case Kind::universal_drill:
        case Kind::universal_peck:
        case Kind::centre:
        case Kind::single_lip: return expand_drill;
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
        case Kind::canned_drill:
        case Kind::canned_chip_break:
        case Kind::canned_peck:
        case Kind::canned_deep:
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

bool is_hole_cycle(Kind kind) { return hole_family_of(kind) != nullptr; }

Expansion expand_hole(const Demand& demand, const Situation& situation) {
    const Family family = hole_family_of(demand.kind);
    // A canned cycle says its place itself, and goes there first.
    return expand_by(family, demand, situation, family == &expand_canned);
}

}  // namespace obrys::cycles
