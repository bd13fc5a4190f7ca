#pragma once
/// Places where a simulated surface seems to leave the part are looked at again on finer rays.

#include <functional>

#include "check/gouge/thread_band.hpp"
#include "mesh/compare.hpp"
#include "sim/milling/cut/simulation.hpp"

namespace obrys::check {

/// What is known of a machined surface beside its triangles.
struct Machined {
    const mesh::Mesh& surface;
    const sim::milling::Simulation& simulation;
    const mesh::Distance& part;
    const ThreadBands& threads;
    std::function<std::uint32_t(std::uint32_t cut)> tag_of;
    std::function<bool()> stop;  ///< told to: what was not looked at stays as it is; may be empty
    std::function<bool(const mesh::Place& gouge)> is_none{};  ///< known otherwise not to be there; may be empty
};

/// Takes out what is proved (proof.hpp) not to be there, and gives what stays its depth from exact points where
/// that is less, and as `peak` the tags of those that lie nearly as far off as the worst, by their number. Large places
/// are looked at patch by patch, the worst first.
void confirm(mesh::Comparison& found, const Machined& machined, const mesh::CompareOptions& options);

}  // namespace obrys::check
