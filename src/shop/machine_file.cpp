#include <algorithm>

#include "base/codes.hpp"
#include "base/text.hpp"
#include "shop/machine.hpp"
#include "shop/tables.hpp"

namespace obrys::shop {

namespace {

void read_axis(const Value& v, base::Diagnostics& diagnostics, Machine& machine) {
    Section s(v, "[[axis]]", diagnostics);
    if (v.kind != ValueKind::table) return;
    MachineAxis axis;
    const auto name = s.text("name");
    axis.rotary = s.boolean("rotary").value_or(false);
    axis.min = s.number("min");
    axis.max = s.number("max");
    axis.rapid = s.number("rapid", Range::positive).value_or(axis.rapid);
    axis.home = s.number("home");
    s.finish();
    if (!s.has("name")) s.missing("name");
    if (axis.min && axis.max && *axis.min >= *axis.max) {
        s.error(base::codes::job_value, find(v, "max")->value.where, "'max' must be greater than 'min'");
        axis.min.reset(), axis.max.reset();
    }
    if (!name) return;
    axis.name = base::to_upper(*name);
    const auto same = [&](const MachineAxis& a) { return a.name == axis.name; };
    if (std::none_of(machine.axes.begin(), machine.axes.end(), same)) machine.axes.push_back(std::move(axis));
    else s.error(base::codes::job_value, find(v, "name")->value.where, "axis " + axis.name + " is defined twice");
}

void read_spindle(Section& file, Machine& machine) {
    const Entry* e = file.sub_table("spindle");
    if (!e) return;
    Section s(e->value, "[spindle]", file.diagnostics());
    MachineSpindle spindle = machine.spindle;
    spindle.min = s.number("min", Range::not_negative).value_or(spindle.min);
    spindle.max = s.number("max", Range::positive).value_or(spindle.max);
    s.finish();
    if (spindle.min <= spindle.max) machine.spindle = spindle;
    else s.error(base::codes::job_value, find(e->value, "min")->value.where, "'min' must not be greater than 'max'");
}

void read_control(Section& file, Machine& machine) {
    const Entry* e = file.sub_table("control");
    if (!e) return;
    Section s(e->value, "[control]", file.diagnostics());
    if (const auto system = s.choice("g_code_system", {"A", "B", "C"})) machine.control.g_code_system = "ABC"[*system];
    if (const auto whole = s.choice("whole_numbers", {"increments", "units"})) machine.control.whole_numbers_count = *whole == 0;
    s.finish();
}

void read_machine_data(Section& file, Machine& machine) {
    const Entry* e = file.sub_table("machine_data");
    if (!e) return;
    for (const Entry& datum : e->value.entries) {
        std::string name = base::to_upper(datum.key);
        if (!name.starts_with('$')) name.insert(0, 1, '$');
        if (!name.starts_with("$MN_") && !name.starts_with("$MC_") && !name.starts_with("$MA_")) {
            file.error(base::codes::job_file, datum.where, "'" + datum.key + "' is not the name of a machine datum", "$MN_…, $MC_… or $MA_…");
        } else if (const auto v = finite_number(datum.value, "'" + datum.key + "'", Range::any, file.diagnostics())) {
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
    if (const auto kind = s.choice("kind", {"lathe", "mill"})) machine.kind = *kind == 0 ? MachineKind::lathe : MachineKind::mill;
    if (!s.has("kind")) s.missing("kind");
    if (machine.kind == MachineKind::lathe) machine.defaults.plane = 18;
    machine.max_feed = s.number("max_feed", Range::not_negative).value_or(0);
    machine.tool_change_time = s.number("tool_change_time", Range::not_negative).value_or(0);
    for (const Value* axis : s.tables("axis")) read_axis(*axis, found, machine);
    read_spindle(s, machine);
    apply_defaults(read_defaults(s), machine.defaults);
    read_control(s, machine);
    machine.datums = read_datums(s);
    read_machine_data(s, machine);
    s.finish();
    add_in_order(found, diagnostics);
    return machine;
}

}  // namespace obrys::shop
