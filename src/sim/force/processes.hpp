#pragma once
/// Forces of turning, grooving, drilling and tapping. mm, N, radians, m/min, W, N mm.

#include "sim/cutting/law.hpp"

namespace obrys::sim::force {

/// Of turning what is usual beside the force along the cut: along the feed, and square to both.
inline constexpr double feed_ratio = 0.45, back_ratio = 0.35;

struct Turning {
    double chip = 0, width = 0;  ///< thickness, and length of edge in the cut
    double cutting = 0;          ///< along the cut
    double feed = 0, back = 0;   ///< by the usual ratios where the law does not say them
    double power = 0;            ///< W
};
/// `entering`: angle of the edge against the feed.
[[nodiscard]] Turning turning(const cutting::Law& law, double depth, double feed, double entering, double speed);
/// Straight in with a blade of this width; with a blade that goes in beside its last cut the step is the width.
[[nodiscard]] Turning grooving(const cutting::Law& law, double width, double feed, double speed);

/// How much less a tool with another rake than the law's is pushed: 1.5 % a degree of aluminium, 1 % of steel.
[[nodiscard]] double rake_factor(double rake_deg, double law_rake_deg, double percent_a_degree);

struct Drilling {
    double torque = 0;  ///< N mm
    double thrust = 0;  ///< N: half the force along the cut on both edges, without the chisel's
};
/// `feed`: of a tooth. `point`: angle between the edges.
[[nodiscard]] Drilling drilling(const cutting::Law& law, double diameter, int teeth, double feed, double point);
/// Of cutting a thread: all of its section by edges of half the diameter: pitch² diameter kc / 8.
[[nodiscard]] double tapping_torque(const cutting::Law& law, double diameter, double pitch, int teeth);

}  // namespace obrys::sim::force
