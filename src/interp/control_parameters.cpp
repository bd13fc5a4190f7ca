/// Numbered parameters that the control itself sets while a program runs (program::Traits::set_by_control).

#include <algorithm>
#include <limits>

#include "interp/run.hpp"

namespace obrys::interp {

using program::ControlValue;

namespace {

constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

double tool_size(const Run& run, bool radius) {
    const shop::Tool* t = run.tool.data;
    const bool none = run.tool.number == 0 && run.tool.name.empty() && run.tool.edge != 0;  // TOOL CALL 0
    if (t == nullptr && !none) return unknown;
    const double own = t == nullptr ? 0 : radius ? t->radius + t->delta_radius : t->length + t->delta_length;
    const double mm = own + (radius ? run.tool.delta_radius : run.tool.delta_length);
    return run.modal.inch_geometry ? mm / 25.4 : mm;
}

double spindle_state(const SpindleState& s) {
    if (s.direction != 0) return s.direction > 0 ? 0 : 1;
    return s.last == 0 ? -1 : s.last > 0 ? 2 : 3;
}

double value_of(const Run& run, ControlValue v) {
    switch (v) {
        case ControlValue::tool_radius: return tool_size(run, true);
        case ControlValue::tool_length: return tool_size(run, false);
        case ControlValue::tool_axis: return run.modal.plane == 17 ? 2 : run.modal.plane == 18 ? 1 : 0;
        case ControlValue::spindle_state: return spindle_state(run.spindle);
        case ControlValue::coolant_state: return run.coolant_on ? 1 : 0;
        case ControlValue::main_unit: return run.calls.front().unit->inch ? 1 : 0;
        default: return unknown;  // of the machine's settings, its kinematics, or measured
    }
}

void write(Run& run, const program::ControlParameter& p, double v) {
    if (p.number < run.parameters.count() && run.parameter_overridden[p.number] == 0)
        run.parameters.set_by_control(p.number, v);
}

}  // namespace

void control_sets(Run& run, std::initializer_list<ControlValue> which) {
    for (const program::ControlParameter& p : run.traits->set_by_control)
        if (std::find(which.begin(), which.end(), p.value) != which.end()) write(run, p, value_of(run, p.value));
}

void control_sets_all(Run& run) {
    for (const program::ControlParameter& p : run.traits->set_by_control)
        write(run, p, p.value == ControlValue::tool_axis ? -1 : value_of(run, p.value));
}

}  // namespace obrys::interp
