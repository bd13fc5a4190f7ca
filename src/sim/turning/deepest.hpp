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
    /// Nothing where no point of the connected piece is farther than `tolerance` from the contour. The depth is that of
    /// a point of the piece (or 0.00002 mm beside it), and no point lies more than 0.00005 mm deeper.
    [[nodiscard]] std::optional<Depth> measure(const geom::Region& piece, double tolerance) const;
    /// Whether some point of the piece is farther than `depth` from the contour.
    [[nodiscard]] bool reaches(const geom::Region& piece, double depth) const;

private:
    std::vector<Wall> edges_;  ///< without the axis
};

}  // namespace obrys::sim::turning
