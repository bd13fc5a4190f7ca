#pragma once
/// How many pieces of surface pass through a cell, by which of its nodes are material, and which of the cell's edges
/// each piece crosses. One vertex for each piece makes the surface a manifold (Schaefer, Ju, Warren: "Manifold Dual
/// Contouring", 2007); for the one case in which it would still be none, two neighbours that both join a face's two
/// pieces, see R. Wenger, "Isosurfaces" (2013), chapter on dual contouring.

#include <array>
#include <cstdint>

namespace obrys::sim::milling {

/// An edge of a cell: 4 * axis, + 1 where it lies at the far side along `first_across(axis)`, + 2 where at the far side
/// along `second_across(axis)`.
[[nodiscard]] constexpr int cell_edge(int axis, int first, int second) { return 4 * axis + first + 2 * second; }

struct Sheets {
    static constexpr std::uint8_t none = 255;
    std::uint8_t count = 0;
    std::array<std::uint8_t, 12> of_edge{none, none, none, none, none, none, none, none, none, none, none, none};
};

/// `corners` as of `NodeBits::corners`. Where a face has its material at two opposite nodes, these are kept apart;
/// `joined`: on the face `doubtful_face(corners)` they are joined.
[[nodiscard]] const Sheets& sheets(unsigned corners, bool joined);

/// The face (2 * axis, + 1 for the far one) whose two pieces of surface are one and the same piece within the cell; -1
/// where there is none. Where the neighbour says the same of this face, both must take it as joined.
[[nodiscard]] int doubtful_face(unsigned corners);

}  // namespace obrys::sim::milling
