#pragma once
/// How far pieces of material lie from a contour: along its normal and along x.

#include <optional>
#include <vector>

#include "sim/turning/along_x.hpp"
#include "sim/turning/turning.hpp"

namespace obrys::sim::turning {

/// A contour from which depths are measured, many times.
class Around {
public:
    explicit Around(const geom::Region& contour);
    /// Nothing where no point of the connected piece is farther than `tolerance` from the contour.
    [[nodiscard]] std::optional<Depth> measure(const geom::Region& piece, double tolerance) const;

private:
    std::vector<Wall> edges_;   ///< without the axis
    std::vector<Wall> chords_;  ///< these, arcs as chords
};

}  // namespace obrys::sim::turning
