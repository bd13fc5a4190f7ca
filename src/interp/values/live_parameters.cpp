/// Numbered parameters and predefined names in which the control shows its own state.
/// Source: LinuxCNC, "Parameters" (numbered, named, predefined); Fanuc, custom macro, system variables.

#include <algorithm>
#include <cmath>

#include "base/codes.hpp"
#include "base/whole.hpp"
#include "interp/values/nose_of_tool.hpp"
#include "interp/values/values.hpp"

namespace obrys::interp {

using program::StateQuery;
using program::SystemVariable;

namespace codes = base::codes;

namespace {

/// mm of a length that the program reads: its own unit, and diameters where it programs these.
double in_program_unit(const Reckoning& run, std::size_t axis, double v) {
    if (axis >= 3 && axis < 6) return v;
    return v / (axis < 3 ? length_factor(run, static_cast<int>(axis), false) : length_unit(run.modal));
}

double axis_value(const Reckoning& run, std::size_t axis, bool machine) {
    const double at = machine ? machine_coordinate(run, axis) : axis_coordinate(run, axis);
    if (std::isnan(at) && axis >= 3 && !run.extra_axes.contains(axis_name(axis))) return 0;
    return in_program_unit(run, axis, at);
}

double table_column(const Reckoning& run, std::size_t column) {
    const shop::Tool* t = run.tool.data;
    if (!run.tool.known) return unknown_number;
    if (column == 0) return run.tool.number;
    if (t == nullptr) return run.tools.empty() && run.tool.number != 0 ? unknown_number : 0;
    const bool listed = t->table.has_value() || run.env.stand_alone;  // else 0 says that nobody gave it
    if (!listed && ((column == 3 && t->length == 0) || (column == 10 && t->radius == 0))) return unknown_number;
    if (column == 3) return in_program_unit(run, 2, t->length);
    if (column == 10) return in_program_unit(run, 1, 2 * t->radius);
    if (column == 13) return table_orientation(*t).value_or(0);
    // The edges of an insert that the job describes have angles; they are not asked for often enough to be computed.
    if (!t->table) return column > 10 && t->kind == shop::ToolKind::turning ? unknown_number : 0;
    if (column <= 9) return in_program_unit(run, column - 1, t->table->offset[column - 1]);
    return column == 11 ? t->table->front_angle : column == 12 ? t->table->back_angle : t->table->orientation;
}

double motion_mode(const Reckoning& run) {
    const ModalState& m = run.modal;
    switch (m.motion) {
        case Modal::rapid: return 0;
        case Modal::linear: return 10;
        case Modal::arc_cw: return 20;
        case Modal::arc_ccw: return 30;
        case Modal::thread: return 330;
        case Modal::probe: return 380 + m.motion_number;
        case Modal::canned: return run.traits->canned[static_cast<std::size_t>(m.motion_number)].number;
        case Modal::canned_off: return 800;
        default: return unknown_number;
    }
}

double work_coordinate_system(const Reckoning& run) {
    const std::uint32_t n = run.modal.datum;
    return n >= 591 && n <= 593 ? 590 + static_cast<double>(n - 590) : 10.0 * n;
}

/// What is asked of modes and switches.
double mode(const Reckoning& run, StateQuery q) {
    const ModalState& m = run.modal;
    switch (q) {
        case StateQuery::motion_mode: return motion_mode(run);
        case StateQuery::plane: return 10 * m.plane;
        case StateQuery::compensation:
            return m.compensation == Modal::compensation_off    ? 400
                   : m.compensation == Modal::compensation_left ? 410
                                                                : 420;
        case StateQuery::metric: return m.inch_geometry ? 0 : 1;
        case StateQuery::imperial: return m.inch_geometry ? 1 : 0;
        case StateQuery::absolute: return m.absolute ? 1 : 0;
        case StateQuery::incremental: return m.absolute ? 0 : 1;
        case StateQuery::inverse_time: return m.feed_mode == cl::FeedMode::inverse_time ? 1 : 0;
        case StateQuery::feed_per_minute: return m.feed_mode == cl::FeedMode::per_minute ? 1 : 0;
        case StateQuery::feed_per_rev: return m.feed_mode == cl::FeedMode::per_rev ? 1 : 0;
        case StateQuery::coordinate_system: return work_coordinate_system(run);
        case StateQuery::retract_clearance: return m.clear_to_retract_plane ? 1 : 0;
        case StateQuery::retract_initial: return m.clear_to_retract_plane ? 0 : 1;
        case StateQuery::spindle_rpm_mode: return m.surface_speed ? 0 : 1;
        case StateQuery::spindle_surface_mode: return m.surface_speed ? 1 : 0;
        case StateQuery::arc_centre_absolute: return m.centre_absolute ? 1 : 0;
        case StateQuery::diameter_mode: return m.diameter == DiameterMode::off ? 0 : 1;
        case StateQuery::radius_mode: return m.diameter == DiameterMode::off ? 1 : 0;
        default: return unknown_number;
    }
}

/// What nobody has said the control holds from before.
double if_said(bool said, double v) { return said ? v : unknown_number; }

double state(const Reckoning& run, StateQuery q) {
    if (q >= StateQuery::x && q <= StateQuery::w)
        return axis_value(run, static_cast<std::size_t>(q) - static_cast<std::size_t>(StateQuery::x), false);
    if (q >= StateQuery::machine_x && q <= StateQuery::machine_w)
        return axis_value(run, static_cast<std::size_t>(q) - static_cast<std::size_t>(StateQuery::machine_x), true);
    switch (q) {
        case StateQuery::line: return run.env.sources.position(run.unit().file, run.here().begin).line;
        case StateQuery::version_major: return 2.9;
        case StateQuery::version_minor: return 0;
        case StateQuery::tool_offset: return run.offsets.tool == Axes{} ? 0 : 1;
        case StateQuery::spindle_on: return if_said(run.spindle.direction_known, run.spindle.direction != 0 ? 1 : 0);
        case StateQuery::spindle_clockwise:
            return if_said(run.spindle.direction_known, run.spindle.direction > 0 ? 1 : 0);
        case StateQuery::mist: return if_said(run.modal.mist_said, run.mist ? 1 : 0);
        case StateQuery::flood: return if_said(run.modal.flood_said, run.flood ? 1 : 0);
        case StateQuery::speed_override: return run.overrides.speed ? 1 : 0;
        case StateQuery::feed_override: return run.overrides.feed ? 1 : 0;
        case StateQuery::adaptive_feed: return 0;
        case StateQuery::feed_hold: return run.overrides.hold ? 1 : 0;
        case StateQuery::feed: return if_said(run.modal.feed_said, run.feed_valid ? run.feed_number : 0);
        case StateQuery::speed: return if_said(run.spindle.speed_known, run.spindle.speed);
        case StateQuery::current_tool: return if_said(run.tool.known, run.tool.number);
        case StateQuery::selected_tool: return if_said(run.tool.selected.has_value(), run.tool.prepared);
        case StateQuery::is_task: return if_said(run.env.stand_alone, 0);  // 1 on the machine, 0 in its preview
        case StateQuery::remap_level: return 0;
        case StateQuery::call_level: return static_cast<double>(run.calls.size()) - 1;
        default: return mode(run, q);
    }
}

const program::LiveParameters* live_range(const Saying& run, std::uint32_t n) {
    const auto& live = run.traits->live;
    if (live.empty() || n < live.front().first) return nullptr;  // the lowest stands first
    for (const program::LiveParameters& l : live)
        if (n >= l.first && n < l.first + l.count) return &l;
    return nullptr;
}

/// What the control shows of itself, as far as the run follows it; NaN where it does not.
double known_live_value(const Reckoning& run, SystemVariable v, double index) {
    const auto axis = base::clipped<std::size_t>(index, 1, 9) - 1;
    switch (v) {
        case SystemVariable::state: return state(run, static_cast<StateQuery>(base::clipped<int>(index, 0, 99'999)));
        case SystemVariable::coordinate: return axis_value(run, axis, false);
        case SystemVariable::machine_coordinate: return axis_value(run, axis, true);
        case SystemVariable::tool_table_column: return table_column(run, base::clipped<std::size_t>(index, 0, 13));
        default: return unknown_number;
    }
}

/// Why it is not known, and what of the job tells it besides [variables].
struct Unknown {
    const char* why = "what this parameter of the control holds is not known here";
    std::string also{};
};

Unknown why_unknown(const Reckoning& run, SystemVariable v, double index) {
    constexpr const char* first_tool = "; first_tool of the job tells it";
    if (v == SystemVariable::tool_table_column && !run.tool.known) return {no_tool_said, first_tool};
    if (v == SystemVariable::machine_coordinate && keeps_offsets(run))
        return {.also = "; give " + program::datum_phrase(*run.traits, run.modal.datum) + " in [datum] of the job"};
    if (v != SystemVariable::state) return {};
    switch (static_cast<StateQuery>(base::clipped<int>(index, 0, 255))) {
        case StateQuery::current_tool:
        case StateQuery::selected_tool: return {no_tool_said, first_tool};
        case StateQuery::feed: return {"no F stands before it, and the control keeps the last one it had"};
        case StateQuery::speed: return {"no S stands before it, and the control keeps the last one it had"};
        case StateQuery::spindle_on:
        case StateQuery::spindle_clockwise: return {"whether the spindle turns when the program begins is not known"};
        case StateQuery::mist:
        case StateQuery::flood: return {"whether coolant is on when the program begins is not known"};
        case StateQuery::is_task: return {"it is 1 where the machine runs the program, and 0 in its preview"};
        default: return {};
    }
}

/// `name`: of a parameter that the job can give; empty: it cannot.
double report_unknown(Saying& run, const std::string& name, const base::Span& where, const Unknown& u) {
    unchecked(run, codes::unknown_value, where, u.why,
              "what is computed from it is unknown too" + u.also + (name.empty() ? "" : "; " + given_remedy(name)));
    return unknown_number;
}

/// The group of the words that say a state; nothing: a control begins as obrys does.
std::optional<program::ModalGroup> group_of(StateQuery q) {
    using program::ModalGroup;
    switch (q) {
        case StateQuery::motion_mode: return ModalGroup::motion;
        case StateQuery::plane: return ModalGroup::plane;
        case StateQuery::absolute: return ModalGroup::dimension;
        case StateQuery::imperial: return ModalGroup::unit;
        case StateQuery::coordinate_system: return ModalGroup::datum;
        case StateQuery::feed_per_rev: return ModalGroup::feed;
        default: return std::nullopt;
    }
}

}  // namespace

bool is_live(const Reckoning& run, std::uint32_t n) {
    const program::LiveParameters* l = live_range(run, n);
    return l != nullptr && !run.parameters.is_assigned(n);
}

bool may_be_written(const Saying& run, std::uint32_t n) {
    const program::LiveParameters* l = live_range(run, n);
    return l == nullptr || l->value == SystemVariable::probed_coordinate || l->value == SystemVariable::probe_success ||
           l->value == SystemVariable::input_value || l->value == SystemVariable::unknown;
}

bool is_of_control(Saying& run, std::uint32_t n, const base::Span& where) {
    const program::LiveParameters* l = live_range(run, n);
    if (l == nullptr || run.traits->assigns_together) return false;
    if (l->value == SystemVariable::timer) return true;
    alarm(run, codes::value_range, where, program::parameter_name(*run.traits, n) + " can only be read");
    return true;
}

void forget_live(Reckoning& run, SystemVariable what) {
    for (const program::LiveParameters& l : run.traits->live)
        for (std::uint32_t n = l.first; l.value == what && n < std::min(l.first + l.count, run.parameters.count()); ++n)
            run.parameters.forget(n);
}

double live_parameter(Reckoning& run, std::uint32_t n, const base::Span& where) {
    const program::LiveParameters* l = live_range(run, n);
    const double index = static_cast<double>(n - l->first) + (l->value == SystemVariable::tool_table_column ? 0 : 1);
    const double shown = known_live_value(run, l->value, index);
    if (!std::isnan(shown)) return shown;
    if (run.parameters.is_set(n)) return run.parameters.get(n);  // the job gives it
    return report_unknown(run, program::parameter_name(*run.traits, n), where, why_unknown(run, l->value, index));
}

Value live_value(Reckoning& run, SystemVariable v, double index, const std::string& name, const base::Span& where) {
    const double result = known_live_value(run, v, index);
    if (!std::isnan(result)) return Value::real(result);
    const std::string key = name.starts_with('#') ? name : std::string{};
    if (auto given = given_value(run, key)) return *given;
    return Value::real(report_unknown(run, key, where, why_unknown(run, v, index)));
}

bool is_said(const Reckoning& run, program::ModalGroup group) {
    if (run.env.stand_alone) return true;  // LinuxCNC's own interpreter begins with what it prints
    const bool speed = group == program::ModalGroup::feed && run.modal.speed_word != 0;  // G96 and G97 are of it, too
    return speed || (run.modal.groups_said >> static_cast<unsigned>(group) & 1u) != 0;
}

std::optional<double> code_in_force(const Reckoning& run, StateQuery q, double yes, double no) {
    const bool surface = q == StateQuery::spindle_surface_mode;
    if (const auto group = group_of(q); surface ? run.modal.speed_word == 0 : group && !is_said(run, *group))
        return std::nullopt;
    const double v = mode(run, q);
    if (std::isnan(v)) return std::nullopt;
    if (q == StateQuery::feed_per_rev && run.modal.feed_mode == cl::FeedMode::inverse_time) return 93;
    if (yes == 0) return v / 10;  // queries count G numbers times ten
    return v != 0 ? yes : no;
}

void begin_said(Reckoning& run) {
    if (!run.env.stand_alone) return;
    run.tool.known = run.tool.edge_known = run.spindle.speed_known = run.spindle.direction_known = true;
    run.tool.selected = 0;
    run.modal.feed_said = run.modal.mist_said = run.modal.flood_said = true;
}

}  // namespace obrys::interp
