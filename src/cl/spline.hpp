#pragma once
/// What can be asked of a Spline record, and how moves join: where one starts beside the end of the last, and by what
/// angle the direction breaks there.
/// Source of the record: HEIDENHAIN iTNC 530 user's manual, chapter "Contour movements - spline interpolation": the
/// parameter runs from 1 to 0; the control refuses a start more than 1 um off the end of the last contour element, and
/// stops exactly (or slows down) where the direction changes by 0.1 degrees or more.

#include "cl/record.hpp"
#include "geom/cubic.hpp"

namespace obrys::cl {

/// The curve with the parameter as the control counts it: t = 1 is the start, t = 0 the end.
[[nodiscard]] geom::Cubic curve(const Spline& s);
/// The curve with the parameter in the direction of motion: u = 0 is the start, u = 1 the end.
[[nodiscard]] geom::Cubic forward(const Spline& s);
[[nodiscard]] geom::Vec3 start_of(const Spline& s);
/// The record of a curve that is run from its t = 0 to its t = 1, without additional axes. `to` is given where the end
/// is known better than the coefficients add up to.
[[nodiscard]] Spline spline_of(const geom::Cubic& forward);
[[nodiscard]] Spline spline_of(const geom::Cubic& forward, geom::Vec3 to);
/// An additional axis with the control's parameter.
[[nodiscard]] geom::Polynomial3 curve(const SplineAxis& a);

/// From the position before a spline to the spline's start, mm. A coordinate not known at both ends has no gap; known
/// at one end only it is NaN.
[[nodiscard]] geom::Vec3 start_gap(geom::Vec3 position, const Spline& s);

/// Unit vectors in which a move from `from` leaves its start and reaches its end. Zero vector where the move has no
/// direction or is none; NaN where it is not known. Coordinates not known at both ends do not move.
[[nodiscard]] geom::Vec3 first_direction(geom::Vec3 from, const Step& move);
[[nodiscard]] geom::Vec3 last_direction(geom::Vec3 from, const Step& move);

/// How a spline follows what was before it.
struct Joint {
    geom::Vec3 gap;       ///< along the axes, mm, as of start_gap
    double distance = 0;  ///< its length; NaN where not known
    double turn = 0;      ///< radians 0..pi between the directions; NaN where one is not known or there is none
};
/// `arriving`: last_direction of the move before; `position`: where it ended.
[[nodiscard]] Joint join(geom::Vec3 position, geom::Vec3 arriving, const Spline& next);
[[nodiscard]] Joint join(const Spline& before, const Spline& next);

/// Points of the move between its ends (neither is among them), so close that no chord leaves an arc or spline by more
/// than `tolerance` mm, but fewer than `most`. None for straight moves and where the move is not known.
void points_between(geom::Vec3 from, const Step& move, double tolerance, int most,
                    base::FunctionRef<void(geom::Vec3)> point);

}  // namespace obrys::cl
