#pragma once
/// How a mill's edges were engaged in a move: radial depth, angles, feed per tooth, chip thickness. What a force model
/// needs. Millimetres, radians; NaN where it is not known. Meaning of the figures and their limits: docs/engagement.md.
///
/// Chip thickness after Altintas, Manufacturing Automation, ch. 2 (after Martellotti): f sin(phi) with phi from the
/// normal of the feed, here f cos(theta) with theta from the feed; at an edge that leans by kappa out of the plane
/// normal to the axis it is the feed's part along the edge's normal,
///     h = f_r cos(theta) sin(kappa) + f_a cos(kappa),
/// f_r and f_a being the parts of the feed per tooth square to the axis and down along it.

#include <vector>

#include "check/result.hpp"
#include "shop/tool.hpp"
#include "sim/milling/shape.hpp"

namespace obrys::check {

/// A tool as its edges matter here; to be made once a tool.
class CuttingEdges {
public:
    /// Of a tool whose dimensions make no shape nothing is known but its teeth.
    explicit CuttingEdges(const shop::Tool& tool);

    [[nodiscard]] int teeth() const { return teeth_; }  ///< 0: not said
    /// Largest radius up to this height above the tip; NaN where there is no shape.
    [[nodiscard]] double radius(double reach) const;
    /// Angle kappa between the plane normal to the axis and the edge: the ends of each smooth piece of the edge up to
    /// this height, a flat end (kappa 0) first.
    struct Lean {
        double lowest = 0, highest = 0;
    };
    [[nodiscard]] std::vector<Lean> leans(double reach) const;

private:
    sim::milling::Shape shape_;
    int teeth_ = 0;
};

struct EdgeEngagement {
    double radial_depth = NAN;  ///< width of what was removed, square to way and axis; of plunging of the ring
    /// Directions seen against the axis, counter-clockwise, 0 that of the feed; of the flank that faces the feed.
    /// Straight along the axis: all round, -pi to pi.
    double from = NAN, to = NAN;
    double feed_per_tooth = NAN;
    /// Where the edge is thickest engaged: largest over the angles, and the mean over them at the same place of the
    /// edge.
    double chip_largest = NAN, chip_mean = NAN;
};

/// `ray_distance`: of the simulation. The outermost ray lies up to so much within the material's side: half of it is
/// added, and where the tool's own side is no farther than that, it is taken: there the edge enters or leaves nearly
/// always, and the angle hangs on it by a root. Of a move that removed nothing only the feed per tooth is known.
[[nodiscard]] EdgeEngagement engagement_of(const MilledMove& move, const CuttingEdges& edges, double ray_distance);

}  // namespace obrys::check
