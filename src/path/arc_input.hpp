#pragma once
/// Arcs as NC programs define them, resolved to centre and sweep. Plane coordinates as in element.hpp, mm, radians.
/// SINUMERIK words are named for orientation; the caller converts degrees, diameters and incremental values.

#include <cstdint>

#include "geom/vec.hpp"

namespace obrys::path {

enum class Sense : std::uint8_t { clockwise, counter_clockwise };  ///< G2, G3 seen against the plane normal

enum class ArcFailure : std::uint8_t {
    none,
    radius_mismatch,   ///< start and end are not equally far from the centre
    no_radius,         ///< the centre lies on the start point
    radius_too_small,  ///< half the chord is longer than the radius
    points_coincide,   ///< start and end (or the intermediate point) are one point: the arc is not determined
    collinear,         ///< the three points lie on a line
    bad_angle,         ///< not between 0 and a full turn
    no_direction,      ///< no previous motion to be tangent to
};

/// When start and end count as equally far from the centre: the larger of the two
/// (SINUMERIK MD21000 CIRCLE_ERROR_CONST, MD21010 CIRCLE_ERROR_FACTOR).
struct ArcTolerance {
    double absolute = 0.01;    ///< mm
    double relative = 0.001;   ///< of the radius
    bool keep_centre = false;  ///< the centre stays as written: the arc is a little no circle, as the control runs it
};

/// Where the radii differ within the tolerance the centre is moved along the chord so that they are equal, unless the
/// chord is too short to tell. Meaningful with a failure: radius_difference only.
struct ArcResult {
    ArcFailure failure = ArcFailure::none;
    geom::Vec2 to, centre;
    double sweep = 0;
    double radius_difference = 0;  ///< at the end less at the start, about the given centre, mm
    [[nodiscard]] bool ok() const { return failure == ArcFailure::none; }
};

/// I J K with end point; end = start is a full circle. `turns` adds full turns (TURN=).
[[nodiscard]] ArcResult arc_by_centre(geom::Vec2 from, geom::Vec2 to, geom::Vec2 centre, Sense sense, int turns = 0,
                                      const ArcTolerance& tolerance = {});
/// CR=: a negative radius means the arc of more than half a turn. A radius too small by no more than the tolerance is
/// taken as half the chord.
[[nodiscard]] ArcResult arc_by_radius(geom::Vec2 from, geom::Vec2 to, double radius, Sense sense, int turns = 0,
                                      const ArcTolerance& tolerance = {});
/// AR= with end point; angle between 0 and 2π.
[[nodiscard]] ArcResult arc_by_angle(geom::Vec2 from, geom::Vec2 to, double angle, Sense sense, int turns = 0);
/// AR= with centre.
[[nodiscard]] ArcResult arc_about_centre(geom::Vec2 from, geom::Vec2 centre, double angle, Sense sense, int turns = 0);
/// CT: leaves `from` along `direction` (any length). Straight ahead or coinciding points give sweep 0 and `collinear`
/// or `points_coincide`: straight ahead the caller may run a line.
[[nodiscard]] ArcResult arc_by_tangent(geom::Vec2 from, geom::Vec2 to, geom::Vec2 direction);

/// CIP: in space; sweep positive about `normal`, at most a full turn.
struct ArcInSpace {
    ArcFailure failure = ArcFailure::none;
    geom::Vec3 centre, normal{0, 0, 1};
    double sweep = 0;
    [[nodiscard]] bool ok() const { return failure == ArcFailure::none; }
};
/// `normal` points so that sweep is positive. End = start is the circle that has from and via as ends of a diameter,
/// about `plane_normal`, counter-clockwise.
[[nodiscard]] ArcInSpace arc_through(const geom::Vec3& from, const geom::Vec3& via, const geom::Vec3& to,
                                     const geom::Vec3& plane_normal = {0, 0, 1});

}  // namespace obrys::path
