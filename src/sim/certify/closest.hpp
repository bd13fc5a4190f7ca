#pragma once
/// How far a swept body and a triangle or a point lie apart, by the method of Gilbert, Johnson and Keerthi (1988).

#include <span>

#include "sim/certify/body.hpp"

namespace obrys::sim::certify {

/// Between the swept body before it is grown by its ball, and the hull of a few points.
struct Apart {
    double lower = 0, upper = 0;   ///< the distance lies between
    geom::Vec3 on_body, on_other;  ///< places `upper` apart
    [[nodiscard]] bool meet() const { return upper == 0; }
};
/// Ends as soon as it is known whether they lie farther apart than `reach`, or where nothing is gained any more.
/// `others`: 1 to 3 points.
inline constexpr double to_the_end = -1;  ///< a reach: the distance is wanted as it is
[[nodiscard]] Apart closest(const Swept& swept, std::span<const geom::Vec3> others, double reach);

}  // namespace obrys::sim::certify
