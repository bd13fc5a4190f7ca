/// FN 18: SYSREAD: ID and NR say which datum of the control is meant.

#include <algorithm>

#include "base/whole.hpp"
#include "dialect/heidenhain/sysread.hpp"
#include "read/heidenhain/state.hpp"

namespace obrys::read::heidenhain {

using dialect::heidenhain::SysRead;
using program::Expr;
using program::ExprKind;
using program::no_expr;
using program::SystemVariable;

namespace {

SystemVariable tool_column(int nr) {
    switch (nr) {
        case 1: return SystemVariable::table_length;
        case 2: return SystemVariable::table_radius;
        case 3: return SystemVariable::table_corner_radius;
        case 4: return SystemVariable::table_delta_length;
        case 5: return SystemVariable::table_delta_radius;
        case 6: return SystemVariable::table_delta_corner;
        default: return SystemVariable::unknown;
    }
}

SystemVariable call_datum(int nr) {
    switch (nr) {
        case 1: return SystemVariable::tool_number;
        case 2: return SystemVariable::tool_axis;
        case 3: return SystemVariable::spindle_speed;
        case 4: return SystemVariable::call_delta_length;
        case 5: return SystemVariable::call_delta_radius;
        case 7: return SystemVariable::call_delta_corner;
        default: return SystemVariable::unknown;
    }
}

SystemVariable meaning(SysRead what, int nr) {
    switch (what) {
        case SysRead::program_unit: return SystemVariable::inch_program;
        case SysRead::tool_number: return SystemVariable::tool_number;
        case SysRead::prepared_tool: return SystemVariable::prepared_tool;
        case SysRead::tool_axis: return SystemVariable::tool_axis;
        case SysRead::spindle_speed: return SystemVariable::spindle_speed;
        case SysRead::spindle_state: return SystemVariable::spindle_state;
        case SysRead::coolant_state: return SystemVariable::coolant_state;
        case SysRead::feed: return SystemVariable::feed;
        case SysRead::table_tool: return tool_column(nr);
        case SysRead::called_tool: return call_datum(nr);
        case SysRead::active_radius: return SystemVariable::active_radius;
        case SysRead::active_length: return SystemVariable::active_length;
        case SysRead::program_rotation: return SystemVariable::active_rotation;
        case SysRead::scaling: return SystemVariable::scale_of_axis;
        case SysRead::datum_shift: return SystemVariable::shift_of_axis;
        case SysRead::limit_negative: return SystemVariable::travel_min;
        case SysRead::limit_positive: return SystemVariable::travel_max;
        case SysRead::machine_position: return SystemVariable::machine_position;
        case SysRead::position: return SystemVariable::work_position;
        case SysRead::active_preset: return SystemVariable::active_datum;
        default: return SystemVariable::unknown;
    }
}

bool by_axis(SystemVariable v) {
    return v == SystemVariable::machine_position || v == SystemVariable::work_position ||
           v == SystemVariable::shift_of_axis || v == SystemVariable::scale_of_axis ||
           v == SystemVariable::travel_min || v == SystemVariable::travel_max;
}

/// The number of a literal; -1 for what is computed.
int literal_of(const program::Unit& unit, ExprId id) {
    if (id == no_expr) return -1;
    const Expr& e = unit.exprs[id];
    return e.kind == ExprKind::number ? base::cut<int>(unit.numbers[e.a], 0, 999'999).value_or(-1) : -1;
}

}  // namespace

ExprId system_datum(State& s, ExprId id, ExprId nr, ExprId index, std::uint32_t begin) {
    const std::uint32_t end = s.in.at();
    const program::Unit& unit = s.build.unit();
    const int id_number = literal_of(unit, id), nr_number = literal_of(unit, nr), axis = literal_of(unit, index);
    const auto* entry = dialect::heidenhain::find_sysread(id_number, nr_number, std::max(axis, 0));
    if (entry == nullptr && index != no_expr && axis < 0)
        entry = dialect::heidenhain::find_sysread(id_number, nr_number, 1);
    const SystemVariable v = entry == nullptr ? SystemVariable::unknown : meaning(entry->what, nr_number);
    Expr e;
    e.kind = ExprKind::system;
    e.op = static_cast<std::uint8_t>(v);
    const auto shown = [&](std::string_view word, ExprId value) {
        if (value == no_expr) return std::string();
        return " " + std::string(word) + std::string(s.in.between(unit.exprs[value].begin, unit.exprs[value].end));
    };
    e.a = s.build.name("SYSREAD" + shown("ID", id) + shown("NR", nr) + shown("IDX", index));
    std::vector<ExprId> children;
    if (by_axis(v) && axis >= 1 && axis <= 9)
        children.push_back(s.build.text(std::string(1, "XYZABCUVW"[axis - 1]), begin, end));
    else if (index != no_expr)
        children.push_back(index);
    s.build.adopt(e, children);
    return s.build.add(e, begin, end);
}

}  // namespace obrys::read::heidenhain
