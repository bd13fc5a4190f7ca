#pragma once
/// The surface of a stock held as rays, as a closed mesh that keeps sharp edges: dual contouring, one vertex for each
/// piece of surface in a cell of the lattice, two triangles for each edge of the lattice that the surface crosses.
/// Frame of the stock, millimetres.

#include <cstddef>
#include <functional>

#include "mesh/mesh.hpp"
#include "sim/milling/crossings.hpp"
#include "sim/milling/cut/simulation.hpp"
#include "sim/milling/dexel.hpp"

namespace obrys::sim::milling {

/// Asked now and then; empty: never.
using Stop = std::function<bool()>;

/// What was done about cells too coarse for what lies in them.
struct Refined {
    std::size_t cells = 0;     ///< of the lattice: halved once or more often
    double finest = 0;         ///< mm: the smallest cells' width
    std::vector<Box3> open;    ///< where the surface is not proved to be within the tolerance all the same
    std::vector<Box3> filled;  ///< bottoms of grooves of tools' points that are filled by up to two tolerances
};

struct Surface {
    /// Closed: every edge belongs to two triangles of opposite direction. A triangle's tag is the cut that made the
    /// surface there. Vertices and triangles come in an order that does not depend on the number of threads.
    mesh::Mesh mesh;
    /// Walls and gaps between two neighbouring nodes of a ray: thinner than the lattice's step, they are left out.
    std::size_t thin = 0;
    /// Crossings that the rays along z demand and the rays across do not have; 0 where all rays are of one body.
    std::size_t unmatched = 0;
    Refined refined;
};

/// `rays` and `normal` are called from several threads at once. Empty where the lattice has less than three nodes
/// along an axis. Memory: three bits a node, besides what grows with the surface.
[[nodiscard]] Surface extract_surface(const Lattice& lattice, Rays rays, Normal normal, const Line& line = {});
[[nodiscard]] Surface extract_surface(const Dexels& dexels, Normal normal);
/// Of what a simulation has left, which also knows what lies beside its rays: cells of the lattice are halved where it
/// would be off by more than the simulation's tolerance; until it is told to stop, then what is left to do is not done.
[[nodiscard]] Surface extract_surface(const Simulation& simulation, const Stop& stop = {});

}  // namespace obrys::sim::milling
