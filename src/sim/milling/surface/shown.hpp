#pragma once
/// Whether a mesh shows what is known of the exact surface; where it does not, cells are halved.

#include "base/function_ref.hpp"
#include "sim/milling/node_bits.hpp"
#include "sim/milling/surface/fine.hpp"

namespace obrys::sim::milling {

/// Halves cells until edges, corners and rims (unseen.hpp) lie no farther from the mesh than the tolerance; where that
/// cannot be had, the place is left open. `mesh`: as it is now.
void show_all(const Simulation& simulation, const NodeBits& nodes, Exact& exact, Fine& fine,
              base::FunctionRef<mesh::Mesh()> mesh, const Stop& stop);

}  // namespace obrys::sim::milling
