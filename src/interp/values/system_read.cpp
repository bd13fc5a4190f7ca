/// System variables. What the run cannot know is reported, never guessed in silence.

#include "base/codes.hpp"
#include "base/whole.hpp"
#include "interp/values/system_access.hpp"

namespace obrys::interp {

namespace codes = base::codes;
using program::Expr;
using program::SystemVariable;

Value unknown_value(const Access& a, const std::string& why, const std::string& also) {
    const bool numbered = a.name().starts_with('#'), has_key = numbered || a.name().starts_with('$');
    const std::string key = numbered ? a.name() : has_key ? variable_key(a.run, a.e) : std::string{};
    if (auto given = given_value(a.run, key)) return *given;
    unchecked(a.run, codes::unknown_value, a.where(), a.name() + ": " + why,
              std::string("what is computed from it is unknown too") + (also.empty() ? "" : "; " + also) +
                  (has_key ? "; " + given_remedy(key) : ""));
    return Value::unknown();
}

namespace {

Value tool_length(const Access& a) {
    const shop::Tool* t = a.run.tool.data;
    const double n = a.e.count == 0 ? 1 : a.index(0);
    if (t == nullptr) return unknown_value(a, "no tool data");
    if (const auto p = t->parameters.find(2 + base::cut<int>(n, 0, 9).value_or(-3)); p != t->parameters.end())
        return Value::real(p->second);
    if (n == 1 && t->length != 0) return Value::real(t->length);
    return unknown_value(a, "the tool list does not say it");
}

}  // namespace

std::optional<double> tool_radius(const shop::Tool& t) {
    if (t.kind == shop::ToolKind::turning) return t.nose_radius;
    if (t.kind == shop::ToolKind::groove) return t.corner_radius;
    return mill_radius(t) ? std::optional(t.radius) : std::nullopt;
}

Value tool_radius(const Access& a) {
    const shop::Tool* t = a.run.tool.data;
    const auto radius = t == nullptr ? std::nullopt : mill_radius(*t) ? mill_radius(*t) : tool_radius(*t);
    return radius ? Value::real(*radius) : unknown_value(a, "no tool data");
}

namespace {

const shop::Tool* addressed_tool(const Access& a) {
    const double number = a.index(0), edge = a.e.count > 1 ? a.index(1) : 1;
    for (const shop::Tool& t : a.run.tools)
        if (t.number == number && t.edge == edge) return &t;
    return nullptr;
}

/// $TC_DPn[T, D]; n is the digits at the end of the name. Meaning of n: Siemens, Function Manual W1 Tool offset.
Value tool_parameter(const Access& a) {
    const shop::Tool* t = addressed_tool(a);
    const int n = tool_parameter_number(a.name());
    const std::uint64_t key = (std::uint64_t{a.e.a} << 32) ^ undefined_key(a.run, a.e);
    if (const auto written = a.run.system_written.find(key); written != a.run.system_written.end())
        return written->second;
    if (t == nullptr) return unknown_value(a, "this tool is not in the tool list");
    if (const auto p = t->parameters.find(n); p != t->parameters.end()) return Value::real(p->second);
    if (const auto radius = tool_radius(*t); n == 6 && radius) return Value::real(*radius);
    if (n == 7 && mill_radius(*t)) return Value::real(t->corner_radius);
    if (n == 3 && t->length != 0) return Value::real(t->length);
    if (n == 2 && t->orientation != 0) return Value::real(t->orientation);
    return unknown_value(a, "the tool list does not say it");
}

std::uint64_t written_key(const Access& a) { return (std::uint64_t{a.e.a} << 32) ^ undefined_key(a.run, a.e); }

/// What the program wrote; before that what the control has kept.
Value written_or_kept(const Access& a) {
    const auto written = a.run.system_written.find(written_key(a));
    if (written != a.run.system_written.end()) return written->second;
    return unknown_value(a, "no program sets it before, and the control keeps what it held");
}

Value tool_exists(const Access& a) {
    const double n = a.index(0);
    if (n < 0 || a.run.tools.empty())
        return unknown_value(a, "the job gives no tool list, or which tool is meant is not known");
    for (const shop::Tool& t : a.run.tools)
        if (t.number == n) return Value::boolean(true);
    return Value::boolean(false);
}

Value tool_name(const Access& a) {
    const double n = a.index(0);
    if (n < 0 || a.run.tools.empty())
        return unknown_value(a, "the job gives no tool list, or which tool is meant is not known");
    for (const shop::Tool& t : a.run.tools)
        if (t.number == n && !t.name.empty()) return Value::string(t.name);
    return unknown_value(a, "the tool list has no such tool, or no name of it");
}

Value indexed_parameter(const Access& a) {
    const double n = a.index(0);
    if (n >= 0 && n < a.run.parameters.count()) return Value::real(parameter_value(a.run, n, a.where()));
    alarm(a.run, codes::index_range, a.where(), "there is no parameter R" + printed(Value::real(n)));
    return {};
}

bool is_frame(SystemVariable v) {
    return v == SystemVariable::programmed_frame || v == SystemVariable::active_frame ||
           v == SystemVariable::datum_frame || v == SystemVariable::settable_frame || v == SystemVariable::base_frame;
}

}  // namespace

Value read_system(Reckoning& run, const Expr& e) {
    const Access a{run, e};
    const auto v = static_cast<SystemVariable>(e.op);
    if (v == SystemVariable::ini_value) return setting_value(a);
    if (is_frame(v) && is_component(run, e)) return frame_component(a, v);
    if (v == SystemVariable::code_in_force) return shown_code(a);
    if (v >= SystemVariable::state) return live_value(run, v, a.index(0), a.name(), a.where());
    if (v >= SystemVariable::inch_program) {
        const auto value = tool_or_frame(run, e);
        return value ? Value::real(*value) : unknown_value(a, "neither program, job nor machine file says it");
    }
    switch (v) {
        case SystemVariable::numbered_parameter: return indexed_parameter(a);
        case SystemVariable::machine_position: return machine_position(a);
        case SystemVariable::work_position:
        case SystemVariable::programmed_position: return work_position(a);
        case SystemVariable::tool_length: return tool_length(a);
        case SystemVariable::tool_parameter: return tool_parameter(a);
        case SystemVariable::tool_exists: return tool_exists(a);
        case SystemVariable::tool_name: return tool_name(a);
        case SystemVariable::active_g: return active_g(a);
        case SystemVariable::machine_data: return machine_data(a);
        case SystemVariable::datum_frame:
        case SystemVariable::settable_frame:
        case SystemVariable::base_frame: return datum_frame_value(a);
        case SystemVariable::marker:
        case SystemVariable::parameter: return written_or_kept(a);
        case SystemVariable::timer: return unknown_value(a, "how much time passes is not followed");
        case SystemVariable::is_simulation:
        case SystemVariable::is_search:
        case SystemVariable::is_test:
        case SystemVariable::is_dry_run: return Value::boolean(false);
        case SystemVariable::clock: return clock_value(a);
        case SystemVariable::pi: return Value::real(geom::pi);
        case SystemVariable::digital_output:
        case SystemVariable::analog_output:
        case SystemVariable::unknown:
            if (const auto written = a.run.system_written.find(written_key(a)); written != a.run.system_written.end())
                return written->second;
            return unknown_value(a, v == SystemVariable::unknown ? "obrys does not know this system variable"
                                                                 : "the program has not set this output before");
        default: return run_state(a, v);
    }
}

}  // namespace obrys::interp
