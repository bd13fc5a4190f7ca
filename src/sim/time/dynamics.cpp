#include "sim/time/dynamics.hpp"

#include <algorithm>
#include <cmath>

#include "base/whole.hpp"

namespace obrys::sim::time {
namespace {

/// HEIDENHAIN's default path jerk is 40 m/s3; 1 m/s2 is what a small mill of the time does: shared spec physics.md.
constexpr double usual_acceleration = 1000, usual_jerk = 40'000, usual_tolerance = 0.01, usual_spindle_time = 0.3;

class Reader {
public:
    explicit Reader(const shop::Machine& m) : machine_(m) {}

    Dynamics read() {
        const shop::MachineMotion& m = machine_.motion;
        d_.path.acceleration = take(m.acceleration, usual_acceleration, "motion.acceleration", "mm/s2");
        d_.path.jerk = take(m.jerk, usual_jerk, "motion.jerk", "mm/s3");
        d_.tolerance = take(m.tolerance, usual_tolerance, "motion.tolerance", "mm");
        d_.block_time = take(m.block_time, 0, "motion.block_time", "s");
        d_.look_ahead = base::clipped<std::size_t>(take(m.look_ahead, 0, "motion.look_ahead", "blocks, 0: without end"),
                                                   0, 1'000'000'000);
        d_.spindle_time = take(m.spindle_time, usual_spindle_time, "motion.spindle_time", "s for 1000 1/min");
        d_.corner = m.corner ? corner(*m.corner) : CornerMode::filter;
        if (!m.corner) d_.assumed.push_back({"motion.corner", NAN, "filter"});
        d_.tool_change = machine_.tool_change_time;
        if (!(d_.tool_change > 0)) d_.assumed.push_back({"tool_change_time", 0, "s"});
        d_.highest_speed = machine_.spindle.max;
        if (machine_.max_feed > 0) d_.most_feed = machine_.max_feed / 60;
        for (std::size_t i = 0; i < 3; ++i) d_.axes[i] = axis(std::string(1, "XYZ"[i]));
        for (const shop::MachineAxis& a : machine_.axes)
            if (a.name != "X" && a.name != "Y" && a.name != "Z") d_.others[a.name] = axis(a.name);
        return d_;
    }

private:
    static CornerMode corner(shop::CornerPassing c) {
        switch (c) {
            case shop::CornerPassing::exact_stop: return CornerMode::exact_stop;
            case shop::CornerPassing::filter: return CornerMode::filter;
            case shop::CornerPassing::blend: return CornerMode::blend;
        }
        return CornerMode::filter;
    }

    double take(const std::optional<double>& said, double usual, const char* name, const char* unit) {
        if (said) return *said;
        d_.assumed.push_back({name, usual, unit});
        return usual;
    }

    AxisLimits axis(const std::string& name) {
        const auto found = std::find_if(machine_.axes.begin(), machine_.axes.end(),
                                        [&](const shop::MachineAxis& a) { return a.name == name; });
        AxisLimits limits{10'000.0 / 60, d_.path.acceleration, d_.path.jerk};
        if (found == machine_.axes.end()) return limits;
        limits.speed = found->rapid / 60;
        // An axis that says nothing of its own goes as the path does; a rotary one as many degrees as the path mm.
        limits.acceleration = found->acceleration.value_or(limits.acceleration);
        limits.jerk = found->jerk.value_or(limits.jerk);
        return limits;
    }

    const shop::Machine& machine_;
    Dynamics d_;
};

}  // namespace

Dynamics dynamics_of(const shop::Machine& machine) { return Reader(machine).read(); }

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
