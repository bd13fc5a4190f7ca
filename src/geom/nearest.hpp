#pragma once
/// Where two chains of edges come nearest to each other.

#include <vector>

#include "geom/edge.hpp"

namespace obrys::geom {

/// A point of the first and one of the second, and how far they are apart.
struct Gap {
    Vec2 a, b;
    double length = std::numeric_limits<double>::infinity();
};
/// Of two edges that do not cross.
[[nodiscard]] Gap nearest_points(const Edge& e, const Edge& f);
[[nodiscard]] Gap nearest_points(const std::vector<Edge>& a, const std::vector<Edge>& b);

/// A lower bound of the distance between what lies in two boxes.
[[nodiscard]] double distance(const Box& a, const Box& b);

}  // namespace obrys::geom
