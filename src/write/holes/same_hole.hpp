#pragma once
/// The same hole by cycles of other kinds: a hole that one control's cycle says by a retract plane and a bottom (G81),
/// another's says by a surface, a clearance and a depth (CYCL DEF 200). Lengths in mm along the tool's axis, upwards
/// positive, in the plane of the cycle; feeds in mm/min. What the control then does is for the proof to say.

#include <optional>
#include <vector>

#include "cl/record.hpp"
#include "motion/state.hpp"

namespace obrys::write {

/// A way of saying a hole.
struct HoleWay {
    cl::Cycle cycle;
    std::optional<double> speed{};  ///< 1/min, with which a tap turns, where the cycle takes the one in force
    std::optional<double> feed{};   ///< mm/min, where the cycle takes the one in force; nothing: that it is in force
};

/// Others than `cycle` itself; none where it is no hole of a plain kind, or something of it is not known. `state`:
/// before the cycle.
[[nodiscard]] std::vector<HoleWay> same_hole(const cl::Cycle& cycle, const motion::State& state);

}  // namespace obrys::write
