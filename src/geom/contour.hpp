#pragma once
/// Contours of lines and arcs in a plane, and regions bounded by them.

#include <vector>

#include "geom/vec.hpp"

namespace obrys::geom {

/// A corner, and the edge to the next one: straight (bulge 0) or an arc, bulge = tan(sweep / 4), positive
/// counter-clockwise.
struct Vertex {
    Vec2 p;
    double bulge = 0;
    bool operator==(const Vertex&) const = default;
};

/// A chain of edges. Closed: the last vertex' edge leads back to the first; open: the last vertex has no edge.
struct Contour {
    std::vector<Vertex> vertices;
    bool closed = true;
    bool operator==(const Contour&) const = default;
};

/// A bounded part of the plane. Contours are closed, do not cross, material lies left of every edge
/// (outer contours counter-clockwise, holes clockwise).
struct Region {
    std::vector<Contour> contours;
    [[nodiscard]] bool empty() const { return contours.empty(); }
    bool operator==(const Region&) const = default;
};

}  // namespace obrys::geom
