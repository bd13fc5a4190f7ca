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

/// A value that the machine file does not say.
struct Assumed {
    std::string name;  ///< as its key in machine files
    double value = 0;
    std::string unit;
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
    double highest_speed = INFINITY;  ///< of the spindle, 1/min
    double most_feed = INFINITY;      ///< mm/s
    std::vector<Assumed> assumed;
};

[[nodiscard]] Dynamics dynamics_of(const shop::Machine& machine);

/// What the axes allow along a direction.
struct WayLimits {
    double speed = 0;
    Limits limits;
};
[[nodiscard]] WayLimits along(const Dynamics& d, const geom::Vec3& direction);

}  // namespace obrys::sim::time
