#pragma once
/// How fast a machine's axes and its control are, as far as its file says it; what it leaves out is assumed, and
/// listed. mm, s; rotary axes degrees.

#include <array>
#include <map>
#include <string>
#include <vector>

#include "geom/vec.hpp"
#include "shop/machine.hpp"
#include "sim/time/corner.hpp"

namespace obrys::sim::time {

/// What a time rests on: a value of the machine, and where it is from.
struct Value {
    std::string name;  ///< as its key in machine files
    double value = 0;  ///< NaN: `unit` is the word
    std::string unit;
    std::string origin;    ///< in the words of the machine file
    bool assumed = false;  ///< the file does not say it, or says that it is assumed
};

struct AxisLimits {
    double speed = 0, acceleration = 0, jerk = 0;
};

struct Dynamics {
    std::array<AxisLimits, 3> axes{};          ///< X, Y, Z
    std::map<std::string, AxisLimits> others;  ///< rotary and additional ones, by name
    Limits path;
    double tolerance = 0;  ///< where the program says none
    CornerMode corner = CornerMode::filter;
    double block_time = 0;            ///< s that the control needs for a block; 0: none
    std::size_t look_ahead = 0;       ///< blocks; 0: without end
    double tool_change = 0;           ///< s
    double spindle_time = 0;          ///< s for 1000 1/min more or less
    double servo_gain = 0;            ///< 1/s; 0: no lag
    double window = 0;                ///< mm in which an axis counts as in position
    double strobe_time = 0;           ///< s for an M function
    double feed_override = 1;         ///< of all programmed feeds
    bool dog_leg = false;             ///< each axis goes at its own rapid
    double highest_speed = INFINITY;  ///< of the spindle, 1/min
    double most_feed = INFINITY;      ///< mm/s
    std::vector<Value> values;
};

/// `rapids`: how the control ends rapid moves of several axes, where the machine file does not say it.
[[nodiscard]] Dynamics dynamics_of(const shop::Machine& machine, shop::RapidPath rapids = shop::RapidPath::straight);

/// What an exact stop costs after motion at this speed: the lag falls by a factor e every 1 / `gain` s until the axis
/// is in its window. Source: shared spec physics.md (a) 6.
[[nodiscard]] double settling_time(double speed, double gain, double window);

/// What the axes allow along a direction.
struct WayLimits {
    double speed = 0;
    Limits limits;
};
[[nodiscard]] WayLimits along(const Dynamics& d, const geom::Vec3& direction);

}  // namespace obrys::sim::time
