#include "cycles/hole/hole.hpp"

#include "cycles/hole/families.hpp"

namespace obrys::cycles {

namespace {

constexpr auto kinds =
    kind_table<OldPecking, DepthDrilling, UniversalDrilling, UniversalPecking, Centring, SingleLipDrilling, Reaming,
               DepthBoring, Counterboring, BoreMilling, OldFloatingTapping, DepthFloatingTapping, OldRigidTapping,
               DepthRigidTapping, ChipBreakTapping, ThreadCutting, ThreadMilling, CountersunkThreadMilling,
               DrilledThreadMilling, HelicalThreadMilling, OutsideThreadMilling, Drilling, ChipBreakDrilling,
               PeckDrilling, DeepDrilling, FloatingTapping, RigidTapping, FeedBoring, StopBoring, OrientedBoring,
               BackBoring, ManualBoring>();

const KindRow& row_of(Kind kind) { return kinds[static_cast<std::size_t>(kind)]; }

}  // namespace

bool is_hole_cycle(Kind kind) { return row_of(kind).family != nullptr; }

std::span<const Role> roles_of_hole(Kind kind) { return row_of(kind).roles; }

Expansion expand_hole(const Demand& demand, const Situation& situation) {
    const KindRow& row = row_of(demand.kind);
    return expand_by(row.family, demand, situation, row.anywhere);
}

}  // namespace obrys::cycles
