#pragma once
/// Surfaces that pass through themselves: what is inside is not known there. Millimetres.

#include <optional>

#include "mesh/distance.hpp"

namespace obrys::mesh {

/// A side of a triangle goes through another triangle.
struct SelfCrossing {
    geom::Vec3 at;
    double beyond = 0;  ///< how far each end of the side lies from that triangle's plane, at least
};

/// One whose side goes on by more than so on both ends, or by a quarter of its length where that is less; of the
/// earliest triangle.
[[nodiscard]] std::optional<SelfCrossing> self_crossing(const Distance& surface, double beyond);

}  // namespace obrys::mesh
