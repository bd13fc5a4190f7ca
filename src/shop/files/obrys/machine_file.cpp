#include <algorithm>
#include <array>
#include <cmath>

#include "base/codes.hpp"
#include "base/text.hpp"
#include "shop/files/obrys/machine_file.hpp"
#include "shop/files/obrys/machine_origins.hpp"
#include "shop/files/obrys/solid_file.hpp"
#include "shop/files/obrys/tables.hpp"

namespace obrys::shop {

namespace {

/// The direction that the first letter of a name says; nothing for letters that say none.
std::optional<geom::Vec3> usual_direction(const std::string& name) {
    switch (name.empty() ? ' ' : name[0]) {
        case 'X':
        case 'U':
        case 'A': return geom::Vec3{1, 0, 0};
        case 'Y':
        case 'V':
        case 'B': return geom::Vec3{0, 1, 0};
        case 'Z':
        case 'W':
        case 'C': return geom::Vec3{0, 0, 1};
        default: return std::nullopt;
    }
}

void read_direction(Section& s, MachineAxis& axis) {
    axis.direction = usual_direction(axis.name).value_or(geom::Vec3{});
    if (const auto d = read_vector(s, "direction")) {
        const double length = geom::length(*d);
        if (length > 1e-6)
            axis.direction = (1 / length) * *d;
        else
            s.error(base::codes::job_value, find(s.table(), "direction")->value.where, "'direction' must not be 0");
    }
    if (const auto c = read_vector(s, "centre")) axis.centre = *c;
    if (s.has("centre") && !axis.rotary)
        s.error(base::codes::job_value, find(s.table(), "centre")->where,
                "'centre' means nothing for an axis that does not turn");
}

void read_axis(const Value& v, base::Diagnostics& diagnostics, Machine& machine) {
    Section s(v, "[[axis]]", diagnostics);
    if (v.kind != ValueKind::table) return;
    MachineAxis axis;
    const auto name = s.text("name");
    axis.rotary = s.boolean("rotary").value_or(false);
    axis.min = s.number("min");
    axis.max = s.number("max");
    axis.rapid = s.number("rapid", Range::positive).value_or(axis.rapid);
    axis.acceleration = s.number("acceleration", Range::positive);
    axis.jerk = s.number("jerk", Range::positive);
    axis.home = s.number("home");
    axis.second_home = s.number("second_home");
    if (name) axis.name = base::to_upper(*name);
    read_direction(s, axis);
    s.finish();
    if (!s.has("name")) s.missing("name");
    if (axis.min && axis.max && *axis.min >= *axis.max) {
        s.error(base::codes::job_value, find(v, "max")->value.where, "'max' must be greater than 'min'");
        axis.min.reset(), axis.max.reset();
    }
    if (!name) return;
    const auto same = [&](const MachineAxis& a) { return a.name == axis.name; };
    if (std::none_of(machine.axes.begin(), machine.axes.end(), same))
        machine.axes.push_back(std::move(axis));
    else
        s.error(base::codes::job_value, find(v, "name")->value.where, "axis " + axis.name + " is defined twice");
}

void read_spindle(Section& file, Machine& machine) {
    const Entry* e = file.sub_table("spindle");
    if (!e) return;
    Section s(e->value, "[spindle]", file.diagnostics());
    MachineSpindle spindle = machine.spindle;
    spindle.min = s.number("min", Range::not_negative).value_or(spindle.min);
    spindle.max = s.number("max", Range::positive).value_or(spindle.max);
    spindle.power = s.number("power", Range::positive);
    s.finish();
    if (spindle.min <= spindle.max)
        machine.spindle = spindle;
    else
        s.error(base::codes::job_value, find(e->value, "min")->value.where, "'min' must not be greater than 'max'");
}

void read_motion(Section& file, Machine& machine) {
    const Entry* e = file.sub_table("motion");
    if (!e) return;
    Section s(e->value, "[motion]", file.diagnostics());
    MachineMotion& m = machine.motion;
    m.acceleration = s.number("acceleration", Range::positive);
    m.jerk = s.number("jerk", Range::positive);
    m.tolerance = s.number("tolerance", Range::positive);
    m.block_time = s.number("block_time", Range::not_negative);
    m.look_ahead = s.number("look_ahead", Range::not_negative);
    m.spindle_time = s.number("spindle_time", Range::not_negative);
    m.servo_gain = s.number("servo_gain", Range::not_negative);
    m.window = s.number("window", Range::positive);
    m.strobe_time = s.number("strobe_time", Range::not_negative);
    if (const auto c = s.choice("corner", {"exact-stop", "filter", "blend"}))
        m.corner = std::array{CornerPassing::exact_stop, CornerPassing::filter, CornerPassing::blend}[*c];
    s.finish();
}

void read_control(Section& file, Machine& machine) {
    const Entry* e = file.sub_table("control");
    if (!e) return;
    Section s(e->value, "[control]", file.diagnostics());
    if (const auto system = s.choice("g_code_system", {"A", "B", "C"})) machine.control.g_code_system = "ABC"[*system];
    if (const auto whole = s.choice("whole_numbers", {"increments", "units"}))
        machine.control.whole_numbers_count = *whole == 0;
    if (const auto step = s.number("increment", Range::positive)) {
        const double digits = std::round(-std::log10(*step)), per_mm = std::pow(10.0, digits);
        constexpr double most_digits = 6, noise = 1e-9;
        if (digits >= 0 && digits <= most_digits && std::abs(*step * per_mm - 1) < noise)
            machine.control.increments_per_mm = per_mm;
        else
            s.error(base::codes::job_value, find(e->value, "increment")->value.where,
                    "'increment' is 1 mm or a decimal part of it (0.001, 0.0001)");
    }
    if (const auto angles = s.choice("angles", {"0-360", "180"})) machine.control.angles_from_zero = *angles == 0;
    s.finish();
}

std::optional<std::size_t> axis_of(const Machine& machine, std::string_view name) {
    for (std::size_t i = 0; i < machine.axes.size(); ++i)
        if (base::equals_ignoring_case(machine.axes[i].name, name)) return i;
    return std::nullopt;
}

/// Adds one item of `chain`; false where it was reported.
bool add_to_chain(const Value& v, Section& file, Machine& machine) {
    const auto index = v.kind == ValueKind::text ? axis_of(machine, v.text) : std::nullopt;
    std::string text;
    if (!index)
        text = v.kind == ValueKind::text ? "'chain' names an axis that the machine does not have: " + v.text
                                         : "an item of 'chain' must be the name of an axis";
    else if (std::find(machine.chain.begin(), machine.chain.end(), *index) != machine.chain.end())
        text = "'chain' names axis " + machine.axes[*index].name + " twice";
    else if (machine.axes[*index].direction == geom::Vec3{})
        text = "axis " + machine.axes[*index].name + " has no 'direction', and its name does not say one";
    if (text.empty())
        machine.chain.push_back(*index);
    else
        file.error(base::codes::job_value, v.where, text);
    return text.empty();
}

/// From the workpiece to the tool; where nothing is said, of a mill that does not turn all axes whose direction is
/// known.
void read_chain(Section& file, Machine& machine) {
    const Entry* e = file.take("chain");
    if (!e) {
        const bool turns =
            std::any_of(machine.axes.begin(), machine.axes.end(), [](const MachineAxis& a) { return a.rotary; });
        for (std::size_t i = 0; i < machine.axes.size() && machine.kind == MachineKind::mill && !turns; ++i)
            if (!(machine.axes[i].direction == geom::Vec3{})) machine.chain.push_back(i);
        return;
    }
    if (e->value.kind != ValueKind::array)
        return file.error(base::codes::job_value, e->value.where,
                          "'chain' must be an array of names of axes, not " + std::string(kind_name(e->value.kind)));
    bool good = true;
    for (const Value& v : e->value.items) good = add_to_chain(v, file, machine) && good;
    if (!good) machine.chain.clear();  // half a chain would be another machine
}

void read_tool_change_position(Section& file, Machine& machine) {
    const Entry* e = file.sub_table("tool_change_position");
    if (!e) return;
    for (const Entry& axis : e->value.entries) {
        const auto index = axis_of(machine, axis.key);
        if (!index) {
            file.error(base::codes::job_file, axis.where,
                       "'tool_change_position' names an axis that the machine does not have: " + axis.key);
        } else if (const auto v = finite_number(axis.value, "'" + axis.key + "'", Range::any, file.diagnostics())) {
            machine.tool_change_position[machine.axes[*index].name] = *v;
        }
    }
}

void read_feeds(Section& file, Machine& machine) {
    machine.max_feed = file.number("max_feed", Range::not_negative).value_or(0);
    machine.min_feed = file.number("min_feed", Range::not_negative).value_or(0);
    if (machine.max_feed > 0 && machine.min_feed > machine.max_feed) {
        file.error(base::codes::job_value, find(file.table(), "min_feed")->value.where,
                   "'min_feed' must not be greater than 'max_feed'");
        machine.min_feed = 0;
    }
    if (const auto r = file.choice("rapid", {"straight", "dog-leg"}))
        machine.rapid_path = *r == 0 ? RapidPath::straight : RapidPath::dog_leg;
}

void read_machine_data(Section& file, Machine& machine) {
    const Entry* e = file.sub_table("machine_data");
    if (!e) return;
    for (const Entry& datum : e->value.entries) {
        std::string name = base::to_upper(datum.key);
        if (!name.starts_with('$')) name.insert(0, 1, '$');
        if (!name.starts_with("$MN_") && !name.starts_with("$MC_") && !name.starts_with("$MA_")) {
            file.error(base::codes::job_file, datum.where, "'" + datum.key + "' is not the name of a machine datum",
                       "$MN_…, $MC_… or $MA_…");
        } else if (const auto v = finite_number(datum.value, "'" + datum.key + "'", Range::value, file.diagnostics())) {
            machine.machine_data[name] = *v;
        }
    }
}

}  // namespace

Machine read_machine(std::uint32_t file, const base::Sources& sources, base::Diagnostics& diagnostics) {
    Machine machine;
    const auto root = parse_toml(file, sources, diagnostics);
    if (!root) return machine;
    base::Diagnostics found;
    Section s(*root, "the machine file", found);
    machine.name = s.text("name").value_or(machine.name);
    if (const auto kind = s.choice("kind", {"lathe", "mill"}))
        machine.kind = *kind == 0 ? MachineKind::lathe : MachineKind::mill;
    if (!s.has("kind")) s.missing("kind");
    if (machine.kind == MachineKind::lathe) machine.defaults.plane = 18;
    read_feeds(s, machine);
    machine.tool_change_time = s.number("tool_change_time", Range::not_negative);
    machine.tool_change_stops_spindle = s.boolean("tool_change_stops_spindle");
    for (const Value* axis : s.tables("axis")) read_axis(*axis, found, machine);
    read_chain(s, machine);
    read_tool_change_position(s, machine);
    read_spindle(s, machine);
    read_motion(s, machine);
    apply_defaults(read_defaults(s), machine.defaults);
    read_control(s, machine);
    machine.datums = read_datums(s);
    read_machine_data(s, machine);
    read_origins(s, machine);
    s.finish_file(diagnostics);
    return machine;
}

}  // namespace obrys::shop
