/// Which tool is in the spindle, and what is known of it. Feed and machine functions: technology.cpp.

#include <algorithm>
#include <cmath>

#include "base/codes.hpp"
#include "base/whole.hpp"
#include "cl/unknown_tool.hpp"
#include "interp/setup/setup.hpp"

namespace obrys::interp {

namespace codes = base::codes;
using program::ControlValue;

namespace {

/// A tool word as number and edge: 1 (MD20270 CUTTING_EDGE_DEFAULT as delivered), or that of the index; nothing where
/// it is none.
std::optional<std::pair<std::uint32_t, std::uint32_t>> tool_number(const Saying& run, double t) {
    const double index = run.traits->indexed_tools ? std::round((t - std::floor(t + 1e-9)) * 10) : 0;
    const auto number = base::whole<std::uint32_t>(std::round((t - index / 10) * 1e9) / 1e9);
    if (!(t >= 0) || !number || *number == cl::unknown_tool) return std::nullopt;
    return std::pair{*number, 1 + base::clipped<std::uint32_t>(index, 0, 9)};
}

}  // namespace

void say_length_axis(Telling& run) {
    const bool mill = run.env.machine.kind == shop::MachineKind::mill;
    if (!mill || run.modal.plane == 17 || run.tool.edge == 0 || run.traits->length_axis_setting.empty()) return;
    assume(run, run.here(),
           "the tool's length is taken to act along Z in this plane, too (" +
               std::string(run.traits->length_axis_setting) + "); else it acts along the axis that stands on it",
           "write G17 again before the next straight move");
}

namespace {

bool changes_on_m6(const Saying& run) {
    return run.traits->changes_on_m6 || run.env.machine.kind == shop::MachineKind::mill;
}

/// `standing`: it is in the spindle already.
void emit_tool(Telling& run, bool standing = false) {
    run.tool.data = find_tool(run, run.tool);
    const bool lathe = run.env.machine.kind == shop::MachineKind::lathe;
    cl::ToolChange change{run.tool.number,       run.tool.edge,         run.tool.name,
                          run.tool.delta_length, run.tool.delta_radius, standing};
    // Controls of the G43 family compensate lengths by words of their own, but for turrets.
    change.with_length = (!keeps_offsets(run) || (lathe && run.traits->edge_is_offset_number)) && run.tool.edge != 0;
    if (lathe && run.traits->edge_is_offset_number && run.tool.edge != cl::unknown_tool) change.offset = run.tool.edge;
    emit(run, change);
    // Called again, with another length, it stays where it is. No word of lathes moves along Y.
    std::pair<std::uint32_t, std::string> now{change.number, change.name};
    if (!standing && now != run.changed_to) run.unsaid_since_change = {true, !lathe, true};
    run.changed_to = std::move(now);
    if (change.number != 0) run.tools_called.insert(change.number);
    judge_anew(run.offsets);
    take_tip(run);
    if (!standing) say_length_axis(run);
    control_sets(run, {ControlValue::tool_axis});
}

}  // namespace

void begin_with_tool(Telling& run, std::uint32_t number) {
    run.tool.prepared = number;
    run.tool.selected = number;
    tool_into_spindle(run);
    if (run.traits->edge_is_offset_number) run.tool.edge = number;
    emit_tool(run, true);
}

namespace {

/// TOOL DEF: the program itself says what the tool is.
void define_tool(Moving& run) {
    const BlockWords& b = run.block;
    const double n = b.get(Code::tool);
    if (!b.has(Code::tool)) return;
    if (std::isnan(n))
        return unchecked(run, codes::unknown_value, run.here(),
                         "which tool is defined here depends on a value that is not known");
    const auto id = tool_number(run, n);
    if (!id)
        return alarm(run, codes::value_range, run.here(), "TOOL DEF " + printed(Value::real(n)) + " is no tool number");
    const auto number = id->first, edge = id->second;
    auto found = std::find_if(run.tools.begin(), run.tools.end(),
                              [&](const shop::Tool& t) { return t.number == number && (edge == 1 || t.edge == edge); });
    if (found == run.tools.end()) {
        found = add_tool(run, number);
        found->edge = edge;
    }
    const double unit = length_unit(run.modal);
    if (b.has(Code::tool_length)) found->length = b.get(Code::tool_length) * unit;
    if (b.has(Code::tool_radius)) found->radius = b.get(Code::tool_radius) * unit;
    if (b.has(Code::tool_radius)) found->has_no_radius = found->radius == 0;
    cl::ToolData data{number, edge, {}, {}};
    if (b.has(Code::tool_length)) data.length = found->length;
    if (b.has(Code::tool_radius)) data.radius = found->radius;
    if (!run.traits->definitions_describe) emit(run, data);
    if (run.env.machine.kind == shop::MachineKind::mill) compare_with_job(run, *found);
    run.tool.data = find_tool(run, run.tool);
}

/// The tool stands still while another DL counts: the control takes its point for so much higher.
void lower_point(Telling& run, double by) {
    flush_path(run);
    run.position = run.position + by * run.tool_axis;
    run.programmed_position =
        run.frame_is_identity ? run.position : geom::apply(geom::inverse(run.frame), run.position);
}

/// DL, DR, DR2 hold for this call of the tool alone; without them there are none.
void take_allowances(Moving& run) {
    const BlockWords& b = run.block;
    const double unit = length_unit(run.modal);
    const auto value = [&](Code c) { return b.has(c) ? b.get(c) * unit : 0; };
    if (!b.has(Code::tool) && !b.has(Code::delta_length) && !b.has(Code::delta_radius) && !b.has(Code::delta_corner))
        return;
    run.tool.delta_length = value(Code::delta_length);
    const bool mill = run.env.machine.kind == shop::MachineKind::mill;
    if (mill && run.modal.plane != 17)
        unchecked(run, codes::unsupported, run.here(), "a tool axis other than Z is not followed: it is taken along Z");
    run.tool.delta_radius = value(Code::delta_radius);
    run.tool.delta_corner = value(Code::delta_corner);
    run.tool.feed = b.has(Code::feed) ? b.get(Code::feed) * feed_factor(run) : 0;
}

/// The program says which tool is in the spindle; nothing moves. A tool selected by T waits for M6 as before.
void number_tool(Moving& run, int m) {
    const BlockWords& b = run.block;
    const double q = b.has(Code::q) ? std::round(b.get(Code::q)) : -1;
    const std::string word = "M" + std::to_string(m);
    if (std::isnan(q)) {
        unchecked(run, codes::unknown_value, run.here(),
                  "which tool " + word + " means depends on a value that is not known");
        run.tool.number = cl::unknown_tool;
        run.tool.name.clear();
        run.tool.known = run.tool.edge_known = false;
        return emit_tool(run, true);
    }
    if (q < 0 || q >= cl::unknown_tool)
        return alarm(run, codes::value_range, run.here(),
                     word + " needs Q, the number of the tool in the spindle, 0 or more");
    if (q > 0 && !run.tools.empty() && !is_listed(run, q))
        return alarm(run, codes::tool_missing, run.here(),
                     word + ": T" + printed(Value::real(q)) + " is not in the tool table", "add the tool to the table");
    run.tool.number = base::clipped<std::uint32_t>(q, 0, 4294967295);
    run.tool.name.clear();
    run.tool.edge = 1;
    run.tool.known = run.tool.edge_known = true;
    emit_tool(run, true);
    control_sets(run, {ControlValue::tool_radius, ControlValue::tool_length});
}

/// M6 and what goes with it; true where the tool in the spindle is another one now.
bool tool_functions(Moving& run) {
    const BlockWords& b = run.block;
    const auto has = [&](int m) { return std::find(b.m.begin(), b.m.end(), m) != b.m.end(); };
    if (const int m = run.traits->tool_number_function; m != 0 && has(m)) number_tool(run, m);
    if (!has(6) || !run.tool.waiting) return false;
    tool_into_spindle(run);
    return true;
}

/// T203 of a turret whose value is computed: tool 2 with offset 3. What the number cannot say is said as where it is
/// written.
void part_turret_number(Moving& run) {
    BlockWords& b = run.block;
    const double t = b.peek(Code::tool);
    constexpr std::uint32_t hundred = 100, most = 9999;
    const auto whole = base::whole<std::uint32_t>(t);
    if (!whole) return;  // said as no tool number
    const std::uint64_t tool = std::uint64_t{1} << static_cast<unsigned>(Code::tool);
    if (*whole > 0 && *whole < hundred) {
        b.put(Code::edge, *whole);  // 303, the reading that changes the tool
        return unchecked(run, codes::unsupported, run.here(),
                         "T" + printed(Value::real(t)) +
                             " is one number for tool and offset: which it is (T0003, T0303) "
                             "depends on the machine",
                         "compute a number with the digits of both: 100 times the tool, and the offset");
    }
    if (*whole > most)
        unchecked(run, codes::unsupported, run.here(),
                  "T" + printed(Value::real(t)) +
                      " has more than four digits: which of them are the tool depends on the machine");
    if (*whole == 0) b.present &= ~(tool | std::uint64_t{1} << static_cast<unsigned>(Code::tool_change));
    b.value[static_cast<std::size_t>(Code::tool)] = *whole / hundred;
    b.put(Code::edge, *whole % hundred);
}

/// D of the block: whether another edge of the tool counts from here on; nothing where all of it has been said.
std::optional<bool> take_edge(Moving& run, bool calls_tool) {
    const double d = run.block.get(Code::edge);
    if (std::isnan(d)) {
        unchecked(run, codes::unknown_value, run.here(),
                  "which cutting edge this is depends on a value that is not known");
        run.tool.edge_known = false;
        run.tool.edge = cl::unknown_tool;
        emit_tool(run);
        return std::nullopt;
    }
    if (!base::whole<int>(d, 0, 32'000)) {
        alarm(run, codes::value_range, run.here(), "D" + printed(Value::real(d)) + " is no cutting edge");
        return std::nullopt;
    }
    const auto edge = base::clipped<std::uint32_t>(d, 0, 32'000);
    if (edge > 1 && run.tool.waiting && changes_on_m6(run) && !run.traits->edge_is_offset_number) {
        run.tool.prepared_edge = edge;
        assume(run, run.here(), "D" + std::to_string(edge) + " between T and M6 is taken for the tool that M6 brings",
               "write D behind M6");
        return std::nullopt;
    }
    const bool other = edge != run.tool.edge;
    run.tool.edge = edge;
    run.tool.edge_known = true;
    // No word has called the tool: it is the one that stands in the spindle when the program begins.
    const bool uncalled = !calls_tool && run.tool.number == 0 && run.tool.name.empty();
    if (other && uncalled) emit_tool(run, true);
    return other && !uncalled;
}

/// A definition that says nothing of the tool: a magazine makes it ready (TOOL DEF 5), and nothing else follows.
void prepare_tool(Moving& run) {
    const BlockWords& b = run.block;
    if (!b.has(Code::tool)) return;
    if (b.tool_named) return emit(run, cl::ToolSelection{0, b.tool_name});
    const double n = b.get(Code::tool);
    if (std::isnan(n))
        return unchecked(run, codes::unknown_value, run.here(),
                         "which tool is made ready here depends on a value that is not known");
    const auto id = tool_number(run, n);
    if (!id)
        return alarm(run, codes::value_range, run.here(), "TOOL DEF " + printed(Value::real(n)) + " is no tool number");
    emit(run, cl::ToolSelection{id->first, {}});
}

}  // namespace

void select_tool(Moving& run) {
    BlockWords& b = run.block;
    if (b.has(Code::tool_change) && b.has(Code::tool) && b.peek(Code::tool_change) != 0) part_turret_number(run);
    bool changed = false, replaced = false;
    const std::pair before{run.tool.number, run.tool.name};
    if (b.has(Code::tool_definition)) {
        if (!b.has(Code::tool_length) && !b.has(Code::tool_radius)) return prepare_tool(run);
        define_tool(run);
        control_sets(run, {ControlValue::tool_radius, ControlValue::tool_length});
        return;
    }
    if (b.has(Code::tool)) {
        const double t = b.get(Code::tool);
        const bool unknown = !b.tool_named && std::isnan(t);
        if (unknown)
            unchecked(run, codes::unknown_value, run.here(), "which tool this is depends on a value that is not known");
        const std::pair<std::uint32_t, std::uint32_t> by_other{unknown ? cl::unknown_tool : 0, 1};
        const auto number = b.tool_named || unknown ? std::optional(by_other) : tool_number(run, t);
        if (!number) {
            alarm(run, codes::value_range, run.here(), "T" + printed(Value::real(t)) + " is no tool number");
            return;
        }
        run.tool.prepared = number->first;
        run.tool.prepared_edge = number->second;
        run.tool.prepared_name = b.tool_named ? b.tool_name : std::string{};
        run.tool.selected =
            b.tool_named || unknown || b.has(Code::tool_change) ? std::nullopt : std::optional(number->first);
        run.tool.waiting = true;
        if (!changes_on_m6(run) && !b.has(Code::tool_change)) {
            tool_into_spindle(run);
            changed = replaced = true;
        }
    }
    if (b.has(Code::tool_change)) {
        if (run.traits->first_tool_says_axis && !run.modal.plane_said)
            assume(run, run.here(),
                   "the first tool call names no tool axis: it is taken to be Z, where the control wants one",
                   "write X, Y or Z behind the tool");
        run.modal.plane_said = true;
        replaced = replaced || run.tool.waiting;
        if (run.tool.waiting) tool_into_spindle(run);
        const double higher = run.tool.delta_length;
        take_allowances(run);
        changed = b.has(Code::tool) || run.tool.delta_length != higher;
        if (!b.has(Code::tool) && changed) lower_point(run, higher - run.tool.delta_length);
    }
    changed = tool_functions(run) || changed;
    if (run.stopped) return;
    if (b.has(Code::tool) && run.tool.waiting && run.tool.prepared != cl::unknown_tool)
        emit(run, cl::ToolSelection{run.tool.prepared, run.tool.prepared_name});
    replaced = replaced || std::find(b.m.begin(), b.m.end(), 6) != b.m.end();
    if (replaced) say_carried_compensation(run);
    if (replaced) stop_for_change(run, run.tool.known && before == std::pair{run.tool.number, run.tool.name});
    if (b.has(Code::edge)) {
        const std::optional<bool> other = take_edge(run, changed || replaced);
        if (!other) return;
        changed = changed || *other;
    }
    if (changed) emit_tool(run);
    if (changed || b.has(Code::tool_change)) control_sets(run, {ControlValue::tool_radius, ControlValue::tool_length});
}

}  // namespace obrys::interp
