/// System variables about tools, transformations and the machine's travel (SYSREAD).

#include <cmath>

#include "base/whole.hpp"
#include "interp/values/values.hpp"

namespace obrys::interp {

using program::Expr;
using program::SystemVariable;

namespace {

double index_of(Reckoning& run, const Expr& e) { return e.count == 0 ? 0 : number(run, run.unit().children[e.b]); }

/// The tool [n]; 0: the one in the spindle.
const shop::Tool* tool_of(Reckoning& run, const Expr& e) {
    const double n = index_of(run, e);
    if (n == 0) return run.tool.data;
    for (const shop::Tool& t : run.tools)
        if (t.number == n) return &t;
    return nullptr;
}

std::optional<double> not_zero(double v) { return v != 0 ? std::optional(v) : std::nullopt; }

std::optional<double> column(const shop::Tool& t, SystemVariable v) {
    switch (v) {
        case SystemVariable::table_length: return not_zero(t.length);
        case SystemVariable::table_radius: return t.has_no_radius ? std::optional(t.radius) : not_zero(t.radius);
        case SystemVariable::table_corner_radius: return t.corner_radius;
        case SystemVariable::table_delta_length: return t.delta_length;
        case SystemVariable::table_delta_radius: return t.delta_radius;
        case SystemVariable::table_delta_corner: return t.delta_corner_radius;
        default: return std::nullopt;
    }
}

std::optional<double> known(double v) { return std::isnan(v) ? std::nullopt : std::optional(v); }

std::optional<double> of_tool(const Reckoning& run, SystemVariable v) {
    const auto of_call = [&](double delta) { return run.tool.known ? std::optional(delta) : std::nullopt; };
    switch (v) {
        case SystemVariable::prepared_tool:
            return run.tool.selected ? std::optional<double>(*run.tool.selected) : std::nullopt;
        case SystemVariable::call_delta_length: return of_call(run.tool.delta_length);
        case SystemVariable::call_delta_radius: return of_call(run.tool.delta_radius);
        case SystemVariable::call_delta_corner: return of_call(run.tool.delta_corner);
        case SystemVariable::active_radius: return known(active_radius(run));
        case SystemVariable::active_length: return known(gauge_length(run));
        default: return std::nullopt;
    }
}

std::optional<double> of_axis(Reckoning& run, const Expr& e, SystemVariable v) {
    const std::string axis = axis_of(run, e.count == 0 ? program::no_expr : run.unit().children[e.b]);
    if (v == SystemVariable::travel_min || v == SystemVariable::travel_max) {
        const shop::MachineAxis* known = machine_axis(run, axis);
        if (known == nullptr) return std::nullopt;
        return v == SystemVariable::travel_min ? known->min : known->max;
    }
    const auto k = axis.size() == 1 ? std::string_view("XYZ").find(axis[0]) : std::string_view::npos;
    if (k == std::string_view::npos) return std::nullopt;
    for (const Transform& t : run.modal.transforms) {
        if (v == SystemVariable::shift_of_axis && t.kind == TransformKind::shift)
            return coordinate(t.frame.origin, static_cast<int>(k));
        if (v == SystemVariable::scale_of_axis && t.kind == TransformKind::scaling) return t.frame.linear[0];
    }
    return v == SystemVariable::shift_of_axis ? 0 : 1;
}

std::optional<double> of_run(const Reckoning& run, SystemVariable v) {
    switch (v) {
        case SystemVariable::inch_program: return run.modal.inch_geometry ? 1 : 0;
        case SystemVariable::tool_axis: return known(control_value(run, program::ControlValue::tool_axis));
        case SystemVariable::spindle_state: return known(control_value(run, program::ControlValue::spindle_state));
        case SystemVariable::coolant_state: return known(control_value(run, program::ControlValue::coolant_state));
        case SystemVariable::active_rotation:
            for (const Transform& t : run.modal.transforms)
                if (t.kind == TransformKind::rotation) {
                    const PlaneAxes a = plane_axes(run.modal.plane);
                    geom::Vec3 u;
                    coordinate(u, a.u) = 1;
                    const geom::Vec3 turned = geom::apply_direction(t.frame, u);
                    return geom::degrees(std::atan2(coordinate(turned, a.v), coordinate(turned, a.u)));
                }
            return 0;
        case SystemVariable::active_datum:
            if (run.modal.datum != program::no_datum) return run.modal.datum - run.traits->datum.first;
            return run.traits->datum.none_is_machine_zero ? std::optional<double>(0) : std::nullopt;
        default: return std::nullopt;
    }
}

}  // namespace

std::optional<double> tool_or_frame(Reckoning& run, const Expr& e) {
    const auto v = static_cast<SystemVariable>(e.op);
    if (v >= SystemVariable::table_length && v <= SystemVariable::table_delta_corner) {
        const shop::Tool* t = tool_of(run, e);
        return t == nullptr ? std::nullopt : column(*t, v);
    }
    const bool by_axis = v == SystemVariable::shift_of_axis || v == SystemVariable::scale_of_axis ||
                         v == SystemVariable::travel_min || v == SystemVariable::travel_max;
    if (by_axis) return of_axis(run, e, v);
    if (const auto found = of_tool(run, v)) return found;
    return of_run(run, v);
}

int tool_parameter_number(const std::string& name) {
    int n = 0;
    for (std::size_t i = name.find_last_not_of("0123456789") + 1; i < name.size() && n < 1000; ++i)
        n = n * 10 + (name[i] - '0');
    return n;
}

}  // namespace obrys::interp
