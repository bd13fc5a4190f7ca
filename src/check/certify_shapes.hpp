#pragma once
/// Tools and bodies of the milling simulation as sim/certify takes them.

#include <cstddef>

#include "base/parallel.hpp"
#include "mesh/mesh.hpp"
#include "sim/certify/certify.hpp"
#include "sim/milling/shape.hpp"
#include "sim/milling/stock.hpp"

namespace obrys::check {

/// `off`: mm by which frustums may stand within the arcs of a form tool.
[[nodiscard]] sim::certify::Shape certified_shape(const sim::milling::Shape& of, double off);
/// A body as a mesh whose outside is outside; round ones within `off` mm.
[[nodiscard]] mesh::Mesh mesh_of(const sim::milling::Stock& body, double off);

/// Of what is allowed: how far chords of round bodies and of a form tool's arcs may leave them.
inline constexpr double round_share = 0.25;

/// A stock as what there was before anything was cut; its surface within `off` mm.
[[nodiscard]] sim::certify::Before before_of(const sim::milling::Stock& stock, double off);

/// Calls `body(i)` for 0 … n - 1, on so many threads; 0: as many as there are processors.
template <class Body>
void for_all(std::size_t n, int threads, Body&& body, std::size_t grain = 16) {
    base::with_threads(threads, [&] {
        base::in_pieces(n, grain, [&](const base::Piece& some) {
            for (std::size_t i = some.begin(); i < some.end(); ++i) body(i);
        });
    });
}

}  // namespace obrys::check
