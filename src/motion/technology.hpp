#pragma once
/// What feed and speed come to on a move. NaN where that is not known.

#include "motion/cursor.hpp"
#include "shop/machine.hpp"

namespace obrys::motion {

/// +1 clockwise, -1 counter-clockwise, 0: it stands, or has no speed.
[[nodiscard]] int turning_sense(const cl::Spindle& spindle);

/// Speed of the spindle, 1/min, with the reference point at `radius` mm from its axis, which counts under constant
/// cutting speed alone. `highest`: what the machine can do, 1/min.
[[nodiscard]] double spindle_speed(const cl::Spindle& spindle, double radius, double highest);

/// Seconds that `way` mm take at this feed; `speed`: of the spindle, 1/min.
[[nodiscard]] double feed_seconds(const cl::Feed& feed, double way, double speed);

/// The same of a move at feed: at the spindle's speed on its mean radius, of a thread by its pitch.
[[nodiscard]] double feed_seconds(const Step& step, double way, double highest);

/// Seconds of a dwell, also of one in revolutions with the reference point at `radius` mm from the spindle's axis.
[[nodiscard]] double dwell_seconds(const cl::Dwell& dwell, const cl::Spindle& spindle, double radius, double highest);

/// Seconds that `way` mm take at the slowest linear axis' rapid.
[[nodiscard]] double rapid_seconds(const shop::Machine& machine, double way);

}  // namespace obrys::motion
