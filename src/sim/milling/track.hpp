#pragma once
/// The way of a tool within one sweep, in the tool's own frame: its axis is z, it starts at the origin. Millimetres.

#include <cstdint>

#include "geom/vec.hpp"
#include "sim/milling/lattice.hpp"
#include "sim/milling/shape.hpp"

namespace obrys::sim::milling {

/// A frame whose z is the tool's axis; x and y are any two. Axes of the stock's frame are met exactly.
struct Orientation {
    geom::Vec3 x{1, 0, 0}, y{0, 1, 0}, z{0, 0, 1};
    int along = 2;  ///< axis of the stock that z runs along, either way; -1: none
    [[nodiscard]] geom::Vec3 to_tool(geom::Vec3 v) const { return {dot(x, v), dot(y, v), dot(z, v)}; }
    [[nodiscard]] geom::Vec3 to_stock(geom::Vec3 v) const { return v.x * x + v.y * y + v.z * z; }
    /// Boxes around a box, of the other frame.
    [[nodiscard]] Box3 box_in_tool(const Box3& box) const;
    [[nodiscard]] Box3 box_in_stock(const Box3& box) const;
};
/// Of a box's corners along an axis: the dot products with it.
[[nodiscard]] Heights heights_along(geom::Vec3 axis, const Box3& box);
/// `axis` needs no unit length; it must be finite and not zero.
[[nodiscard]] Orientation orientation_of(geom::Vec3 axis);

/// A translation by `v`, or a circle of at most a quarter turn in the plane normal to the tool's axis, from the origin
/// to `v`.
struct Track {
    geom::Vec3 v;
    bool circular = false;
    geom::Vec2 centre;
    double radius = 0;
    double turn = 1;         ///< +1 counter-clockwise, -1 clockwise
    geom::Vec2 first, last;  ///< from the centre to the start and to the end, unit length
    [[nodiscard]] bool level() const { return v.z == 0; }
    /// A direction, from the centre, is one that the circle passes through.
    [[nodiscard]] bool passes(geom::Vec2 q) const { return turn * cross(first, q) >= 0 && turn * cross(q, last) >= 0; }
    [[nodiscard]] bool upright() const { return !circular && v.x == 0 && v.y == 0; }
};

/// A place on it, from 0 to 1; of a circle by its chord: between its ends, though not evenly.
[[nodiscard]] geom::Vec3 point_on(const Track& track, double share);

/// Distance of a point (seen along the axis) from the track, and how far left of it the point lies; to the right
/// negative, before the start and behind the end also the distance from the line or circle gone on with.
struct Offset {
    double distance = 0, left = 0;
};
[[nodiscard]] Offset offset_from(const Track& track, geom::Vec2 p);

}  // namespace obrys::sim::milling
