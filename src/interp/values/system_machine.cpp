/// What system variables show of the machine as it stands.

#include <cmath>

#include "base/codes.hpp"
#include "base/number.hpp"
#include "base/text.hpp"
#include "base/whole.hpp"
#include "interp/values/system_access.hpp"

namespace obrys::interp {

namespace codes = base::codes;
using program::SystemVariable;

namespace {

constexpr const char* first_tool_tells = "first_tool of the job tells it";

Value known_or_unknown(const Access& a, double v, const std::string& why) {
    return std::isnan(v) ? unknown_value(a, why) : Value::real(v);
}

}  // namespace

Value machine_position(const Access& a) {
    const std::string axis = axis_of(a.run, a.id(0));
    for (std::size_t k = 0; k < 3; ++k) {
        if (axis.size() != 1 || axis[0] != "XYZ"[k]) continue;
        const double ahead = machine_ahead(a.run, k);
        if (std::isnan(ahead)) return unknown_value(a, "the machine position is not known without the zero offset");
        return known_or_unknown(a, coordinate(a.run.position, static_cast<int>(k)) + ahead,
                                "the axis has not been positioned yet");
    }
    return known_or_unknown(a, programmed_coordinate(a.run, axis), "the axis has not been positioned yet");
}

Value work_position(const Access& a) {
    return known_or_unknown(a, programmed_coordinate(a.run, axis_of(a.run, a.id(0))),
                            "the axis has not been positioned yet");
}

namespace {

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

}  // namespace

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

namespace {

/// $P_IFRAME: the settable frame that is in force.
Value settable_frame(const Access& a) {
    const geom::Vec3 origin = datum_origin(a.run);
    if (geom::is_finite(origin)) return Value::of_frame(geom::Frame::shift(origin));
    return unknown_value(a, "the zero offset in force is not known");
}

}  // namespace

Value datum_frame_value(const Access& a) {
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

namespace {

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

}  // namespace

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

Value frame_component(const Access& a, SystemVariable v) {
    if (v == SystemVariable::programmed_frame) return read_component(a.run, a.e, a.run.modal.programmed);
    if (v == SystemVariable::active_frame) {
        const geom::Vec3 origin = datum_origin(a.run);
        if (!geom::is_finite(origin)) return unknown_value(a, "the zero offset in force is not known");
        return read_component(a.run, a.e, geom::Frame::shift(origin) * a.run.modal.programmed);
    }
    const Value whole = datum_frame_value(a);
    return whole.type == Type::frame ? read_component(a.run, a.e, whole.as_frame()) : whole;
}

Value shown_code(const Access& a) {
    const auto q = static_cast<program::StateQuery>(base::clipped<int>(a.index(0), 0, 255));
    const auto code = code_in_force(a.run, q, a.index(1), a.index(2));
    return code ? Value::real(*code)
                : unknown_value(a, "no block before says a code of this group: it is as the control was left");
}

Value clock_value(const Access& a) {
    const std::string key = variable_key(a.run, a.e);
    if (auto given = given_value(a.run, key)) return *given;
    assume(a.run, a.where(), a.name() + ": when the program will run is not known, and so this value",
           "[variables] of the job can give it: " + job_key(key) + " = …");
    a.run.clock_asked = true;
    return Value::unknown();
}

}  // namespace obrys::interp
