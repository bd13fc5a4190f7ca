#pragma once
/// Outer corners whose transition arc is pulled out towards the crossing of the parallels (SINUMERIK DISC).

#include <vector>

#include "path/element.hpp"

namespace obrys::path {

/// The way in place of the transition arc: the conic that touches both parallels where the arc does and whose middle
/// lies `part` (0 … 1) of the way from the arc to the parallels' crossing. 0 is the arc itself, 1 the two parallels.
/// Made of arcs that lie within 0.0001 mm of it. An arc of half a turn and more has no crossing and stays.
[[nodiscard]] std::vector<Element> pulled_corner(const Element& arc, double part);

}  // namespace obrys::path
