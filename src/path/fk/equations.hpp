#pragma once
/// The data of an FK element as equations. Inside of fk.hpp; not for callers.
///
/// A line is its left normal n and offset p: n·x = p. An arc is its centre c and radius r, positive counter-clockwise,
/// and the left normals nB, nA of its tangents at start and end: c = start + r nB = end + r nA. So directions have a
/// sense, a tangential transition is nA of one element = nB of the next, and c·n - p = r is a line tangent to an arc.

#include <functional>

#include "path/fk/system.hpp"

namespace obrys::path {

/// What neighbours and relative data use of an element: unknowns, or constants once it is determined.
/// Relative to the contour's start point, mm.
struct FkHandle {
    std::uint64_t tag = 0;
    bool arc = false, has_direction = true;
    FkPoly start_x, start_y, end_x, end_y;
    FkPoly nb_x, nb_y, na_x, na_y;  ///< left normals of the tangents at start and end
    FkPoly offset;                  ///< of a line
    FkPoly centre_x, centre_y, radius;
};
/// Unknowns of an element: 8 for a line, 12 for an arc, from first_id, a multiple of 4.
[[nodiscard]] constexpr int unknowns_of(const FkElement& e) { return e.arc ? 12 : 8; }
[[nodiscard]] FkHandle unknown_handle(const FkElement& e, int first_id, const FkHandle& before);
[[nodiscard]] FkHandle constant_handle(const Element& e, geom::Vec2 origin);

using FkLookup = std::function<const FkHandle*(std::uint64_t tag)>;

/// First fault in the data as such.
[[nodiscard]] std::optional<FkFault> fault_in(const FkElement& e, const FkHandle& before, const FkLookup& find);

/// Each choice must be made one way or another: in every branch one of its alternatives holds.
using FkChoice = std::vector<FkEquations>;
struct FkSurroundings {
    const FkHandle& self;
    const FkHandle& before;
    const FkLookup& find;
    geom::Vec2 origin;
    std::array<FkPoly, 2> closing;  ///< where CLSD- ends
};
[[nodiscard]] std::vector<FkChoice> equations_of(const FkElement& e, const FkSurroundings& around);

}  // namespace obrys::path
