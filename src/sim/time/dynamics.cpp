#include "sim/time/dynamics.hpp"

#include <algorithm>
#include <cmath>

#include "base/whole.hpp"
#include "motion/rapid_way.hpp"

namespace obrys::sim::time {
namespace {

/// HEIDENHAIN's default path jerk is 40 m/s3; 1 m/s2 is what a small mill of the time does: shared spec physics.md. How
/// long a tool change and an M function take differs much: the sizes of such a mill.
constexpr double usual_acceleration = 1000, usual_jerk = 40'000, usual_tolerance = 0.01, usual_spindle_time = 0.3,
                 usual_window = 0.01, usual_tool_change = 5, usual_strobe = 0.05, usual_rapid = 10'000;

class Reader {
public:
    Reader(const shop::Machine& m, shop::RapidPath rapids) : machine_(m), rapids_(rapids) {}

    Dynamics read() {
        const shop::MachineMotion& m = machine_.motion;
        d_.path.acceleration = take(m.acceleration, usual_acceleration, "motion.acceleration", "mm/s2");
        d_.path.jerk = take(m.jerk, usual_jerk, "motion.jerk", "mm/s3");
        d_.tolerance = take(m.tolerance, usual_tolerance, "motion.tolerance", "mm");
        d_.block_time = take(m.block_time, 0, "motion.block_time", "s");
        d_.look_ahead = base::clipped<std::size_t>(take(m.look_ahead, 0, "motion.look_ahead", "blocks, 0: without end"),
                                                   0, 1'000'000'000);
        d_.spindle_time = take(m.spindle_time, usual_spindle_time, "motion.spindle_time", "s for 1000 1/min");
        read_stops();
        d_.tool_change = take(machine_.tool_change_time, usual_tool_change, "tool_change_time", "s");
        d_.highest_speed = machine_.spindle.max;
        if (std::isfinite(machine_.spindle.max)) say("spindle.max", machine_.spindle.max, "1/min");
        if (machine_.max_feed > 0) {
            d_.most_feed = machine_.max_feed / 60;
            say("max_feed", machine_.max_feed, "mm/min");
        }
        for (std::size_t i = 0; i < 3; ++i) d_.axes[i] = axis(std::string(1, "XYZ"[i]));
        for (const shop::MachineAxis& a : machine_.axes)
            if (a.name != "X" && a.name != "Y" && a.name != "Z") d_.others[a.name] = axis(a.name);
        return d_;
    }

private:
    void read_stops() {
        const shop::MachineMotion& m = machine_.motion;
        d_.corner = m.corner ? corner(*m.corner) : CornerMode::filter;
        add("motion.corner", NAN, std::string(corner_names[static_cast<std::size_t>(d_.corner)]), m.corner.has_value());
        d_.servo_gain = take(m.servo_gain, 0, "motion.servo_gain", "1/s, 0: no lag");
        if (d_.servo_gain > 0) d_.window = take(m.window, usual_window, "motion.window", "mm");
        d_.strobe_time = take(m.strobe_time, usual_strobe, "motion.strobe_time", "s");
        const shop::RapidPath path = motion::rapid_path(machine_, rapids_);
        d_.dog_leg = path == shop::RapidPath::dog_leg;
        const bool known = machine_.rapid_path || path != shop::RapidPath::either;
        add("rapid", NAN, d_.dog_leg ? "dog-leg" : "straight", known, machine_.rapid_path ? "" : "the control");
    }

    static CornerMode corner(shop::CornerPassing c) {
        switch (c) {
            case shop::CornerPassing::exact_stop: return CornerMode::exact_stop;
            case shop::CornerPassing::filter: return CornerMode::filter;
            case shop::CornerPassing::blend: return CornerMode::blend;
        }
        return CornerMode::filter;
    }

    [[nodiscard]] std::string origin_of(const std::string& name) const {
        const auto own = machine_.origins.find(name);
        if (own != machine_.origins.end()) return own->second;
        const std::size_t dot = name.find('.'), last = name.rfind('.');
        const auto all = machine_.origins.find(dot == last ? name : "axis" + name.substr(last));
        return all == machine_.origins.end() ? "" : all->second;
    }

    void add(const std::string& name, double value, const std::string& unit, bool said, const char* otherwise = "") {
        std::string origin = said ? origin_of(name) : "assumed";
        if (origin.empty()) origin = *otherwise != 0 ? otherwise : "the machine file";
        const bool assumed = origin.starts_with("assumed");
        d_.values.push_back({name, value, unit, std::move(origin), assumed});
    }
    void say(const std::string& name, double value, const char* unit) { add(name, value, unit, true); }

    double take(const std::optional<double>& said, double usual, const char* name, const char* unit) {
        add(name, said.value_or(usual), unit, said.has_value());
        return said.value_or(usual);
    }

    AxisLimits axis(const std::string& name) {
        const auto found = std::find_if(machine_.axes.begin(), machine_.axes.end(),
                                        [&](const shop::MachineAxis& a) { return a.name == name; });
        AxisLimits limits{usual_rapid / 60, d_.path.acceleration, d_.path.jerk};
        if (found == machine_.axes.end()) return limits;
        const std::string key = "axis." + name + ".";
        say(key + "rapid", found->rapid, found->rotary ? "degrees/min" : "mm/min");
        if (found->acceleration)
            say(key + "acceleration", *found->acceleration, found->rotary ? "degrees/s2" : "mm/s2");
        if (found->jerk) say(key + "jerk", *found->jerk, found->rotary ? "degrees/s3" : "mm/s3");
        limits.speed = found->rapid / 60;
        // An axis that says nothing of its own goes as the path does; a rotary one as many degrees as the path mm.
        limits.acceleration = found->acceleration.value_or(limits.acceleration);
        limits.jerk = found->jerk.value_or(limits.jerk);
        return limits;
    }

    const shop::Machine& machine_;
    shop::RapidPath rapids_;
    Dynamics d_;
};

}  // namespace

Dynamics dynamics_of(const shop::Machine& machine, shop::RapidPath rapids) { return Reader(machine, rapids).read(); }

double settling_time(double speed, double gain, double window) {
    if (!(gain > 0) || !(window > 0)) return 0;
    return std::max(0.0, std::log(speed / (gain * window)) / gain);
}

WayLimits along(const Dynamics& d, const geom::Vec3& direction) {
    WayLimits w{INFINITY, d.path};
    const std::array<double, 3> part{std::abs(direction.x), std::abs(direction.y), std::abs(direction.z)};
    for (std::size_t i = 0; i < 3; ++i) {
        if (!(part[i] > 1e-9)) continue;
        w.speed = std::min(w.speed, d.axes[i].speed / part[i]);
        w.limits.acceleration = std::min(w.limits.acceleration, d.axes[i].acceleration / part[i]);
        w.limits.jerk = std::min(w.limits.jerk, d.axes[i].jerk / part[i]);
    }
    return w;
}

}  // namespace obrys::sim::time
