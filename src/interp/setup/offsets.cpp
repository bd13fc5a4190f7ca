/// Zero offsets, shifts and tool lengths as controls keep them that hold them in numbered parameters (Traits::offsets).
/// machine = zero offset + rotation(programmed + shift) + tool offset (LinuxCNC, Coordinate System; Fanuc, Coordinate
/// system functions). The stream's coordinates are those of the tool's tip, counted from the zero offset that is active
/// when the first move is made; what a length compensation that is not that of the tool does to the tip is seen there.

#include <cmath>

#include "base/codes.hpp"
#include "base/number.hpp"
#include "interp/setup/setup.hpp"

namespace obrys::interp {

namespace codes = base::codes;

namespace {

void keep_shift(Reckoning& run) {
    const program::OffsetParameters& p = run.traits->offsets;
    if (p.shift_first == 0) return;
    for (std::size_t k = 0; k < 9; ++k)
        run.parameters.set(p.shift_first + static_cast<std::uint32_t>(k), run.offsets.shift[k] / stored_unit(run, k));
    run.parameters.set(p.shift_active, 1);
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
    const bool said = run.offsets.shift_said || holds_all(run);
    bool kept = true;
    for (std::uint32_t k = 0; k < 3; ++k) kept = kept && run.parameters.is_set(first + k);
    run.offsets.shift_said = true;
    if (m == Modal::position_restore && !kept && !holds_all(run))
        return unchecked(run, codes::unknown_value, run.here(),
                         "the shift that is brought back is from before the program and is not known: taken as none",
                         "give the parameter file of the control with --var, or [variables] of the job");
    if (!said && run.moved)
        assume(run, run.here(), "no shift is taken to have been in force when the program began",
               "cancel it before the first move");
}

/// G92: where the axis stands is `to` from now on. A machine whose place is not known stands there by definition.
void becomes(Reckoning& run, std::size_t k, double to) {
    if (k < run.unsaid_since_change.size()) run.unsaid_since_change[k] = false;
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

}  // namespace

/// G92.1 X0: the axis counts from its zero again.
void preset(Reckoning& run, std::size_t k, double value) {
    run.offsets.shift[k] = 0;
    if (value == 0) return;
    unchecked(run, codes::value_range, run.here(),
              "the words beside this one name the axes that count from their zero again, and stand with 0: what " +
                  axis_name(k) + base::shortest(value) + " does is not known; it is taken as 0",
              "write " + axis_name(k) + "0");
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
        if (v && m == Modal::position_reset && run.block.special == m) preset(run, k, *v);
    }
    if (m != Modal::position_becomes) say_unknown_return(run);
    say_shift_from_before(run, m);
    if (m == Modal::position_becomes || m == Modal::local_shift) keep_shift(run);
    if (m == Modal::position_suspend || (m == Modal::position_reset && run.block.special != m)) o.shift = {};
    if (m == Modal::position_reset) keep_shift(run);
    if (m == Modal::position_restore) take_shift(run);
    if (p.shift_active != 0) {
        if (m == Modal::position_reset || m == Modal::position_suspend) run.parameters.set(p.shift_active, 0);
        if (m == Modal::position_restore) run.parameters.set(p.shift_active, 1);
    }
    hear(run, heard::Shift{o.shift});
    update_frame(run);
}

void set_tool_offset(Telling& run, const Axes& to) {
    while_standing(run, [&] { run.offsets.tool = to; });
    hear(run, heard::ToolOffset{run.offsets.tool});
}

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

std::optional<double> axis_word(const Moving& run, std::size_t axis) {
    const Code code = axis_code(static_cast<int>(axis));
    if (!run.block.has(code)) return std::nullopt;
    const double v = run.block.get(code);
    if (is_rotary(axis)) return v;
    return v * (axis < 3 ? length_factor(run, static_cast<int>(axis), false) : length_unit(run.modal));
}

}  // namespace obrys::interp
