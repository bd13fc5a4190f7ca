#pragma once
/// Half sections of form tools that importers know by a few dimensions. Heights from the tip, mm.

#include <vector>

#include "geom/contour.hpp"

namespace obrys::shop {

/// A cone that begins with `radius` at the tip and widens by `angle` degrees against the axis (narrows where that is
/// negative) up to `height`; its edge at the tip rounded by `corner`. Empty where that makes no tool.
[[nodiscard]] std::vector<geom::Vertex> tapered_profile(double radius, double corner, double angle, double height);
/// A ball of `radius` on a thinner neck, up to where the neck of `neck` radius leaves it.
[[nodiscard]] std::vector<geom::Vertex> lollipop_profile(double radius, double neck);
/// A flat tip of radius `tip`, from its edge on a hollow quarter circle of `corner` outwards, then straight up to
/// `height`.
[[nodiscard]] std::vector<geom::Vertex> hollow_profile(double tip, double corner, double height);

}  // namespace obrys::shop
