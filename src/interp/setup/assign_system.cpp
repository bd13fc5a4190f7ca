/// Assignments to system variables: frames, tool data, and what is only kept.

#include <algorithm>
#include <cmath>

#include "base/codes.hpp"
#include "base/whole.hpp"
#include "interp/setup/setup.hpp"

namespace obrys::interp {

using program::Expr;
namespace codes = base::codes;

namespace {

std::uint64_t system_key(Reckoning& run, const Expr& e) { return (std::uint64_t{e.a} << 32) ^ undefined_key(run, e); }

void assign_frame(Telling& run, const Expr& target, const program::Assign& a) {
    if (!(active_plane(run) == geom::Frame{}))
        return unchecked(run, codes::unsupported, run.unit().span(a.target),
                         "a frame that is assigned under a tilted plane is not followed", "write TRANS and AROT");
    if (is_component(run, target)) {
        geom::Frame frame = run.modal.programmed;
        write_component(run, target, frame, a.value);
        if (run.stopped || frame == run.modal.programmed) return;
        run.modal.programmed = frame;
        return update_frame(run);
    }
    const Value v = evaluate(run, a.value);
    if (run.stopped) return;
    if (v.is_unknown() && target.count == 0) {
        unchecked(run, codes::unknown_value, run.unit().span(a.value),
                  "this frame depends on a value that is not known: no position is known in it");
        run.modal.programmed = Value::unknown(Type::frame).as_frame();
        return update_frame(run);
    }
    if (v.type != Type::frame || target.count > 0) {
        unchecked(run, codes::unsupported, run.unit().span(a.target), "single components of a frame cannot be written",
                  "write the whole frame, e.g. $P_PFRAME=CTRANS(X,10)");
        return;
    }
    run.modal.programmed = v.as_frame();
    update_frame(run);
}

/// A dimension of tool [n]; 0: of the one in the spindle.
void write_tool_column(Reckoning& run, const Expr& target, const program::Assign& a, double value) {
    using program::SystemVariable;
    const double n = target.count == 0 ? 0 : number(run, run.unit().children[target.b]);
    const auto found = std::find_if(run.tools.begin(), run.tools.end(),
                                    [&](const shop::Tool& t) { return t.number == (n == 0 ? run.tool.number : n); });
    if (run.stopped) return;
    if (found == run.tools.end() || std::isnan(value)) {
        unchecked(run, codes::unknown_value, run.unit().span(a.target),
                  "this tool, or what its table shall hold, is not known: nothing is written");
        return;
    }
    const double mm = run.modal.inch_geometry ? value * 25.4 : value;
    switch (static_cast<SystemVariable>(target.op)) {
        case SystemVariable::table_length: found->length = mm; break;
        case SystemVariable::table_radius: found->radius = mm; break;
        case SystemVariable::table_corner_radius: found->corner_radius = mm; break;
        case SystemVariable::table_delta_length: found->delta_length = mm; break;
        case SystemVariable::table_delta_radius: found->delta_radius = mm; break;
        default: found->delta_corner_radius = mm; break;
    }
    if (run.env.machine.kind == shop::MachineKind::mill) compare_with_job(run, *found);
}

/// $A_OUT[n]=, $A_OUTA[n]=: at once, between two blocks.
void write_output(Telling& run, const Expr& target, const program::Assign& a, const Value& v, bool analog) {
    const std::string& name = run.env.names.text(target.a);
    const double index = target.count == 1 ? number(run, run.unit().children[target.b]) : NAN;
    if (run.stopped) return;
    const auto n = base::whole<std::uint32_t>(index, 1, 1'000'000);
    if (!n && !std::isnan(index))
        return alarm(run, codes::index_range, run.unit().span(a.target),
                     "there is no output " + name + "[" + printed(Value::real(index)) + "]");
    if (!n || !v.is_number() || v.is_unknown())
        return unchecked(run, codes::unknown_value, run.unit().span(a.target),
                         "which output " + name + " sets here, and to what, depends on a value that is not known");
    emit(run, cl::Output{*n, analog, analog ? v.number : v.number != 0 ? 1.0 : 0.0, false});
}

/// Writing it may change what the control does, which is not followed: all but what is only read back.
bool acts_when_written(program::SystemVariable v) {
    using program::SystemVariable;
    return v != SystemVariable::tool_parameter && v != SystemVariable::tool_name && v != SystemVariable::marker &&
           v != SystemVariable::parameter && v != SystemVariable::timer;
}

}  // namespace

void assign_system(Telling& run, const Expr& target, const program::Assign& a) {
    using program::SystemVariable;
    switch (static_cast<SystemVariable>(target.op)) {
        case SystemVariable::programmed_frame: assign_frame(run, target, a); return;
        case SystemVariable::numbered_parameter:
            if (target.count == 1) {
                const double n = number(run, run.unit().children[target.b]);
                if (!run.stopped && n >= 0 && n < run.parameters.count())
                    run.parameters.set(base::clipped<std::uint32_t>(n, 0, run.parameters.count() - 1),
                                       number(run, a.value));
                else if (!run.stopped)
                    alarm(run, codes::index_range, run.unit().span(a.target),
                          "there is no parameter " + printed(Value::real(n)));
            }
            return;
        case SystemVariable::datum_frame:
        case SystemVariable::settable_frame:
        case SystemVariable::base_frame:
        case SystemVariable::active_frame:
            unchecked(run, codes::unsupported, run.unit().span(a.target),
                      "writing " + run.env.names.text(target.a) + " is not run",
                      "give the zero offsets in [datum] of the job");
            return;
        default: break;
    }
    const Value v = evaluate(run, a.value);
    if (run.stopped) return;
    const auto column = static_cast<SystemVariable>(target.op);
    if (column >= SystemVariable::table_length && column <= SystemVariable::table_delta_corner)
        return write_tool_column(run, target, a, v.number);
    run.system_written[system_key(run, target)] = v;
    if (static_cast<SystemVariable>(target.op) == SystemVariable::tool_parameter && target.count >= 1) {
        const double tool = number(run, run.unit().children[target.b]);
        const double edge = target.count > 1 ? number(run, run.unit().children[target.b + 1]) : 1;
        const int n = tool_parameter_number(run.env.names.text(target.a));
        if (!run.stopped && v.is_number()) write_tool_parameter(run, tool, edge, n, v.number);
    }
    if (column == SystemVariable::digital_output || column == SystemVariable::analog_output)
        return write_output(run, target, a, v, column == SystemVariable::analog_output);
    if (acts_when_written(static_cast<SystemVariable>(target.op)))
        unchecked(run, codes::unknown_value, run.unit().span(a.target),
                  "the effect of writing " + run.env.names.text(target.a) + " is not known");
}

}  // namespace obrys::interp
