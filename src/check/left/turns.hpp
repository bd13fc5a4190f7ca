#pragma once
/// What full turns of a tool have taken, as bodies of their own. No single quarter of a circle and no chord of a helix
/// holds a body that stands in the middle of the turn; all of them together hold a cylinder about its axis, or a ring.
/// On the safe side: chords lie within their circle. Frame of the stock, millimetres.

#include <deque>

#include "sim/milling/cut/air.hpp"

namespace obrys::check {

struct LeftTurns {
    std::deque<sim::milling::Shape> shapes;  ///< of the sweeps, which point at them
    std::deque<sim::milling::Air::Sweep> sweeps;
};

/// Of sweeps in the program's order: each turn of ways that follow one another about one axis. Turns one above the
/// other are one body. Only what of a tool is a cylinder counts.
[[nodiscard]] LeftTurns turns_of(const std::deque<sim::milling::Air::Sweep>& sweeps);

}  // namespace obrys::check
