/// Zero offsets, shifts and tool lengths as controls keep them that hold them in numbered parameters (Traits::offsets).
/// machine = zero offset + rotation(programmed + shift) + tool offset (LinuxCNC, Coordinate System; Fanuc, Coordinate
/// system functions). The stream's coordinates are those of the tool's tip, counted from the zero offset that is active
/// when the first move is made; what a length compensation that is not that of the tool does to the tip is seen there.

#include <cmath>

#include "base/codes.hpp"
#include "base/whole.hpp"
#include "cl/unknown_tool.hpp"
#include "interp/motion.hpp"

namespace obrys::interp {

namespace codes = base::codes;
using cl::SettingKind;

namespace {

/// mm (degrees) of a parameter that holds a coordinate of this axis.
double stored(const Reckoning& run, std::uint32_t parameter, std::size_t axis) {
    return run.parameters.get(parameter) * stored_unit(run, axis);
}

/// What is added to every zero offset, mm (degrees).
double external(const Reckoning& run, std::size_t axis) {
    const std::uint32_t first = run.traits->offsets.external_first;
    return first == 0 ? 0 : stored(run, first + static_cast<std::uint32_t>(axis), axis);
}

/// The number of no tool: an H that no tool list can have.
constexpr std::uint32_t no_listed_tool = 0xFFFFFFFF;

const shop::Tool* listed_tool(const Reckoning& run, double number) {
    for (const shop::Tool& t : run.tools)
        if (t.number == number) return &t;
    return nullptr;
}

/// What G43 means: the axes of tool H, of the one in the spindle, or nothing where it is not known.
std::optional<Axes> length_of_block(Moving& run) {
    const std::optional<double> h = length_number(run);
    if (h && *h == 0) return Axes{};
    if (h && std::isnan(*h)) {
        unchecked(run, codes::unknown_value, run.here(),
                  "which tool length offset H is meant depends on a value that is not known");
        return std::nullopt;
    }
    const shop::Tool* t = h ? listed_tool(run, *h) : run.tool.data;
    if (t != nullptr) return axes_of(*t);
    if (!h && run.tool.number == cl::unknown_tool) return std::nullopt;
    if (!h && run.tool.number == 0) return Axes{};
    if (run.tools.empty()) {
        assume(run, run.here(),
               "no tools are given: the tool length offset is taken as that of the tool in the spindle",
               "give the tool table of the control to have offset numbers and lengths checked");
        return std::nullopt;
    }
    const std::string which = h ? "H" + printed(Value::real(*h)) : "T" + std::to_string(run.tool.number);
    alarm(run, codes::tool_missing, run.here(), "tool length offset: " + which + " is not in the tool table");
    return std::nullopt;
}

void keep_shift(Reckoning& run) {
    const program::OffsetParameters& p = run.traits->offsets;
    if (p.shift_first == 0) return;
    for (std::size_t k = 0; k < 9; ++k)
        run.parameters.set(p.shift_first + static_cast<std::uint32_t>(k), run.offsets.shift[k] / stored_unit(run, k));
    run.parameters.set(p.shift_active, 1);
}

void take_shift(Reckoning& run) {
    const program::OffsetParameters& p = run.traits->offsets;
    for (std::size_t k = 0; k < 9 && p.shift_first != 0; ++k)
        run.offsets.shift[k] = stored(run, p.shift_first + static_cast<std::uint32_t>(k), k);
}

/// G92 where the machine's place is not known: it makes the frame in which the job's bodies lie, or another one.
void say_unknown_places(Moving& run) {
    std::string axes;
    for (std::size_t k = 0; k < 9; ++k) {
        if (!axis_word(run, k) || !std::isnan(axis_coordinate(run, k))) continue;
        run.offsets.from_unknown |= 1u << k;
        axes += (axes.empty() ? "" : ", ") + axis_name(k);
    }
    if (axes.empty()) return;
    const std::string place = "where the machine stands (" + axes + ") when the program says what its position becomes";
    if (!run.offsets.lost)
        return assume(run, run.here(),
                      place + " is not known: the zero that it makes is taken as the one that stock and part are in",
                      "position the axes in the zero offset before it where they are in that one");
    unchecked(
        run, codes::unknown_value, run.here(),
        place + " is not known: the zero before and the new one are taken as the same",
        "position the axes before it, or give home in the machine file and the zero offset in [datum] of the job");
}

/// What G92 has shifted ends, and was from a place not known.
void say_unknown_return(Reckoning& run) {
    if (run.offsets.from_unknown == 0) return;
    run.offsets.from_unknown = 0;
    unchecked(run, codes::unknown_value, run.here(),
              "how far the zero moves back is not known, for it was set where the machine's place was not known: both "
              "zeros are taken as the same",
              "position the axes before their position is set");
}

/// G92.1, G92.2, G92.3 and G52 end the shift in force: where the program has not said which that is, it is the one from
/// before it, which LinuxCNC keeps in its var file.
void say_shift_from_before(Telling& run, Modal m) {
    const std::uint32_t first = run.traits->offsets.shift_first;
    if (first == 0 || m == Modal::position_becomes) return;
    const bool said = run.offsets.shift_said || run.env.stored != nullptr || run.env.tell_settings;
    bool kept = true;
    for (std::uint32_t k = 0; k < 3; ++k) kept = kept && run.parameters.is_set(first + k);
    run.offsets.shift_said = true;
    if (m == Modal::position_restore && !kept && !run.env.tell_settings && run.env.stored == nullptr)
        return unchecked(run, codes::unknown_value, run.here(),
                         "the shift that is brought back is from before the program and is not known: taken as none",
                         "give the parameter file of the control with --var, or [variables] of the job");
    if (!said && run.moved)
        assume(run, run.here(), "no shift is taken to have been in force when the program began",
               "cancel it before the first move");
}

/// G92: where the axis stands is `to` from now on. A machine whose place is not known stands there by definition.
void becomes(Reckoning& run, std::size_t k, double to) {
    const double at = axis_coordinate(run, k);
    if (!std::isnan(at)) {
        run.offsets.shift[k] += at - to;
    } else if (k < 3) {
        coordinate(run.programmed_position, static_cast<int>(k)) = to;
        run.position = geom::apply(run.frame, run.programmed_position);
    } else {
        run.extra_axes[axis_name(k)] = to + run.offsets.total[k];
    }
}

/// The coordinates of an additional axis count from another place of the machine; it stands where it stood.
void count_from(Telling& run, std::size_t k, double datum) {
    const double by = run.offsets.reference[k] - datum;
    const auto at = run.extra_axes.find(axis_name(k));
    if (by == 0 || at == run.extra_axes.end()) return;
    at->second += by;
    emit(run, axis_record(at->first, at->second, is_rotary(k), false));
}

}  // namespace

namespace {

/// Parameter that holds X of a zero offset; nothing for one that is kept nowhere.
std::optional<std::uint32_t> first_of_datum(const Saying& run, std::uint32_t number) {
    const program::OffsetParameters& p = run.traits->offsets;
    const std::uint32_t place = place_of_datum(number) - 1;
    if (place < p.datum_count) return p.datum_first + place * p.datum_step;
    if (place >= 1000 && place - 1000 < p.extended_count) return p.extended_first + (place - 1000) * p.datum_step;
    return std::nullopt;
}

constexpr std::size_t rotation_about_z = 9;  // behind the axes

bool holds_all(const Saying& run) { return run.env.stored != nullptr || run.env.tell_settings; }

/// What a zero offset has for this axis (or as its rotation) is known; what the job leaves out is 0.
bool holds(const Reckoning& run, std::uint32_t datum, std::size_t axis) {
    if (holds_all(run) || run.env.machine.datums.contains(datum)) return true;
    const std::uint32_t behind =
        axis == rotation_about_z ? run.traits->offsets.rotation : static_cast<std::uint32_t>(axis);
    const auto first = first_of_datum(run, datum);
    return first && (axis != rotation_about_z || behind != 0) && run.parameters.is_set(*first + behind);
}

bool holds_external(const Reckoning& run, std::size_t axis) {
    const std::uint32_t first = run.traits->offsets.external_first;
    return holds_all(run) || (first != 0 && run.parameters.is_set(first + static_cast<std::uint32_t>(axis)));
}

/// What is known before anything has moved.
void note_given(Reckoning& run) {
    Offsets& o = run.offsets;
    for (std::size_t k = 0; k < o.given.size(); ++k) o.given[k] = holds(run, run.reference_datum, k);
    for (std::size_t k = 0; k < o.external_given.size(); ++k) o.external_given[k] = holds_external(run, k);
}

/// How far the active zero offset lies from the one in which the moves before are. A value that is written over one
/// that nobody knows says nothing about that, though both are offsets of the same name.
bool is_place_known(const Reckoning& run) {
    const Offsets& o = run.offsets;
    for (std::size_t k = 0; k < o.external_given.size(); ++k)
        if (holds_external(run, k) && !o.external_given[k]) return false;
    const bool same = run.modal.datum == run.reference_datum;
    for (std::size_t k = 0; k < o.given.size() && same; ++k)
        if (holds(run, run.modal.datum, k) && !o.given[k]) return false;
    for (std::size_t k = 0; k < 3 && !same; ++k) {
        if (k == 1 && run.env.machine.kind != shop::MachineKind::mill) continue;  // lathes are set in X and Z
        if (!holds(run, run.modal.datum, k) || !o.given[k]) return false;
    }
    return true;
}

}  // namespace

bool is_datum_given(const Reckoning& run, std::uint32_t datum, std::size_t axis) { return holds(run, datum, axis); }

bool is_datum_given(const Reckoning& run, std::size_t axis) { return holds(run, run.reference_datum, axis); }

bool is_datum_given(const Reckoning& run) {
    bool given = false;
    for (std::size_t k = 0; k < 3; ++k) given = given || is_datum_given(run, k);
    return given;
}

namespace {

/// What the job says of zero offsets stands in their parameters, where nothing else says what these hold: programs read
/// them there, and change single axes.
void take_job_datums(Reckoning& run) {
    for (const auto& [number, origin] : run.env.machine.datums) {
        const auto first = first_of_datum(run, number);
        for (std::uint32_t k = 0; first && k < 3; ++k)
            if (const double v = coordinate(origin, static_cast<int>(k));
                !std::isnan(v) && !run.parameters.is_set(*first + k))
                run.parameters.set_by_control(*first + k, v / stored_unit(run, k));
    }
}

}  // namespace

namespace {

/// As say_unknown_way says: a zero whose way from the one before is not known is that one.
void take_as_reference(Telling& run) {
    Offsets& o = run.offsets;
    if (!run.moved || run.datum_known || run.modal.datum == run.reference_datum) return;
    for (std::size_t k = 0; k < 3; ++k)
        if (!holds(run, run.modal.datum, k) || !o.given[k]) o.datum[k] = o.reference[k];
}

}  // namespace

void load_datum(Telling& run) {
    const program::OffsetParameters& p = run.traits->offsets;
    const std::uint32_t place = place_of_datum(run.modal.datum) - 1;
    const auto held = first_of_datum(run, run.modal.datum);
    const bool kept = held.has_value();
    const std::uint32_t first = held.value_or(0);
    Offsets& o = run.offsets;
    bool known = run.env.stored != nullptr || run.env.tell_settings;
    for (std::uint32_t k = 0; k < p.datum_step && kept; ++k) known = known || run.parameters.is_set(first + k);
    const auto job = run.env.machine.datums.find(run.modal.datum);
    if (kept && (known || job == run.env.machine.datums.end())) {
        for (std::size_t k = 0; k < 9; ++k)
            o.datum[k] = stored(run, first + static_cast<std::uint32_t>(k), k) + external(run, k);
        o.rotation = p.rotation == 0 ? 0 : run.parameters.get(first + p.rotation);
        run.datum_known = is_place_known(run);
        take_as_reference(run);
        if (p.active_datum != 0) run.parameters.set(p.active_datum, place + 1);
        return;
    }
    o.datum = {};
    o.rotation = 0;
    run.datum_known = is_place_known(run);
    if (job == run.env.machine.datums.end()) return take_as_reference(run);
    for (int k = 0; k < 3; ++k)
        if (const double v = coordinate(job->second, k); !std::isnan(v))
            o.datum[static_cast<std::size_t>(k)] = v + external(run, static_cast<std::size_t>(k));
    if (const auto turned = run.env.machine.datum_rotations.find(run.modal.datum);
        turned != run.env.machine.datum_rotations.end())
        o.rotation = geom::degrees(turned->second);
}

bool holds_active_datum(const Reckoning& run, std::uint32_t n) {
    const std::uint32_t external_first = run.traits->offsets.external_first;
    if (external_first != 0 && n >= external_first && n < external_first + 9) return true;
    const auto first = first_of_datum(run, run.modal.datum);
    return first && n >= *first && n < *first + 9;
}

void datum_changed(Telling& run) {
    flush_path(run);
    load_datum(run);
    tell(run, SettingKind::datum, static_cast<int>(place_of_datum(run.modal.datum)), run.offsets.datum);
    update_frame(run);
}

void begin_offsets(Telling& run) {
    const program::OffsetParameters& p = run.traits->offsets;
    take_job_datums(run);
    if (p.shift_active != 0 && run.parameters.get(p.shift_active) != 0) take_shift(run);
    if (const double n = p.active_datum == 0 ? 0 : run.parameters.get(p.active_datum); n >= 1 && n <= p.datum_count)
        run.modal.datum = base::clipped<std::uint32_t>(n <= 6 ? 53 + n : 584 + n, 54, 99'999);
    run.reference_datum = run.modal.datum;
    load_datum(run);
    run.offsets.reference = run.offsets.datum;
    if (run.env.start) {
        for (int k = 0; k < 3; ++k)
            coordinate(run.position, k) =
                coordinate(*run.env.start, k) - run.offsets.reference[static_cast<std::size_t>(k)];
        for (std::size_t k = 3; k < 9; ++k) run.extra_axes[axis_name(k)] = 0;
    }
    update_frame(run);
}

geom::Frame datum_frame(const Reckoning& run) {
    const Offsets& o = run.offsets;
    const Axes tip = tip_in_use(o);
    const geom::Frame f = geom::Frame::shift({o.datum[0] - o.reference[0] + o.tool[0] - tip[0],
                                              o.datum[1] - o.reference[1] + o.tool[1] - tip[1],
                                              o.datum[2] - o.reference[2] + o.tool[2] - tip[2]});
    return o.rotation == 0 ? f : f * geom::Frame::rotation(2, geom::radians(o.rotation));
}

geom::Frame offset_frame(Telling& run) {
    Offsets& o = run.offsets;
    if (!run.moved) {  // nothing is in the stream yet: it is counted from here
        for (int k = 0; k < 3; ++k)
            coordinate(run.position, k) +=
                o.reference[static_cast<std::size_t>(k)] - o.datum[static_cast<std::size_t>(k)];
        for (std::size_t k = 3; k < 9; ++k) count_from(run, k, o.datum[k]);
        o.reference = o.datum;
        run.reference_datum = run.modal.datum;
        note_given(run);
        run.datum_known = true;
        // The job's bodies stand where its own zero is, whatever the program writes there before it moves.
        if (const auto job = run.env.machine.datums.find(run.modal.datum); job != run.env.machine.datums.end())
            for (int k = 0; k < 3; ++k)
                if (const double v = coordinate(job->second, k); !std::isnan(v) && !run.env.tell_settings)
                    o.reference[static_cast<std::size_t>(k)] = v;
    }
    for (std::size_t k = 0; k < 9; ++k) o.total[k] = o.datum[k] + o.shift[k] + o.tool[k] - o.reference[k];
    return datum_frame(run) * geom::Frame::shift({o.shift[0], o.shift[1], o.shift[2]});
}

/// The word of the axis is an increment: by its letter (U and W of lathes) or in G91.
bool adds(const Moving& run, std::size_t k) {
    return run.block.ref(axis_code(static_cast<int>(k))) ==
               1 + static_cast<std::uint8_t>(program::Reference::incremental) ||
           (run.traits->position_adds_in_increments && !run.modal.absolute);
}

void shift_words(Moving& run, Modal m) {
    flush_path(run);
    Offsets& o = run.offsets;
    const program::OffsetParameters& p = run.traits->offsets;
    if (m == Modal::position_becomes) say_unknown_places(run);
    for (std::size_t k = 0; k < 9; ++k) {
        const auto v = axis_word(run, k);
        if (v && m == Modal::position_becomes) becomes(run, k, adds(run, k) ? axis_coordinate(run, k) + *v : *v);
        if (v && m == Modal::position_becomes && k == 2) zero_set_here(run);
        if (v && m == Modal::local_shift) o.shift[k] = *v;
    }
    if (m != Modal::position_becomes) say_unknown_return(run);
    say_shift_from_before(run, m);
    if (m == Modal::position_becomes || m == Modal::local_shift) keep_shift(run);
    if (m == Modal::position_reset || m == Modal::position_suspend) o.shift = {};
    if (m == Modal::position_reset) keep_shift(run);
    if (m == Modal::position_restore) take_shift(run);
    if (p.shift_active != 0) {
        if (m == Modal::position_reset || m == Modal::position_suspend) run.parameters.set(p.shift_active, 0);
        if (m == Modal::position_restore) run.parameters.set(p.shift_active, 1);
    }
    tell(run, SettingKind::shift, 0, o.shift);
    update_frame(run);
}

void set_tool_offset(Telling& run, const Axes& to) {
    while_standing(run, [&] { run.offsets.tool = to; });
    tell(run, SettingKind::tool_offset, 0, run.offsets.tool);
}

namespace {

/// Whose compensation is in force from here on.
void take_length(Moving& run, Modal m) {
    using Length = Offsets::Length;
    Offsets& o = run.offsets;
    const BlockWords& b = run.block;
    const bool kept = run.traits->offset_numbers_stay && !std::isnan(o.number);
    const bool numbered = b.has(Code::offset_h) || (kept && m != Modal::tool_length_off);
    judge_anew(o);
    o.subtracts = m == Modal::tool_length_negative;
    const double offset = b.has(Code::offset_h) ? b.get(Code::offset_h) : o.number;
    o.length_tool = numbered ? base::cut<std::uint32_t>(offset).value_or(no_listed_tool) : run.tool.number;
    const bool ends = m == Modal::tool_length_off || (numbered && o.length_tool == 0);
    const bool of_tool = m == Modal::tool_length;
    o.length = ends ? Length::none : of_tool ? Length::of_tool : Length::by_values;
    o.compensates = o.compensates || !ends;
}

}  // namespace

/// Of what take_length has taken; `by`: the values where no number says them.
void tell_length(Telling& run, const Axes& by) {
    const Offsets& o = run.offsets;
    cl::ToolLength length;
    if (o.length != Offsets::Length::none) {
        length.sense = o.subtracts ? -1 : 1;
        if (o.length == Offsets::Length::of_tool || o.subtracts)
            length.offset = o.length_tool;
        else
            length.by = geom::Vec3{by[0], by[1], by[2]};
    }
    if (length == run.told.length) return;
    run.told.length = length;
    emit(run, length);
}

namespace {

/// A length that nobody has given is compensated all the same.
void tell_length_word(Moving& run, Modal m) {
    if (m != Modal::tool_length && m != Modal::tool_length_negative) return;
    const BlockWords& b = run.block;
    const double h = b.has(Code::offset_h) ? b.peek(Code::offset_h) : run.tool.number;
    const cl::ToolLength length{static_cast<std::int8_t>(m == Modal::tool_length ? 1 : -1),
                                base::cut<std::uint32_t>(h).value_or(no_listed_tool),
                                {}};
    if (length == run.told.length) return;
    run.told.length = length;
    emit(run, length);
}

}  // namespace

void tool_length_words(Moving& run, Modal m) {
    std::optional<Axes> by;
    if (m == Modal::tool_length_off) by = Axes{};
    const bool adds_axes = m == Modal::tool_length_added && run.block.special == Modal::tool_length_by_axes;
    if (adds_axes)
        by = Axes{};
    else if (m == Modal::tool_length || m == Modal::tool_length_negative || m == Modal::tool_length_added)
        by = length_of_block(run);
    if (run.stopped) return;
    if (m == Modal::tool_length_by_axes || adds_axes) {
        if (!adds_axes) by = run.offsets.tool;
        for (std::size_t k = 0; k < 9; ++k)
            if (const auto v = axis_word(run, k)) (*by)[k] = *v;
    }
    if (by) {
        if (m == Modal::tool_length_negative)
            for (double& v : *by) v = -v;
        if (m == Modal::tool_length_added)
            for (std::size_t k = 0; k < 9; ++k) (*by)[k] += run.offsets.tool[k];
        take_length(run, m);
        tell_length(run, *by);
        set_tool_offset(run, *by);
        take_tip(run);
    } else {
        tell_length_word(run, m);
        tell(run, SettingKind::tool_offset, 0, run.offsets.tool);
    }
}

std::optional<double> axis_word(const Moving& run, std::size_t axis) {
    const Code code = axis_code(static_cast<int>(axis));
    if (!run.block.has(code)) return std::nullopt;
    const double v = run.block.get(code);
    if (is_rotary(axis)) return v;
    return v * (axis < 3 ? length_factor(run, static_cast<int>(axis), false) : length_unit(run.modal));
}

double axis_coordinate(const Reckoning& run, std::size_t axis) {
    if (axis < 3) return coordinate(run.programmed_position, static_cast<int>(axis));
    const auto found = run.extra_axes.find(axis_name(axis));
    return found == run.extra_axes.end() ? unknown_number : found->second - run.offsets.total[axis];
}

double machine_coordinate(const Reckoning& run, std::size_t axis) {
    const Offsets& o = run.offsets;
    if (axis < 3) return coordinate(run.position, static_cast<int>(axis)) + o.reference[axis] + tip_in_use(o)[axis];
    const double at = axis_coordinate(run, axis);
    return at + o.total[axis] + o.reference[axis];
}

}  // namespace obrys::interp
