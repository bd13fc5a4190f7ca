#pragma once
/// Values of a machine by the names of its file, for questions of what another value would do.

#include <optional>
#include <string_view>

#include "sim/time/dynamics.hpp"

namespace obrys::sim::time {

/// Sets a number: "motion.jerk", "tool_change_time", "axis.X.rapid" …, in the units of machine files; axes that follow
/// the path go on to follow it. False: there is no such value, or it cannot be this.
bool set_value(Dynamics& d, std::string_view name, double value);
/// As it stands; nothing: there is no such value.
[[nodiscard]] std::optional<double> value_of(const Dynamics& d, std::string_view name);

}  // namespace obrys::sim::time
