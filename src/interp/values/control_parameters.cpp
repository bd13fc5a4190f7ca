/// Numbered parameters that the control itself sets while a program runs (program::Traits::set_by_control).

#include <algorithm>
#include <cmath>

#include "interp/values/values.hpp"

namespace obrys::interp {

using program::ControlValue;

namespace {

bool no_tool(const Reckoning& run) {  // TOOL CALL 0
    return run.tool.data == nullptr && run.tool.number == 0 && run.tool.name.empty() && run.tool.edge != 0;
}

double spindle_state(const SpindleState& s) {
    if (s.direction != 0) return s.direction > 0 ? 0 : 1;
    return s.last == 0 ? unknown_number : s.last > 0 ? 2 : 3;  // which sense it had before the program: not known
}

void write(Reckoning& run, const program::ControlParameter& p, double v) {
    const bool of_machine = p.value == ControlValue::pocket_overlap || p.value == ControlValue::probed;
    if (of_machine && p.number < run.parameters.count() && run.parameters.is_set(p.number)) return;  // by the job
    if (p.number < run.parameters.count() && run.parameter_overridden[p.number] == 0)
        run.parameters.set_by_control(p.number, v);
}

}  // namespace

std::optional<double> compensation_radius(const shop::Tool& t) {
    if (t.kind == shop::ToolKind::turning) return t.nose_radius;
    if (t.kind == shop::ToolKind::groove) return t.corner_radius;
    return mill_radius(t);
}

std::optional<double> mill_radius(const shop::Tool& t) {
    return t.radius > 0 || t.has_no_radius ? std::optional(t.radius + t.delta_radius) : std::nullopt;
}

double active_radius(const Reckoning& run) {
    const auto own = run.tool.data == nullptr ? std::nullopt : mill_radius(*run.tool.data);
    return own.value_or(no_tool(run) ? 0 : unknown_number) + run.tool.delta_radius;
}

double active_length(const Reckoning& run) {
    const shop::Tool* t = run.tool.data;
    const double own = t != nullptr ? t->length + t->delta_length : no_tool(run) ? 0 : unknown_number;
    return own + run.tool.delta_length;
}

double gauge_length(const Reckoning& run) {
    const shop::Tool* t = run.tool.data;
    return t != nullptr && t->length == 0 ? unknown_number : active_length(run);
}

double control_value(const Reckoning& run, ControlValue v) {
    switch (v) {
        case ControlValue::tool_radius: return active_radius(run);
        case ControlValue::tool_length: return gauge_length(run);
        case ControlValue::tool_axis:
            if (!run.tool.known) return unknown_number;
            return run.modal.plane == 17 ? 2 : run.modal.plane == 18 ? 1 : 0;
        case ControlValue::spindle_state: return spindle_state(run.spindle);
        case ControlValue::coolant_state:
            return !run.modal.mist_said && !run.modal.flood_said ? unknown_number : run.coolant_on ? 1 : 0;
        case ControlValue::tilted_a: return run.tilted_axes[0];
        case ControlValue::tilted_b: return run.tilted_axes[1];
        case ControlValue::tilted_c: return run.tilted_axes[2];
        case ControlValue::main_unit: return run.calls.front().unit->inch ? 1 : 0;
        default: return unknown_number;  // of the machine's settings, its kinematics, or measured
    }
}

namespace {

/// Parameters hold lengths in the program's unit.
double value_of(const Reckoning& run, ControlValue v) {
    const bool length = v == ControlValue::tool_radius || v == ControlValue::tool_length;
    return control_value(run, v) / (length ? length_unit(run.modal) : 1);
}

}  // namespace

void control_sets(Reckoning& run, std::initializer_list<ControlValue> which) {
    for (const program::ControlParameter& p : run.traits->set_by_control)
        if (std::find(which.begin(), which.end(), p.value) != which.end()) write(run, p, value_of(run, p.value));
}

void control_sets_all(Reckoning& run) {
    for (const program::ControlParameter& p : run.traits->set_by_control) {
        const double v = value_of(run, p.value);
        if (std::isnan(v) && p.number < run.parameters.count() && run.parameters.is_set(p.number))
            continue;  // by the job
        write(run, p, v);
    }
}

}  // namespace obrys::interp
