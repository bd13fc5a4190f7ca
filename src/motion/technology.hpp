#pragma once
/// What feed and speed come to on a move. NaN where that is not known.

#include "motion/state.hpp"
#include "shop/machine.hpp"

namespace obrys::motion {

/// +1 clockwise, -1 counter-clockwise, 0: it stands, or has no speed.
[[nodiscard]] int turning_sense(const cl::Spindle& spindle);

/// Speed of the spindle, 1/min, with the reference point at `radius` mm from its axis, which counts under constant
/// cutting speed alone. `highest`: what the machine can do, 1/min.
[[nodiscard]] double spindle_speed(const cl::Spindle& spindle, double radius, double highest);

/// Seconds that `way` mm take at this feed; `speed`: of the spindle, 1/min.
[[nodiscard]] double feed_seconds(const cl::Feed& feed, double way, double speed);

/// Seconds that `way` mm take at the slowest linear axis' rapid.
[[nodiscard]] double rapid_seconds(const shop::Machine& machine, double way);

}  // namespace obrys::motion
