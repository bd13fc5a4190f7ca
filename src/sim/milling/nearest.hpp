#pragma once
/// How far a point lies outside a moving piece or tool, at the moment it is nearest.

#include "sim/milling/shape.hpp"
#include "sim/milling/track.hpp"

namespace obrys::sim::milling {

/// As `outside` (shape.hpp) says, at the moment when that is least; a convex function of the point for straight tracks.
struct Foot {
    double outside = 0;
    geom::Vec3 normal;  ///< out of the piece, unit length; frame of the tool
    /// How `outside` grows with the point: the normal, but where a moving edge is nearest, between those of its two
    /// faces.
    geom::Vec3 gradient;
    geom::Vec3 place;  ///< of the tip at that moment
};
[[nodiscard]] Foot foot_on(const Piece& piece, geom::Vec3 v, geom::Vec3 p);
/// Of the piece that the point lies deepest in or is nearest to.
[[nodiscard]] Foot foot_on(const Shape& shape, const Track& track, geom::Vec3 p);

}  // namespace obrys::sim::milling
