/// G10: zero offsets and tool data written by the program.
/// Source: LinuxCNC, G-Codes, "G10 L1", "G10 L2", "G10 L10", "G10 L11", "G10 L20".

#include <algorithm>
#include <cmath>

#include "base/codes.hpp"
#include "base/whole.hpp"
#include "interp/setup/setup.hpp"
#include "interp/values/nose_of_tool.hpp"

namespace obrys::interp {

namespace codes = base::codes;

namespace {

void refuse_g10(Saying& run, std::string text) {
    alarm(run, codes::value_range, run.here(), "G10: " + std::move(text));
}

std::optional<int> whole(Moving& run, Code code, const char* letter, int most) {
    const double v = run.block.has(code) ? run.block.get(code) : -1;
    if (std::isnan(v)) {
        unchecked(run, codes::unknown_value, run.here(),
                  "what G10 writes depends on a value that is not known: " + std::string(letter));
        return std::nullopt;
    }
    if (const auto n = base::whole<int>(v, 0, most)) return n;
    refuse_g10(run, std::string(letter) + " must be a whole number from 0 to " + std::to_string(most));
    return std::nullopt;
}

/// As machine_coordinate, of a machine whose zero is taken to lie at 0 where nobody knows it: how far that zero goes on
/// does not depend on its place.
double counted_coordinate(const Reckoning& run, std::size_t axis) {
    const Offsets& o = run.offsets;
    return axis < 3 ? coordinate(run.position, static_cast<int>(axis)) + o.reference[axis] + tip_in_use(o)[axis]
                    : machine_coordinate(run, axis);
}

/// Coordinates in a zero offset with this place in the parameters, as they would be programmed there, without G92.
Axes coordinates_in(const Reckoning& run, std::uint32_t first) {
    const program::OffsetParameters& p = run.traits->offsets;
    Axes c{};
    for (std::size_t k = 0; k < 9; ++k) {
        const double unit = stored_unit(run, k);
        c[k] = counted_coordinate(run, k) - run.offsets.tool[k] -
               run.parameters.get(first + static_cast<std::uint32_t>(k)) * unit;
    }
    const double turn = p.rotation == 0 ? 0 : geom::radians(run.parameters.get(first + p.rotation));
    const double x = c[0] * std::cos(turn) + c[1] * std::sin(turn), y = c[1] * std::cos(turn) - c[0] * std::sin(turn);
    c[0] = x;
    c[1] = y;
    return c;
}

/// How far the offset goes on in the machine so that the axes of the block have the coordinates of their words.
Axes step_to_words(const Moving& run, std::uint32_t first) {
    const program::OffsetParameters& p = run.traits->offsets;
    const Axes at = coordinates_in(run, first);
    Axes step{};
    for (std::size_t k = 0; k < 9; ++k)
        if (const auto v = axis_word(run, k)) step[k] = at[k] - run.offsets.shift[k] - *v;
    const double turn = p.rotation == 0 ? 0 : geom::radians(run.parameters.get(first + p.rotation));
    const double x = step[0] * std::cos(turn) - step[1] * std::sin(turn),
                 y = step[0] * std::sin(turn) + step[1] * std::cos(turn);
    step[0] = x;
    step[1] = y;
    return step;
}

/// Tells what has been written to a zero, along the axes that `said` holds a bit for.
void tell_zero(Moving& run, std::uint32_t number, std::uint32_t first, unsigned said, bool known) {
    cl::DatumData data;
    data.number = number;
    for (std::size_t k = 0; k < 3 && known; ++k)
        if ((said >> k & 1U) != 0)
            coordinate(data.origin, static_cast<int>(k)) =
                run.parameters.get(first + static_cast<std::uint32_t>(k)) * stored_unit(run, k);
    const program::OffsetParameters& p = run.traits->offsets;
    if (run.block.has(Code::radius) && p.rotation != 0)
        data.turn = geom::radians(run.parameters.get(first + p.rotation));
    emit(run, data);
}

/// A zero has been set by where the machine stands: known where that is.
void take_from_position(Moving& run, std::uint32_t parameter, std::size_t axis, bool in_force) {
    if (std::isnan(machine_coordinate(run, axis)))
        run.parameters.doubt(parameter);
    else if (!in_force)
        run.parameters.mark_set(parameter);
}

void set_datum_data(Moving& run, bool from_position) {
    const program::OffsetParameters& p = run.traits->offsets;
    const auto which = whole(run, Code::p, "P", static_cast<int>(p.datum_count));
    if (!which) return;
    flush_path(run);
    const std::uint32_t active = place_of_datum(run.modal.datum);
    const std::uint32_t place = *which == 0 ? active : static_cast<std::uint32_t>(*which);
    if (place < 1 || place > p.datum_count)
        return unchecked(run, codes::unsupported, run.here(), "G10 of this zero offset is not run");
    const std::uint32_t first = p.datum_first + (place - 1) * p.datum_step;
    if (run.block.has(Code::radius) && p.rotation != 0)
        run.parameters.set(first + p.rotation, run.block.get(Code::radius));
    const Axes step = from_position ? step_to_words(run, first) : Axes{};
    unsigned said = 0;
    bool known = true;
    if (from_position && place == active && axis_word(run, 2)) zero_set_here(run);
    for (std::size_t k = 0; k < 9; ++k) {
        const std::uint32_t n = first + static_cast<std::uint32_t>(k);
        const double unit = stored_unit(run, k);
        const bool v = axis_word(run, k) || step[k] != 0;  // in a turned zero one word moves X and Y of it
        if (v && k < 3) said |= 1U << k, known = known && (!from_position || run.parameters.is_set(n));
        if (from_position)
            run.parameters.add(n, step[k] / unit);
        else if (v)
            run.parameters.set(n, *axis_word(run, k) / unit);
        if (from_position && v) take_from_position(run, n, k, place == active);
        if (v && k < 3) known = known && (!from_position || run.parameters.is_set(n));
    }
    tell_zero(run, number_of_place(place), first, said, known);
    if (place != active) return hear(run, heard::OtherZero{});
    const double turned = run.offsets.rotation;
    load_datum(run);
    if (run.offsets.rotation != turned && (run.offsets.shift[0] != 0 || run.offsets.shift[1] != 0))
        unchecked(
            run, codes::unsupported, run.here(),
            "R turns the system in force while G92 or G52 shifts it: LinuxCNC loses its place then and moves X and "
            "Y aside with the next move, a fault of its own that is not followed here",
            "cancel the shift before (G92.1) and set it again");
    hear(run, heard::Zero{run.modal.datum, run.offsets.datum, {}, run.offsets.rotation});
    update_frame(run);
}

/// Nobody has given the table: the control's own is taken to have the tool, since a program that writes to it needs it.
shop::Tool* in_table_not_given(Moving& run, int number) {
    assume(run, run.here(),
           "no tool table is given: tool " + std::to_string(number) + " is taken to be in it, where G10 needs it to be",
           "give the table with --tools, and see that the control's has the tool");
    const auto made = add_tool(run, static_cast<std::uint32_t>(number));
    made->assumed = "written by the program";
    return &*made;
}

shop::Tool* tool_of_block(Moving& run) {
    const auto number = whole(run, Code::p, "P", 99'999'999);
    if (!number) return nullptr;
    const auto found = std::find_if(run.tools.begin(), run.tools.end(), [&](const shop::Tool& t) {
        return t.number == static_cast<std::uint32_t>(*number);
    });
    if (found != run.tools.end()) return &*found;
    if (run.env.tools.empty() && !run.env.stand_alone) return in_table_not_given(run, *number);
    alarm(run, codes::value_range, run.here(), "G10: tool " + std::to_string(*number) + " is not in the tool table",
          "add a row for it to the table");
    return nullptr;
}

void turn_about_z(Axes& a, double by) {
    const double x = a[0] * std::cos(by) - a[1] * std::sin(by), y = a[0] * std::sin(by) + a[1] * std::cos(by);
    a[0] = x;
    a[1] = y;
}

/// L10: the offset with which the position has the words' coordinates; L11: in the ninth zero offset (G59.3). What the
/// tool's offset has beyond the active one stays in axes without a word, seen in the turned coordinates.
Axes measured(const Moving& run, const Axes& table, bool in_ninth) {
    const program::OffsetParameters& p = run.traits->offsets;
    const std::uint32_t ninth = p.datum_first + 8 * p.datum_step;
    const Axes there = in_ninth ? coordinates_in(run, ninth) : Axes{};
    const double turn = geom::radians(in_ninth ? run.parameters.get(ninth + p.rotation) : run.offsets.rotation);
    Axes beyond{};
    for (std::size_t k = 0; k < 9; ++k) beyond[k] = table[k] - run.offsets.tool[k];
    turn_about_z(beyond, -turn);
    for (std::size_t k = 0; k < 9; ++k)
        if (const auto word = axis_word(run, k)) beyond[k] = (in_ninth ? there[k] : axis_coordinate(run, k)) - *word;
    turn_about_z(beyond, turn);
    for (std::size_t k = 0; k < 9; ++k) beyond[k] += run.offsets.tool[k];
    return beyond;
}

/// Half of the table's diameter; of an insert that is its nose, which compensation works with.
void set_radius(shop::Tool& t, double radius) {
    t.table->diameter = 2 * radius;
    t.radius = radius;
    if (t.kind == shop::ToolKind::turning) t.nose_radius = radius;
}

/// What is cut goes by the insert of the tool list.
void compare_nose(Saying& run, const shop::Tool& t) {
    const auto job = std::find_if(run.env.tools.begin(), run.env.tools.end(),
                                  [&](const shop::Tool& x) { return x.number == t.number && x.edge == t.edge; });
    if (run.env.stand_alone || job == run.env.tools.end() || job->kind != shop::ToolKind::turning) return;
    constexpr double same = 1e-6;  // mm
    if (std::abs(t.nose_radius - job->nose_radius) < same && table_orientation(t) == table_orientation(*job)) return;
    assume(run, run.here(),
           "the program gives the nose of tool " + std::to_string(t.number) +
               " another radius R or orientation Q than the tool list: the path is compensated by the program's, and "
               "the tool is taken to have the tool list's",
           "give the tool the nose that it has");
}

/// Length and radius; what else there is as a record without values.
void tell_tool_data(Moving& run, const shop::Tool& t, int l) {
    const BlockWords& b = run.block;
    cl::ToolData data{t.number, t.edge, {}, {}};
    if (l == 1 && axis_word(run, 2)) data.length = t.length;
    if (b.has(Code::radius)) data.radius = t.radius;
    bool other = l != 1 || b.has(Code::i) || b.has(Code::j) || b.has(Code::q);
    for (std::size_t k = 0; k < 9; ++k) other = other || (k != 2 && axis_word(run, k));
    if (data.length || data.radius) emit(run, data);
    if (other) emit(run, cl::ToolData{t.number, t.edge, {}, {}});
}

void set_tool_data(Moving& run, int l) {
    shop::Tool* t = tool_of_block(run);
    if (t == nullptr) return;
    const BlockWords& b = run.block;
    const double unit = length_unit(run.modal);
    if (!t->table) {
        const int orientation = table_orientation(*t).value_or(0);
        t->table.emplace().orientation = orientation;
    }
    auto& table = *t->table;
    table.offset[2] = t->length;
    if (l != 1) table.offset = measured(run, table.offset, l == 11);
    for (std::size_t k = 0; k < 9 && l == 1; ++k)
        if (const auto word = axis_word(run, k)) table.offset[k] = *word;
    t->length = table.offset[2];
    if (b.has(Code::radius)) set_radius(*t, b.get(Code::radius) * unit);
    if (l == 1) compare_with_job(run, *t);
    if (b.has(Code::i)) table.front_angle = b.get(Code::i);
    if (b.has(Code::j)) table.back_angle = b.get(Code::j);
    if (b.has(Code::q))
        if (const auto q = whole(run, Code::q, "Q, the orientation of a lathe tool,", 9)) table.orientation = *q;
    if (l == 1) compare_nose(run, *t);
    tell_tool_data(run, *t, l);
    const auto place = static_cast<int>(t - run.tools.data()) + 1;
    // The control's list begins with the tool in the spindle; before the first change its first tool stands there.
    const bool loaded = run.tool.data == t || (run.tool.number == 0 && place == 1);
    for (const int entry : {place, 0}) {
        if (entry == 0 && !loaded) continue;
        heard::ToolEntry row{
            entry, static_cast<int>(t->number), table.offset, table.front_angle, table.back_angle, table.orientation};
        row.offset[2] = t->length;
        hear(run, row);
    }
    if (loaded) take_tip(run);
}

/// The first parameter of a zero offset by its place, P of G10.
std::optional<std::uint32_t> row_of_datum(Moving& run, program::DataTable table) {
    const program::OffsetParameters& p = run.traits->offsets;
    if (table == program::DataTable::external_datum) return p.external_first;
    const bool extended = table == program::DataTable::extended_datum;
    const std::uint32_t count = extended ? p.extended_count : p.datum_count;
    const auto row = whole(run, Code::p, "P", static_cast<int>(count));
    if (!row) return std::nullopt;
    if (*row == 0) return refuse_g10(run, "P must be the number of a zero offset"), std::nullopt;
    return (extended ? p.extended_first : p.datum_first) + (static_cast<std::uint32_t>(*row) - 1) * p.datum_step;
}

void write_datum(Moving& run, program::DataTable table) {
    const auto first = row_of_datum(run, table);
    if (!first) return;
    flush_path(run);
    cl::DatumData data;
    if (const auto zero = zero_of(run.traits->offsets, *first)) data.number = zero->number;
    data.added = !run.modal.absolute;
    for (std::size_t k = 0; k < 9; ++k) {
        const auto v = axis_word(run, k);
        if (!v) continue;
        const std::uint32_t n = *first + static_cast<std::uint32_t>(k);
        const double written = *v / stored_unit(run, k);
        run.modal.absolute ? run.parameters.set(n, written) : run.parameters.add(n, written);
        if (k < 3) coordinate(data.origin, static_cast<int>(k)) = *v;
    }
    emit(run, data);
    datum_changed(run);
}

/// The tool of offset P; one that no list has begins without dimensions.
shop::Tool* tool_of_offset(Moving& run) {
    const auto number = whole(run, Code::p, "P", 99'999);
    if (!number) return nullptr;
    if (*number == 0) return refuse_g10(run, "P must be the number of a tool offset"), nullptr;
    const auto n = static_cast<std::uint32_t>(*number);
    for (shop::Tool& t : run.tools)
        if (t.number == n) return &t;
    const auto made = add_tool(run, n);
    made->assumed = "written by the program";
    return &*made;
}

void write_tool_offset(Moving& run, program::DataTable table) {
    using program::DataTable;
    if (!run.block.has(Code::radius)) return refuse_g10(run, "R, the value, is missing");
    if (std::isnan(run.block.get(Code::radius)))
        return unchecked(run, codes::unknown_value, run.here(),
                         "what G10 writes to the tool offset is a value that is not known: the offset stays as it was");
    shop::Tool* t = tool_of_offset(run);
    if (t == nullptr) return;
    flush_path(run);
    const bool diameter = table == DataTable::tool_diameter || table == DataTable::tool_diameter_wear;
    double* value = table == DataTable::tool_length                                        ? &t->length
                    : table == DataTable::tool_length_wear                                 ? &t->delta_length
                    : table == DataTable::tool_radius || table == DataTable::tool_diameter ? &t->radius
                                                                                           : &t->delta_radius;
    const double r = run.block.get(Code::radius) * length_unit(run.modal) * (diameter ? 0.5 : 1);
    *value = r + (run.modal.absolute ? 0 : *value);
    cl::ToolData data{t->number, t->edge, {}, {}};
    if (table == DataTable::tool_length) data.length = *value;
    if (table == DataTable::tool_radius || table == DataTable::tool_diameter) data.radius = *value;
    emit(run, data);
    compare_with_job(run, *t);
    if (run.tool.data == t) take_tip(run);
}

}  // namespace

void set_data(Moving& run, program::DataTable table) {
    using program::DataTable;
    run.block.use(Code::l);  // which table, and which row of it
    run.block.use(Code::p);
    if (table == DataTable::external_datum || table == DataTable::datum || table == DataTable::extended_datum)
        return write_datum(run, table);
    if (table != DataTable::by_l) return write_tool_offset(run, table);
    if (!run.block.has(Code::l)) return refuse_g10(run, "L is missing");
    const double l = run.block.get(Code::l);
    switch (l >= 0 ? base::cut<int>(l, 0, 99).value_or(-1) : -1) {
        case 1:
        case 10:
        case 11: return set_tool_data(run, base::clipped<int>(l, 0, 99));
        case 2: return set_datum_data(run, false);
        case 20: return set_datum_data(run, true);
        default:
            unchecked(run, codes::unsupported, run.here(),
                      "G10 L" + printed(Value::real(run.block.get(Code::l))) + " is not run");
    }
}

}  // namespace obrys::interp
