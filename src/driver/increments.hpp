#pragma once
/// How near a program can be written for a control that counts lengths in increments.

#include "cl/record.hpp"
#include "compare/compare.hpp"
#include "write/post.hpp"

namespace obrys::driver {

/// How far a step along each axis of a frame may lead along one of the workpiece: 1, more where a frame turns or
/// scales.
[[nodiscard]] double spread_of(const cl::Frame& frame);
/// A control that counts in increments rounds every coordinate to them. `spread`: the widest of the program's frames.
[[nodiscard]] compare::Tolerance as_control_counts(const write::Post& post, compare::Tolerance tolerance,
                                                   double spread);

}  // namespace obrys::driver
