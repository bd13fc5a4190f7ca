#include "cycles/mill/mill.hpp"

#include <algorithm>

#include "cycles/mill/families.hpp"

namespace obrys::cycles {

namespace {

constexpr auto kinds = kind_table<RectangularPocket, CircularPocket, OldRectangularPocket, OldCircularPocket, Slot,
                                  RoundSlot, ReciprocatingSlot, ReciprocatingRoundSlot, RectangularStud, CircularStud,
                                  RectangularPocketFinishing, RectangularStudFinishing, CircularPocketFinishing,
                                  CircularStudFinishing, Multipass, RuledSurface, FaceMilling>();

const KindRow& row_of(Kind kind) { return kinds[static_cast<std::size_t>(kind)]; }

/// Where the tool stands in the plane does not matter: the cycle says its place itself, and goes there first. A slot
/// that has a centre and a position has that of the centre at position 0 alone.
bool goes_by_itself(const KindRow& row, const Demand& demand) {
    const bool has_centre = std::find(row.roles.begin(), row.roles.end(), Role::centre_u) != row.roles.end();
    if (!row.anywhere || !has_centre) return row.anywhere;
    return demand.get(Role::position, 0) == 0 && demand.find(Role::centre_u) && demand.find(Role::centre_v);
}

}  // namespace

bool is_mill_cycle(Kind kind) { return row_of(kind).family != nullptr; }

std::span<const Role> roles_of_mill(Kind kind) { return row_of(kind).roles; }

Expansion expand_mill(const Demand& demand, const Situation& situation) {
    const KindRow& row = row_of(demand.kind);
    return expand_by(row.family, demand, situation, goes_by_itself(row, demand));
}

}  // namespace obrys::cycles
