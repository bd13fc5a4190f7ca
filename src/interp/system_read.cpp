/// System variables. What the run cannot know is reported, never guessed in silence.

#include <algorithm>
#include <cmath>

#include "base/codes.hpp"
#include "base/number.hpp"
#include "base/text.hpp"
#include "base/whole.hpp"
#include "interp/run.hpp"
#include "interp/system_tool.hpp"

namespace obrys::interp {

namespace codes = base::codes;
using program::Expr;
using program::SystemVariable;

namespace {

struct Access {
    Reckoning& run;
    const Expr& e;
    [[nodiscard]] base::Span where() const { return {run.unit().file, e.begin, e.end}; }
    [[nodiscard]] const std::string& name() const { return run.env.names.text(e.a); }
    [[nodiscard]] ExprId id(std::size_t i) const {
        return i < e.count ? run.unit().children[e.b + i] : program::no_expr;
    }
    /// An index in brackets; one that is unknown is -1, which names nothing.
    [[nodiscard]] double index(std::size_t i) const {
        const double v = i < e.count ? number(run, id(i)) : 0;
        return std::isnan(v) ? -1 : std::clamp(v, -1e6, 1e6);
    }
};

constexpr const char* first_tool_tells = "first_tool of the job tells it";

/// `also`: what tells it besides its own key.
Value unknown_value(const Access& a, const std::string& why, const std::string& also = {}) {
    const bool numbered = a.name().starts_with('#'), has_key = numbered || a.name().starts_with('$');
    const std::string key = numbered ? a.name() : has_key ? variable_key(a.run, a.e) : std::string{};
    if (auto given = given_value(a.run, key)) return *given;
    unchecked(a.run, codes::unknown_value, a.where(), a.name() + ": " + why,
              std::string("what is computed from it is unknown too") + (also.empty() ? "" : "; " + also) +
                  (has_key ? "; " + given_remedy(key) : ""));
    return Value::unknown();
}

Value known_or_unknown(const Access& a, double v, const std::string& why) {
    return std::isnan(v) ? unknown_value(a, why) : Value::real(v);
}

Value machine_position(const Access& a) {
    const std::string axis = axis_of(a.run, a.id(0));
    const auto datum = a.run.env.machine.datums.find(a.run.reference_datum);
    for (int k = 0; k < 3; ++k) {
        if (axis.size() != 1 || axis[0] != "XYZ"[k]) continue;
        if (datum == a.run.env.machine.datums.end())
            return unknown_value(a, "the machine position is not known without the zero offset");
        return known_or_unknown(a, coordinate(a.run.position, k) + coordinate(datum->second, k),
                                "the axis has not been positioned yet");
    }
    return known_or_unknown(a, programmed_coordinate(a.run, axis), "the axis has not been positioned yet");
}

Value work_position(const Access& a) {
    return known_or_unknown(a, programmed_coordinate(a.run, axis_of(a.run, a.id(0))),
                            "the axis has not been positioned yet");
}

Value tool_length(const Access& a) {
    const shop::Tool* t = a.run.tool.data;
    const double n = a.e.count == 0 ? 1 : a.index(0);
    if (t == nullptr) return unknown_value(a, "no tool data");
    if (const auto p = t->parameters.find(2 + base::cut<int>(n, 0, 9).value_or(-3)); p != t->parameters.end())
        return Value::real(p->second);
    if (n == 1 && t->length != 0) return Value::real(t->length);
    return unknown_value(a, "the tool list does not say it");
}

/// Without its wear; nothing where the list does not say it.
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

/// Numbers in the G group 1 (Siemens, lists of G functions).
int motion_number(Modal m) {
    switch (m) {
        case Modal::rapid: return 1;
        case Modal::linear: return 2;
        case Modal::arc_cw: return 3;
        case Modal::arc_ccw: return 4;
        case Modal::arc_via: return 5;
        case Modal::thread: return 10;
        case Modal::tap: return 11;
        case Modal::tap_retract: return 12;
        case Modal::arc_tangent: return 15;
        case Modal::thread_rising: return 16;
        default: return 17;
    }
}

/// Numbers of G96 and its relatives in the G group 15.
int speed_number(int word) {
    switch (word) {
        case 96: return 4;
        case 97: return 5;
        case 961: return 7;
        case 971: return 8;
        default: return 0;
    }
}

/// The words that say a G group; nothing of groups in which a control begins as obrys does.
std::optional<program::ModalGroup> words_of_group(int group) {
    using program::ModalGroup;
    switch (group) {
        case 1: return ModalGroup::motion;
        case 6: return ModalGroup::plane;
        case 8: return ModalGroup::datum;
        case 13: return ModalGroup::unit;
        case 14: return ModalGroup::dimension;
        case 15: return ModalGroup::feed;
        case 29: return ModalGroup::diameter;
        default: return std::nullopt;
    }
}

Value active_g(const Access& a) {
    const ModalState& m = a.run.modal;
    const auto words = words_of_group(base::cut<int>(a.index(0)).value_or(0));
    if (words && !is_said(a.run, *words))
        return unknown_value(a, "no block before says a function of this group: it is as the control was left");
    switch (base::cut<int>(a.index(0)).value_or(0)) {
        case 1: return Value::integer(motion_number(m.motion));
        case 6: return Value::integer(m.plane - 16);
        case 7:
            return Value::integer(m.compensation == Modal::compensation_off    ? 1
                                  : m.compensation == Modal::compensation_left ? 2
                                                                               : 3);
        case 8: return Value::integer(m.datum == 500 ? 1 : m.datum < 60 ? m.datum - 52 : m.datum - 499);
        case 13: return Value::integer(m.inch_geometry ? (m.inch_feed ? 3 : 1) : m.metric_feed ? 4 : 2);
        case 14: return Value::integer(m.absolute ? 1 : 2);
        case 15:
            return Value::integer(m.speed_word != 0                           ? speed_number(m.speed_word)
                                  : m.feed_mode == cl::FeedMode::inverse_time ? 1
                                  : m.feed_mode == cl::FeedMode::per_minute   ? 2
                                                                              : 3);
        case 16:
            return Value::integer(1 + static_cast<int>(m.feed_reference) - static_cast<int>(Modal::feed_at_contour));
        case 17: return Value::integer(m.approach == Modal::approach_normal ? 1 : 2);
        case 18: return Value::integer(m.corner == Modal::corner_arc ? 1 : 2);
        case 29: return Value::integer(m.diameter == DiameterMode::off ? 1 : m.diameter == DiameterMode::on ? 2 : 3);
        default: return unknown_value(a, "this G group is not followed");
    }
}

Value machine_data(const Access& a) {
    const auto found = a.run.env.machine.machine_data.find(a.name());
    if (found != a.run.env.machine.machine_data.end()) return Value::real(found->second);
    return unknown_value(a, "the machine file does not give this machine datum");
}

/// $P_IFRAME: the settable frame that is in force.
Value settable_frame(const Access& a) {
    const geom::Vec3 origin = datum_origin(a.run);
    if (geom::is_finite(origin)) return Value::of_frame(geom::Frame::shift(origin));
    return unknown_value(a, "the zero offset in force is not known");
}

Value datum_frame(const Access& a) {
    if (static_cast<SystemVariable>(a.e.op) == SystemVariable::settable_frame) return settable_frame(a);
    const double n = a.e.count > 0 && !(a.e.count == 2 && is_component(a.run, a.e)) ? a.index(0) : 0;
    if (n < 0) return unknown_value(a, "there is no such frame");
    const std::uint32_t number = n == 0   ? 500
                                 : n <= 4 ? 53 + base::clipped<std::uint32_t>(n, 0, 4)
                                          : 500 + base::clipped<std::uint32_t>(n, 5, 99'999);
    const auto found = a.run.env.machine.datums.find(number);
    if (found == a.run.env.machine.datums.end())
        return unknown_value(a, "the zero offset G" + std::to_string(number) + " is not known");
    return Value::of_frame(geom::Frame::shift(found->second));
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

/// A number of the control's configuration.
Value setting_value(const Access& a) {
    const auto text = [&](std::size_t i) { return base::to_upper(printed(evaluate(a.run, a.id(i)))); };
    const std::string key = text(0) + "/" + text(1);
    if (a.run.stopped) return Value::unknown();
    const auto* settings = a.run.env.settings;
    if (settings == nullptr || settings->empty())
        return unknown_value(a, "the configuration of the control is not at hand");
    const auto found = settings->find(key);
    const auto value = found == settings->end() ? std::nullopt : base::parse_double(found->second);
    if (value) return Value::real(*value);
    alarm(a.run, codes::undefined_name, a.where(), "the configuration has no number " + a.name());
    return Value::unknown();
}

/// Spindle and tool, which the control holds from before: unknown until program or job say them.
Value held_from_before(const Access& a, SystemVariable v) {
    const SpindleState& s = a.run.spindle;
    const ToolState& t = a.run.tool;
    const bool named_only = t.number == 0 && !t.name.empty();  // no list gives its number
    switch (v) {
        case SystemVariable::spindle_speed:
            if (!s.speed_known || std::isnan(s.speed)) return unknown_value(a, "no S that is known stands before it");
            return Value::real(s.speed);
        case SystemVariable::spindle_direction:
            if (!s.direction_known) return unknown_value(a, "no M3, M4 or M5 stands before it");
            return Value::integer(s.direction > 0 ? 3 : s.direction < 0 ? 4 : 5);
        case SystemVariable::tool_number:
            if (!t.known || named_only) return unknown_value(a, no_tool_said, first_tool_tells);
            return Value::integer(t.number);
        default:
            if (!t.edge_known) return unknown_value(a, no_tool_said, first_tool_tells);
            return Value::integer(t.edge);
    }
}

Value run_state(const Access& a, SystemVariable v) {
    const auto& run = a.run;
    switch (v) {
        case SystemVariable::feed:
            return run.feed_unknown || !run.feed_valid ? unknown_value(a, "no feed is known here")
                                                       : Value::real(run.feed);
        case SystemVariable::spindle_speed:
        case SystemVariable::spindle_direction:
        case SystemVariable::tool_number:
        case SystemVariable::tool_edge: return held_from_before(a, v);
        case SystemVariable::tool_radius: return tool_radius(a);
        case SystemVariable::argument_given: {
            const double n = a.index(0);
            const bool given =
                n >= 1 && n <= 32 &&
                ((run.calls.back().arguments_given >> (base::clipped<unsigned>(n, 1, 32) - 1)) & 1u) != 0;
            if (n < 0 || (run.calls.size() == 1 && !given))
                return unknown_value(a, "this program is run without its call");
            return Value::boolean(given);
        }
        case SystemVariable::stack_depth: return Value::integer(static_cast<double>(run.calls.size()) - 1);
        case SystemVariable::program_name: {
            const auto level = base::clipped<std::size_t>(a.index(0), 0, run.calls.size());
            return Value::string(level < run.calls.size() ? run.calls[level].unit->name : std::string{});
        }
        case SystemVariable::channel_axis_name:
            return Value::axis(std::string(1, a.name().back() == '2' ? 'Y' : a.name().back() == '3' ? 'Z' : 'X'));
        default: return Value::of_frame(v == SystemVariable::programmed_frame ? run.modal.programmed : run.frame);
    }
}

bool is_frame(SystemVariable v) {
    return v == SystemVariable::programmed_frame || v == SystemVariable::active_frame ||
           v == SystemVariable::datum_frame || v == SystemVariable::settable_frame || v == SystemVariable::base_frame;
}

/// One component of a frame: [axis, TR], behind the number of a settable one.
Value frame_component(const Access& a, SystemVariable v) {
    if (v == SystemVariable::programmed_frame) return read_component(a.run, a.e, a.run.modal.programmed);
    if (v == SystemVariable::active_frame) {
        const geom::Vec3 origin = datum_origin(a.run);
        if (!geom::is_finite(origin)) return unknown_value(a, "the zero offset in force is not known");
        return read_component(a.run, a.e, geom::Frame::shift(origin) * a.run.modal.programmed);
    }
    const Value whole = datum_frame(a);
    return whole.type == Type::frame ? read_component(a.run, a.e, whole.as_frame()) : whole;
}

/// #4001 …: the code itself, or one of two by what it says.
Value shown_code(const Access& a) {
    const auto q = static_cast<program::StateQuery>(base::clipped<int>(a.index(0), 0, 255));
    const auto code = code_in_force(a.run, q, a.index(1), a.index(2));
    return code ? Value::real(*code)
                : unknown_value(a, "no block before says a code of this group: it is as the control was left");
}

/// Date and time of the run: the job may give them.
Value clock_value(const Access& a) {
    const std::string key = variable_key(a.run, a.e);
    if (auto given = given_value(a.run, key)) return *given;
    assume(a.run, a.where(), a.name() + ": when the program will run is not known, and so this value",
           "[variables] of the job can give it: " + job_key(key) + " = …");
    a.run.clock_asked = true;
    return Value::unknown();
}

}  // namespace

int tool_parameter_number(const std::string& name) {
    int n = 0;
    for (std::size_t i = name.find_last_not_of("0123456789") + 1; i < name.size() && n < 1000; ++i)
        n = n * 10 + (name[i] - '0');
    return n;
}

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
        case SystemVariable::base_frame: return datum_frame(a);
        case SystemVariable::marker:
        case SystemVariable::parameter: return written_or_kept(a);
        case SystemVariable::timer: return unknown_value(a, "how much time passes is not followed");
        case SystemVariable::is_simulation:
        case SystemVariable::is_search:
        case SystemVariable::is_test:
        case SystemVariable::is_dry_run: return Value::boolean(false);
        case SystemVariable::clock: return clock_value(a);
        case SystemVariable::pi: return Value::real(geom::pi);
        case SystemVariable::unknown:
            if (const auto written = a.run.system_written.find(written_key(a)); written != a.run.system_written.end())
                return written->second;
            return unknown_value(a, "obrys does not know this system variable");
        default: return run_state(a, v);
    }
}

}  // namespace obrys::interp
