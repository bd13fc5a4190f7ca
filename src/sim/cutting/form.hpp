#pragma once
/// What of a mill's form matters to cutting data. mm, radians.

#include <cstdint>

namespace obrys::sim::cutting {

/// An end mill; with a corner radius a bull nose, with one of half the diameter a ball.
struct MillForm {
    double diameter = 0;
    double corner_radius = 0;
    double tilt = 0;  ///< of its axis against the normal of the surface that it leaves
};

/// Of the highest place of the edge that cuts at this depth (square to the surface that is left). Of a ball with
/// diameter D d sin(tilt + acos(1 - 2 depth / D)), never more than the tool's own.
[[nodiscard]] double effective_diameter(const MillForm& form, double depth);

/// Mean of the sine of the edge's angle to the plane that is left, over the edge that cuts at this depth: how much
/// thinner chips are than at a straight flank.
[[nodiscard]] double mean_lean(const MillForm& form, double depth);

/// How long that edge is.
[[nodiscard]] double edge_length(const MillForm& form, double depth);

/// Height of the ridges that a round of this radius leaves at this distance; NaN where it is more than they reach.
[[nodiscard]] double ridge(double radius, double distance);
/// Mean deviation of such ridges from their mean line: of arcs, 4 / (9 sqrt(3)) of their height.
[[nodiscard]] double mean_deviation(double ridge);

}  // namespace obrys::sim::cutting
