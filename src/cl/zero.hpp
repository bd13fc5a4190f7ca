#pragma once
/// From the frame of one workpiece zero into that of another. Millimetres.

#include <optional>

#include "cl/record.hpp"

namespace obrys::cl {

/// Way from one zero to another; 0 along axes where it is not known: there both are taken as the same.
[[nodiscard]] geom::Vec3 way(const Datum& from, const Datum& to);

/// Of one who keeps a place in the frame of the last zero: the place as it is seen from the next one. The machine does
/// not move.
void change(std::optional<Datum>& zero, const Datum& next, geom::Vec3& place);

/// Moves the points of a move and of a programmed element, the place of a cycle; not its plane, which places share.
void shift(Step& step, const geom::Vec3& by);
/// Whether it has points that are so moved.
[[nodiscard]] bool has_points(const Step& step);

}  // namespace obrys::cl
