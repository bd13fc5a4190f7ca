#pragma once
/// Contour (SL) cycles: areas given by contours, and contour trains.
///
/// What the tool does as the manual says it (iTNC 530 cycle programming, SL cycles; what of it the sources at hand do
/// not hold is from memory and marked in the .cpp files): heights, levels, feeds, allowances, sense of milling. What it
/// does not say, and what we do instead (Expansion::assumption):
///   rough-out   the path is equidistant rings from the inside outwards, along pocket and islands at once; a part of
///   the
///               area that hangs together is milled to its depth before the next. What is cut is the same: all that the
///               tool reaches with the side allowance left, on the documented levels.
///   infeed      points of pilot drilling are the starts of these paths.
///   walls       arcs to and from a wall are quarter circles of the tool's radius at most, in the middle of the longest
///               element where they find room.

#include <vector>

#include "cycles/cycle.hpp"
#include "geom/contour.hpp"

namespace obrys::cycles {

struct ContourTrain {
    geom::Contour contour;  ///< as programmed, open or closed
    int side = 0;           ///< +1 tool on its left (RL), -1 right (RR), 0 on it
};

/// The geometry of a contour cycle, in the plane's u and v, absolute. Pockets and islands are already one region
/// (cycles/shapes.hpp classify and area_of, or geom/boolean.hpp for formulas).
struct ContourTask {
    geom::Region area;              ///< 20 to 24
    ContourTrain train;             ///< 25
    double other_radius = unknown;  ///< of the tool that coarse_tool (22) or pilot_tool (21: the rough-out tool) names
};

/// The kinds that `expand_contour` knows: pilot_drill, rough_out, floor_finish, side_finish, contour_train. Values of
/// the demand: those of contour_data (contour_train_data) first, then the cycle's own.
[[nodiscard]] bool is_contour_cycle(cl::CycleKind kind);
[[nodiscard]] Expansion expand_contour(const Demand& demand, const Situation& situation, const ContourTask& task);

}  // namespace obrys::cycles
