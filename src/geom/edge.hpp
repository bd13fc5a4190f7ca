#pragma once
/// One edge of a contour, straight or an arc, and what can be asked of it. Millimetres, radians.

#include <array>

#include "geom/box.hpp"
#include "geom/vec.hpp"

namespace obrys::geom {

/// From `a` to `b`; bulge = tan(sweep / 4), positive counter-clockwise, 0 straight.
struct Edge {
    Vec2 a, b;
    double bulge = 0;
    bool operator==(const Edge&) const = default;
};

struct Circle {
    Vec2 centre;
    double radius = 0;
};

/// True where the edge leaves its chord by more than can be seen (1e-12 mm).
[[nodiscard]] bool is_arc(const Edge& e);
[[nodiscard]] double chord(const Edge& e);
[[nodiscard]] double sagitta(const Edge& e);      ///< signed: positive for a counter-clockwise arc
[[nodiscard]] double sweep_angle(const Edge& e);  ///< signed
[[nodiscard]] Circle circle(const Edge& e);       ///< requires is_arc
/// Power of the point about the arc's circle (distance to the centre squared less radius squared), and its distance
/// from the circle, negative inside; both keep their digits where the arc is nearly straight. Require is_arc.
[[nodiscard]] double power(const Edge& e, Vec2 p);
[[nodiscard]] double outside(const Edge& e, Vec2 p);
[[nodiscard]] double length(const Edge& e);
[[nodiscard]] Box box(const Edge& e);
[[nodiscard]] Edge reversed(const Edge& e);
[[nodiscard]] Edge moved(const Edge& e, Vec2 by);
[[nodiscard]] Vec2 point_at(const Edge& e, double t);    ///< t in 0..1, by length
[[nodiscard]] Vec2 tangent_at(const Edge& e, double t);  ///< unit
/// Where along the edge (0..1, by length) the point of the edge's line or circle nearest to `p` lies; beyond 0..1
/// outside.
[[nodiscard]] double parameter(const Edge& e, Vec2 p);
[[nodiscard]] Vec2 nearest(const Edge& e, Vec2 p);
[[nodiscard]] double distance(const Edge& e, Vec2 p);
/// The part of the edge between two of its points at parameters t0 < t1.
[[nodiscard]] Edge part(const Edge& e, double t0, double t1);
[[nodiscard]] Edge arc_about(Vec2 centre, double radius, double from, double sweep);

/// Contribution to the area of the region left of the contour (Green), relative to the origin.
[[nodiscard]] double area_term(const Edge& e);
/// Contribution to the region's first moment about the x axis, the integral of y.
[[nodiscard]] double moment_term(const Edge& e);
/// How often the edge, as part of closed contours, winds about `p` (half-open rule: the terms of a contour add up).
[[nodiscard]] int winding_term(const Edge& e, Vec2 p);

/// Up to two points in which the edges cross or touch within `tolerance`; of edges that run along each other none
/// (their ends tell where).
struct Crossings {
    std::array<Vec2, 2> points;
    int count = 0;
};
[[nodiscard]] Crossings crossings(const Edge& e, const Edge& f, double tolerance);

}  // namespace obrys::geom
