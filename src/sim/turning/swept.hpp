#pragma once
/// What a move covers, on both sides of the turning axis.

#include <vector>

#include "sim/turning/turning.hpp"

namespace obrys::sim::turning {

/// The region covered by `outline` (relative to the programmed point, counter-clockwise) along the move.
[[nodiscard]] geom::Region swept(const geom::Contour& outline, const Move& move);

/// An outline and its move, turned over to the other side of the axis.
struct TurnedOver {
    geom::Contour outline;
    Move move;
};
/// What passes below the axis meets the material that turns, half a turn later, above it: the outlines and moves that
/// cover this region there. Of a programmed point above the axis `across` passes below it, of one below all of
/// `outline`.
[[nodiscard]] std::vector<TurnedOver> turned_over(const geom::Contour& outline, const geom::Contour& across,
                                                  const Move& move);

}  // namespace obrys::sim::turning
