#pragma once
/// How high material stands over the lower end of a tool, all along its way: on the axis itself, where a point is
/// lowest and beside which rays stand. Frame of the stock, mm.

#include <cstdint>

#include "geom/interpolation.hpp"
#include "sim/milling/cut/simulation.hpp"

namespace obrys::check {

struct TipStack {
    double height = 0;  ///< from its lower to its upper end; 0: there is none
    geom::Vec3 foot;    ///< its lower end
};

struct TipWay {
    std::uint32_t number = 0;  ///< of the pass; what was cut before it is not there
    const geom::PathElement& path;
    geom::Vec3 axis;              ///< unit length
    sim::milling::Heights along;  ///< of what cuts, from the programmed point
};
/// The highest of many places along the way; each as high as it is, to a ten-thousandth of a millimetre. From several
/// threads at once.
[[nodiscard]] TipStack highest_over_tip(const sim::milling::Simulation& simulation, const TipWay& way);

}  // namespace obrys::check
