#pragma once
/// Measures of contours and regions: area, first moment, volume as a body of revolution, length, inside or outside.

#include "geom/contour.hpp"
#include "geom/edge.hpp"

namespace obrys::geom {

/// The edges in order; an open chain has one less than it has vertices. Zero-length edges are left out.
[[nodiscard]] std::vector<Edge> edges(const Contour& c);
[[nodiscard]] std::vector<Edge> edges(const Region& r);
[[nodiscard]] Contour contour_of(const std::vector<Edge>& closed_chain);

[[nodiscard]] double area(const Contour& c);  ///< positive counter-clockwise
[[nodiscard]] double area(const Region& r);
/// Integral of y over the area, mm3.
[[nodiscard]] double moment(const Region& r);
/// Volume of the body of revolution about the x axis (Pappus), mm3.
[[nodiscard]] double volume(const Region& r);
[[nodiscard]] double length(const Contour& c);
[[nodiscard]] double length(const Region& r);
[[nodiscard]] Box box(const Contour& c);
[[nodiscard]] Box box(const Region& r);

[[nodiscard]] int winding(const std::vector<Edge>& contours, Vec2 p);
[[nodiscard]] bool contains(const Region& r, Vec2 p);    ///< of a point on the contour: either
[[nodiscard]] double distance(const Region& r, Vec2 p);  ///< to the contour, from either side

[[nodiscard]] Contour moved(const Contour& c, Vec2 by);
[[nodiscard]] Contour reversed(const Contour& c);

}  // namespace obrys::geom
