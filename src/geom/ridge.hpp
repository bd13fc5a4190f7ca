#pragma once
/// A round tool that touches a contour at single places and leaves ridges between them: how far apart the places may
/// be, so that no ridge is higher than wanted. Lengths in mm, angles in radians.
///
/// Source: I. Slavkova, computer-made programs for NC machines, thesis, Liberec 1984, sections 4.2.13 and
/// 4.2.14, with outside and inside arcs the right way round (its listing has them exchanged).

#include "geom/vec.hpp"

namespace obrys::geom {

/// A tool of this diameter, and the height of the ridges that it may leave.
struct RidgeTool {
    double diameter = 0;
    double height = 0;
};

/// Half the way between two places along a straight contour: sqrt(D h - h^2). At most the radius.
[[nodiscard]] double half_ridge_step(const RidgeTool& tool);

/// The angle between two places along an arc of the contour, seen from its centre. `radius` is that of the contour (0:
/// a corner about which the tool rolls); `outside`: the tool is outside of the circle. At most a quarter turn.
[[nodiscard]] double ridge_step_angle(double radius, const RidgeTool& tool, bool outside);

/// Height of the ridge between two places so far apart; infinite where the tool leaves a gap.
[[nodiscard]] double ridge_of_line(double step, double diameter);
[[nodiscard]] double ridge_of_arc(double radius, double angle, double diameter, bool outside);

/// Ways along the axes from one place to another have one corner; that which lies left of the straight way, or right.
[[nodiscard]] Vec2 stair_corner(Vec2 from, Vec2 to, bool left);

}  // namespace obrys::geom
