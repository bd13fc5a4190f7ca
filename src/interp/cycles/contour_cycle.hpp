#pragma once
/// What contour cycles work on. Private to interp.

#include <optional>

#include "cycles/contour/contour.hpp"
#include "geom/contour.hpp"
#include "geom/edge.hpp"
#include "interp/capture.hpp"

namespace obrys::interp {

/// The contours in force, in plane coordinates of the programmed frame. Contours of different depth make layers, from
/// above down, each with the values that stand for the cycle's own.
struct ContourLayer {
    cycles::ContourTask task;
    std::vector<cl::CycleValue> instead;
};

/// Nothing after a complaint. `elements`: those of all contours are added.
[[nodiscard]] std::optional<std::vector<ContourLayer>> contour_layers(Cycling&, const cycles::Demand&,
                                                                      ContourElements&);
/// Emits the steps of the cycle from `from` on (coordinates of the plane). Feed moves along an element come from its
/// block, the others from the cycle's call.
void emit_along(Telling&, std::vector<cl::Step>&, const ContourElements&, geom::Vec3 from);

/// The first element goes to the contour's start; the others are the contour, with their chamfers and roundings.
[[nodiscard]] geom::Contour contour_of(Reckoning&, const std::vector<Captured>& captured, ContourElements& elements);
[[nodiscard]] bool is_known(const geom::Contour&);
/// The areas that CONTOUR DEF, or DECLARE CONTOUR with formulas, say (contour_formula.cpp); nothing after a complaint.
[[nodiscard]] std::optional<std::vector<ContourLayer>> chosen_layers(Cycling&, const cycles::Demand&, ContourElements&);

}  // namespace obrys::interp
