#pragma once
/// The half section of a form tool as solids of revolution.

#include <string>
#include <vector>

#include "geom/contour.hpp"
#include "sim/milling/shape.hpp"

namespace obrys::sim::milling {

/// Straight edges make frustums, arcs that bulge outwards about a centre at or beyond the axis are kept, all other arcs
/// become frustums whose chords stand off by at most `deviation`. What is wrong goes to `problem`.
[[nodiscard]] std::vector<Piece> pieces_of_profile(const std::vector<geom::Vertex>& profile, double deviation,
                                                   std::string& problem);

}  // namespace obrys::sim::milling
