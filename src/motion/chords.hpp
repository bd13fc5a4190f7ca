#pragma once
/// Curves as the straight lines of their chords.

#include <cstddef>

#include "base/function_ref.hpp"
#include "cl/recording.hpp"

namespace obrys::motion {

/// The stream with straight lines in the place of the arcs and splines that are `wanted`, none farther than `tolerance`
/// (mm) from its curve. How many they were. What they cannot say stays a curve: one under radius compensation or at
/// rapid, one that takes axes along or turns the tool, a time for each move (inverse time), a stop behind each.
std::size_t take_chords(const cl::Recording& stream, double tolerance,
                        base::FunctionRef<bool(const cl::Record&)> wanted, cl::Recording& out);

}  // namespace obrys::motion
