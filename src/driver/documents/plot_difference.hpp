#pragma once
/// The ways of two programs around the first move in which they differ.

#include <optional>

#include "driver/compare_stock.hpp"
#include "report/path_plot.hpp"

namespace obrys::driver {

/// Runs both anew and keeps some moves before and behind that place. Nothing where the motion does not differ. A
/// lathe's in the plane of Z and X, else from above and from the side; mm.
[[nodiscard]] std::optional<report::PathPlot> plot_difference(const ComparedSide& a, const ComparedSide& b,
                                                              const compare::Result& moves, double same_place);

}  // namespace obrys::driver
