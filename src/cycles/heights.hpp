#pragma once
/// Heights of cycles that count from a surface: nearly all of HEIDENHAIN's.

#include "cycles/typed.hpp"

namespace obrys::cycles {

struct BelowSurface {
    static constexpr bool anywhere = false;
    double surface = unknown;    ///< absolute w, mm
    double clearance = unknown;  ///< mm above the surface
    double depth = unknown;      ///< mm from the surface, negative
    Said second_clearance;  ///< mm above the surface, where the tool stands behind the cycle; not below the clearance
};

template <>
inline constexpr auto members_of<BelowSurface> = rows<BelowSurface>({
    {Role::surface, &BelowSurface::surface},
    {Role::clearance, &BelowSurface::clearance, Must::be_at_least_0},
    {Role::depth, &BelowSurface::depth, Must::go_deep},
    {Role::second_clearance, &BelowSurface::second_clearance, Must::be_at_least_0},
});

/// The same as absolute w.
struct Heights {
    double surface = 0, clearance = 0, bottom = 0, end = 0;  ///< end: where the tool stands after the cycle
};
[[nodiscard]] inline Heights heights_of(const BelowSurface& d) {
    return {d.surface, d.surface + d.clearance, d.surface + d.depth,
            d.surface + std::max(d.clearance, d.second_clearance.value_or(0))};
}

/// 0 is as if nothing were said.
[[nodiscard]] inline double unless_0(const Said& said, double otherwise) {
    return said && *said != 0 ? *said : otherwise;
}

}  // namespace obrys::cycles
