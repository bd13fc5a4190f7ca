#pragma once
/// Moves of the stream as elements that geom can interpolate.

#include <optional>

#include "cl/record.hpp"
#include "geom/interpolation.hpp"

namespace obrys::cl {

/// The way of a move from `from`; threads and rapids are straight. A coordinate that was never given, at either end, is
/// 0 all along. Nothing for steps that are no moves, and where a coordinate that is needed is not known.
[[nodiscard]] std::optional<geom::PathElement> element_of(geom::Vec3 from, const Step& move);

}  // namespace obrys::cl
