#pragma once
/// How far a tool gives way: a cantilever of two sections, its fluted part as stiff as a rod of its core. mm, N.

#include <cmath>

namespace obrys::sim::force {

/// Of the diameter of its edges: that of a rod as stiff as a fluted mill.
inline constexpr double usual_core = 0.8;

struct ToolBeam {
    double diameter = 0;           ///< of the edges, and of the shank above them
    double flutes = 0, shank = 0;  ///< lengths
    double elasticity = 0;         ///< N/mm2
    double core = usual_core;
    double holder = INFINITY;  ///< N/mm of the holder
};

/// N/mm at the tip.
[[nodiscard]] double stiffness(const ToolBeam& tool);

}  // namespace obrys::sim::force
