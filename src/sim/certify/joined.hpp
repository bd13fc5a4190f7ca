#pragma once
/// Bodies of one tool that stand on each other and are convex together: a cone under its shaft, the chords of a round
/// flank. What lies deep in them may lie at a ring where two of them meet, deep in neither. Millimetres.

#include <span>
#include <vector>

#include "sim/certify/body.hpp"

namespace obrys::sim::certify {

/// Without rounding, upwards; one body: it stands alone.
struct Joined {
    std::span<const Body> bodies;
    bool open_below = false;  ///< a ball or a round rim as wide lies below: it has no end there
    [[nodiscard]] bool holds(const Body& body) const;
};
/// Those of a shape that are more than one body alone. `shape` must outlive them.
[[nodiscard]] std::vector<Joined> joined_in(const Shape& shape);
/// What lies at least `depth` deep in them, upwards; nothing where they are nowhere so thick.
[[nodiscard]] Shape core_of(const Joined& joined, double depth);

}  // namespace obrys::sim::certify
