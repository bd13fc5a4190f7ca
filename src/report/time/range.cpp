#include <cmath>
#include <string_view>

#include "report/time/time.hpp"

namespace obrys::report::time {

using sim::time::Cause;
using sim::time::Times;
using sim::time::Value;

namespace {

/// The causes whose seconds a value decides: with half of it they are twice as long, or half.
std::vector<Cause> decided_by(std::string_view name) {
    if (name == "motion.acceleration" || name == "motion.jerk" || name.ends_with(".acceleration") ||
        name.ends_with(".jerk"))
        return {Cause::acceleration, Cause::corner, Cause::curvature, Cause::look_ahead, Cause::exact_stop};
    if (name.ends_with(".rapid")) return {Cause::rapid, Cause::axis_speed};
    if (name == "motion.spindle_time") return {Cause::spindle};
    if (name == "motion.strobe_time") return {Cause::m_function};
    if (name == "tool_change_time") return {Cause::tool_change};
    return {};
}

}  // namespace

Range range_of(const Times& t, const std::vector<Value>& values) {
    std::array<bool, sim::time::causes> open{};
    double settling = 0;
    for (const Value& v : values) {
        if (!v.assumed) continue;
        if (v.name == "motion.servo_gain" && v.value == 0) settling = t.may_settle;
        for (const Cause c : decided_by(v.name)) open[static_cast<std::size_t>(c)] = true;
    }
    double undecided = 0;
    for (std::size_t i = 0; i < open.size(); ++i)
        if (open[i]) undecided += t.all[i];
    const double all = sim::time::sum(t.all);
    return {all - undecided / 2, all + undecided + settling};
}

}  // namespace obrys::report::time
