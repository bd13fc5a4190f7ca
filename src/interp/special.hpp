#pragma once
/// Blocks with data of their own (program/special.hpp). Private to interp.

#include <limits>

#include "interp/motion.hpp"

namespace obrys::interp {

/// Value of a datum of the block; `otherwise` where it was not written.
[[nodiscard]] double datum_of(Reckoning&, const program::Special&, program::Datum, double otherwise = 0);
[[nodiscard]] bool has_datum(const program::Special&, program::Datum);

/// FL, FLT, FC, FCT, FPOL, FSELECT (free_contour.cpp).
void free_contour(Moving&, const program::Special&, std::uint32_t index);
/// PLANE (plane.cpp).
void plane(Moving&, const program::Special&);

}  // namespace obrys::interp
