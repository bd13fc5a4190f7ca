#pragma once
/// What contour cycles work on. Private to interp.

#include <optional>

#include "cycles/contour.hpp"
#include "interp/motion.hpp"

namespace obrys::interp {

/// The contours in force, in plane coordinates of the programmed frame; nothing after a complaint.
[[nodiscard]] std::optional<cycles::ContourTask> contour_task(Run&, const cycles::Demand&);

}  // namespace obrys::interp
