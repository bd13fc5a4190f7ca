#include "sim/time/machine_value.hpp"

#include <cmath>
#include <type_traits>

#include "base/whole.hpp"

namespace obrys::sim::time {
namespace {

/// Axes that say nothing of their own follow the path.
void set_path(Dynamics& d, double value, double Limits::*path, double AxisLimits::*own) {
    const auto follow = [&](AxisLimits& l) { l.*own = l.*own == d.path.*path ? value : l.*own; };
    for (AxisLimits& l : d.axes) follow(l);
    for (auto& [axis, l] : d.others) follow(l);
    d.path.*path = value;
}

/// A plain number of the machine; null: it is none.
template <class D>
auto number_of(D& d, std::string_view name) -> decltype(&d.tolerance) {
    if (name == "tool_change_time") return &d.tool_change;
    if (name == "motion.tolerance") return &d.tolerance;
    if (name == "motion.block_time") return &d.block_time;
    if (name == "motion.spindle_time") return &d.spindle_time;
    if (name == "motion.servo_gain") return &d.servo_gain;
    if (name == "motion.window") return &d.window;
    if (name == "feed_override") return &d.feed_override;
    if (name == "motion.strobe_time") return &d.strobe_time;
    return nullptr;
}

template <class Axis>
struct OfAxis {
    Axis* axis = nullptr;
    std::string_view key;
};
template <class D>
auto axis_value(D& d, std::string_view name) -> OfAxis<std::remove_reference_t<decltype(d.axes[0])>> {
    const std::size_t last = name.rfind('.');
    if (!name.starts_with("axis.") || last < 5) return {};
    const std::string_view axis = name.substr(5, last - 5), key = name.substr(last + 1);
    for (std::size_t i = 0; i < 3; ++i)
        if (axis == std::string_view("XYZ").substr(i, 1)) return {&d.axes[i], key};
    const auto other = d.others.find(std::string(axis));
    return {other == d.others.end() ? nullptr : &other->second, key};
}

}  // namespace

bool set_value(Dynamics& d, std::string_view name, double value) {
    if (!std::isfinite(value) || value < 0) return false;
    if (name == "motion.look_ahead") {
        d.look_ahead = base::clipped<std::size_t>(value, 0, 1'000'000'000);
        return true;
    }
    const bool may_be_nothing = name == "motion.block_time" || name == "motion.spindle_time" ||
                                name == "motion.servo_gain" || name == "motion.strobe_time" ||
                                name == "tool_change_time";
    if (value == 0 && !may_be_nothing) return false;
    if (name == "motion.servo_gain" && !(d.window > 0)) d.window = 0.01;
    if (double* number = number_of(d, name)) return *number = value, true;
    if (name == "motion.acceleration")
        return set_path(d, value, &Limits::acceleration, &AxisLimits::acceleration), true;
    if (name == "motion.jerk") return set_path(d, value, &Limits::jerk, &AxisLimits::jerk), true;
    if (name == "max_feed") return d.most_feed = value / 60, true;
    const auto of = axis_value(d, name);
    if (of.axis == nullptr) return false;
    if (of.key == "rapid") return of.axis->speed = value / 60, true;
    if (of.key == "acceleration") return of.axis->acceleration = value, true;
    if (of.key == "jerk") return of.axis->jerk = value, true;
    return false;
}

std::optional<double> value_of(const Dynamics& d, std::string_view name) {
    if (name == "motion.look_ahead") return static_cast<double>(d.look_ahead);
    if (const double* number = number_of(d, name)) return *number;
    if (name == "motion.acceleration") return d.path.acceleration;
    if (name == "motion.jerk") return d.path.jerk;
    if (name == "max_feed") return d.most_feed * 60;
    const auto of = axis_value(d, name);
    if (of.axis == nullptr) return {};
    if (of.key == "rapid") return of.axis->speed * 60;
    if (of.key == "acceleration") return of.axis->acceleration;
    if (of.key == "jerk") return of.axis->jerk;
    return {};
}

}  // namespace obrys::sim::time
