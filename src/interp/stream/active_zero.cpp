/// The zero in force: loaded, changed, counted from.

#include <cmath>

#include "base/whole.hpp"
#include "interp/stream/stream.hpp"

namespace obrys::interp {

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

}  // namespace

void take_shift(Reckoning& run) {
    const program::OffsetParameters& p = run.traits->offsets;
    for (std::size_t k = 0; k < 9 && p.shift_first != 0; ++k)
        run.offsets.shift[k] = stored(run, p.shift_first + static_cast<std::uint32_t>(k), k);
}

namespace {

/// The coordinates of an additional axis count from another place of the machine; it stands where it stood.
void count_from(Telling& run, std::size_t k, double datum) {
    const double by = run.offsets.reference[k] - datum;
    const auto at = run.extra_axes.find(axis_name(k));
    if (by == 0 || at == run.extra_axes.end()) return;
    at->second += by;
    take_along(run, axis_end(at->first, at->second, is_rotary(k), false));
}

bool holds_external(const Reckoning& run, std::size_t axis) {
    const std::uint32_t first = run.traits->offsets.external_first;
    return holds_all(run) || (first != 0 && run.parameters.is_set(first + static_cast<std::uint32_t>(axis)));
}

/// What is known before anything has moved.
void note_given(Reckoning& run) {
    Offsets& o = run.offsets;
    for (std::size_t k = 0; k < o.given.size(); ++k) o.given[k] = is_zero_held(run, run.reference_datum, k);
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
        if (is_zero_held(run, run.modal.datum, k) && !o.given[k]) return false;
    for (std::size_t k = 0; k < 3 && !same; ++k) {
        if (k == 1 && run.env.machine.kind != shop::MachineKind::mill) continue;  // lathes are set in X and Z
        if (!is_zero_held(run, run.modal.datum, k) || !o.given[k]) return false;
    }
    return true;
}

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

/// As say_unknown_way says: a zero whose way from the one before is not known is that one.
void take_as_reference(Telling& run) {
    Offsets& o = run.offsets;
    if (!run.moved || run.datum_known || run.modal.datum == run.reference_datum) return;
    for (std::size_t k = 0; k < 3; ++k)
        if (!is_zero_held(run, run.modal.datum, k) || !o.given[k]) o.datum[k] = o.reference[k];
}

}  // namespace

KeptZero kept_zero(const Reckoning& run, std::uint32_t number) {
    const program::OffsetParameters& p = run.traits->offsets;
    const auto held = first_of_datum(run, number);
    const bool kept = held.has_value();
    const std::uint32_t first = held.value_or(0);
    bool known = holds_all(run);
    for (std::uint32_t k = 0; k < p.datum_step && kept; ++k) known = known || run.parameters.is_set(first + k);
    const auto job = run.env.machine.datums.find(number);
    KeptZero zero;
    if (kept && (known || job == run.env.machine.datums.end())) {
        for (std::size_t k = 0; k < 9; ++k)
            zero.at[k] = stored(run, first + static_cast<std::uint32_t>(k), k) + external(run, k);
        zero.turn = p.rotation == 0 ? 0 : run.parameters.get(first + p.rotation);
        zero.from = KeptZero::From::parameters;
        return zero;
    }
    if (job == run.env.machine.datums.end()) return zero;
    zero.from = KeptZero::From::job;
    for (int k = 0; k < 3; ++k)
        if (const double v = coordinate(job->second, k); !std::isnan(v))
            zero.at[static_cast<std::size_t>(k)] = v + external(run, static_cast<std::size_t>(k));
    if (const auto turned = run.env.machine.datum_rotations.find(number);
        turned != run.env.machine.datum_rotations.end())
        zero.turn = geom::degrees(turned->second);
    return zero;
}

void load_datum(Telling& run) {
    const KeptZero zero = kept_zero(run, run.modal.datum);
    run.offsets.datum = zero.at;
    run.offsets.rotation = zero.turn;
    run.datum_known = is_place_known(run);
    if (zero.from != KeptZero::From::job) take_as_reference(run);
    if (const auto shown = run.traits->offsets.active_datum; shown != 0 && zero.from == KeptZero::From::parameters)
        run.parameters.set(shown, place_of_datum(run.modal.datum));
}

void datum_changed(Telling& run) {
    flush_path(run);
    load_datum(run);
    hear(run, heard::Zero{run.modal.datum, run.offsets.datum, {}, {}});
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

geom::Frame offset_frame(Telling& run) {
    Offsets& o = run.offsets;
    if (!run.moved && !run.told.begun) {  // nothing is in the stream yet: it is counted from here
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
                if (const double v = coordinate(job->second, k); !std::isnan(v))
                    o.reference[static_cast<std::size_t>(k)] = v;
    }
    for (std::size_t k = 0; k < 9; ++k) o.total[k] = o.datum[k] + o.shift[k] + o.tool[k] - o.reference[k];
    return datum_frame(run) * geom::Frame::shift({o.shift[0], o.shift[1], o.shift[2]});
}

}  // namespace obrys::interp
