#pragma once
/// The region a closed outline covers while it is shifted along a line or along an arc (it does not turn). Exact: lines
/// sweep to parallelograms, arcs to concentric arcs of the sum and the difference of the radii.

#include "geom/region.hpp"

namespace obrys::geom {

/// `outline`: simple, counter-clockwise. The region covered from outline to outline + by.
[[nodiscard]] Region sweep_straight(const Contour& outline, Vec2 by);
/// Shifted by R * (cos w, sin w) about `centre` for w from `from` to from + sweep radians (either sign, any size);
/// `outline` is relative to the moving point.
[[nodiscard]] Region sweep_round(const Contour& outline, Vec2 centre, double radius, double from, double sweep);

}  // namespace obrys::geom
