#pragma once
/// Places where a simulated surface seems to leave the part are looked at again on finer rays.

#include <functional>

#include "mesh/compare.hpp"
#include "sim/milling/simulation.hpp"

namespace obrys::check {

/// Takes out what is not there when it is looked at more closely, and gives what stays its depth from exact points
/// where that is less, and as `peak` the tags of those that lie nearly as far off as the worst, by their number. Places
/// too large to be looked at closely stay as they are.
void confirm(mesh::Comparison& found, const mesh::Mesh& surface, const sim::milling::Simulation& simulation,
             const mesh::Distance& part, const mesh::CompareOptions& options,
             const std::function<std::uint32_t(std::uint32_t cut)>& tag_of);

}  // namespace obrys::check
