#pragma once
/// What contour cycles work on. Private to interp.

#include <optional>

#include "cycles/contour.hpp"
#include "geom/contour.hpp"
#include "interp/capture.hpp"

namespace obrys::interp {

/// The contours in force, in plane coordinates of the programmed frame; nothing after a complaint.
[[nodiscard]] std::optional<cycles::ContourTask> contour_task(Run&, const cycles::Demand&);

/// The first element goes to the contour's start; the others are the contour, with their chamfers and roundings.
[[nodiscard]] geom::Contour contour_of(Run&, const std::vector<Captured>& elements);
[[nodiscard]] bool is_known(const geom::Contour&);
/// The area that CONTOUR DEF, or DECLARE CONTOUR with formulas, say (contour_formula.cpp); nothing after a complaint.
[[nodiscard]] std::optional<geom::Region> chosen_area(Run&, const cycles::Demand&);

}  // namespace obrys::interp
