#pragma once
/// How much of a tool's outline is in the material during a move.

#include "sim/turning/turning.hpp"

namespace obrys::sim::turning {

/// Largest length of the parts of the outline that look ahead and lie in `removed`, mm, of the poses at which a corner
/// of `removed` is reached and the end; between these poses it is not looked at. Of an arc move the end only.
[[nodiscard]] double contact_length(const geom::Contour& outline, const Move& move, const geom::Region& removed);

}  // namespace obrys::sim::turning
