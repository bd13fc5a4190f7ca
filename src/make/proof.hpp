#pragma once
/// A path held against stock and part by the exact simulation of turning: nothing of the strategies' own reckoning.

#include "cycles/groove/strategy.hpp"
#include "make/order.hpp"

namespace obrys::make {

/// mm, mm2; depths normal to the contour.
struct Proof {
    double gouge = 0;           ///< below the contour that the path is for
    double rapid_in_stock = 0;  ///< along v
    double rest = 0;            ///< above it, at the end
    double removed_area = 0;
    double asked_area = 0;  ///< between the stock and the contour
    double rest_area = 0;
    double rest_bound = 0;  ///< what the insert's corners and the strategy must leave
};

/// Depths below this are none, mm: far below what the simulation's points are apart when they are one.
inline constexpr double no_depth = 1e-7;

/// As near as the simulation measures how far a rest lies from the contour, mm.
inline constexpr double rest_accuracy = 5e-5;

[[nodiscard]] Proof prove(const groove::Request& request, const groove::Contours& contours, groove::Strategy strategy,
                          const std::vector<groove::Move>& moves);

}  // namespace obrys::make
