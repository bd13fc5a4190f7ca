#pragma once
/// The closed curve about the band beside a chain of edges: what offsets are made of. Inside the kernel only.

#include <vector>

#include "geom/edge.hpp"

namespace obrys::geom {

/// One edge of the curve and where it comes from.
struct BandEdge {
    Edge edge;
    std::size_t of = 0;   ///< the chain's edge it lies beside, or the edge before the corner it goes around
    bool corner = false;  ///< the arc about the corner after edge `of`
    bool far = false;     ///< d away from the chain; else it leads through the band
    bool inner = false;   ///< a corner arc about a cusp whose inner side this is
};

/// Points within `d` of a closed chain and right of it lie beside an edge (in its band) or in the sector about a corner
/// between the normals of its edges. One curve goes around the chain's edges, all bands and all sectors at once, sides
/// that two of them share left out: it winds about a point once for each of them it lies in. `d` > 0; no edge is of
/// length zero. A chain that runs back over itself has its ends rounded.
[[nodiscard]] std::vector<BandEdge> band_right_of(const std::vector<Edge>& closed_chain, double d);

}  // namespace obrys::geom
