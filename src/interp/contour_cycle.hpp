#pragma once
/// What contour cycles work on. Private to interp.

#include <optional>

#include "cycles/contour.hpp"
#include "geom/contour.hpp"
#include "interp/capture.hpp"

namespace obrys::interp {

/// The contours in force, in plane coordinates of the programmed frame. Contours of different depth make layers, from
/// above down, each with the values that stand for the cycle's own.
struct ContourLayer {
    cycles::ContourTask task;
    std::vector<program::CycleValue> instead;
};
/// Nothing after a complaint.
[[nodiscard]] std::optional<std::vector<ContourLayer>> contour_layers(Run&, const cycles::Demand&);

/// The first element goes to the contour's start; the others are the contour, with their chamfers and roundings.
[[nodiscard]] geom::Contour contour_of(Run&, const std::vector<Captured>& elements);
[[nodiscard]] bool is_known(const geom::Contour&);
/// The areas that CONTOUR DEF, or DECLARE CONTOUR with formulas, say (contour_formula.cpp); nothing after a complaint.
[[nodiscard]] std::optional<std::vector<ContourLayer>> chosen_layers(Run&, const cycles::Demand&);

}  // namespace obrys::interp
