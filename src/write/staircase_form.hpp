#pragma once
/// The table [staircase] of a post: its control moves one axis at a time. mm.

#include <cstdint>

namespace obrys::write {

/// What is asked of staircases.
struct StaircaseForm {
    double roughness = 0;      ///< highest ridge that a milled contour may have (Rz)
    double deviation = 0;      ///< farthest from the path where nobody says on which side of it the part is
    double tool_diameter = 0;  ///< where no radius compensation says it; 0: not known
    double away = 0;           ///< farthest from the path on the side that is not the part's; 0: as far as it comes
    double units = 0;          ///< of the word of a coordinate in a mm; 0: it holds every number
    enum class Part : std::uint8_t { not_known, left, right };
    Part part = Part::not_known;  ///< of paths that are not compensated: the side of the part, along the move
};

}  // namespace obrys::write
