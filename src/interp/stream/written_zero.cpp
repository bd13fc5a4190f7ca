/// A parameter was written that zeros are kept in.

#include "base/codes.hpp"
#include "interp/stream/stream.hpp"

namespace obrys::interp {

namespace codes = base::codes;

namespace {

void tell_written_zero(Telling& run, std::uint32_t n) {
    const auto zero = zero_of(run.traits->offsets, n);
    if (!zero || zero->axis > 2) return;
    cl::DatumData data;
    data.number = zero->number;
    coordinate(data.origin, static_cast<int>(zero->axis)) = run.parameters.get(n) * stored_unit(run, zero->axis);
    emit(run, data);
}

}  // namespace

void note_written(Telling& run, std::uint32_t n, const base::Span& where) {
    const program::KeptParameters* k = run.traits->kept.empty() ? nullptr : range_of(run, n);
    if (k == nullptr) return;
    const bool in_force = holds_active_datum(run, n);
    if (in_force) flush_path(run);
    tell_written_zero(run, n);
    if (in_force) return datum_changed(run);
    if (!k->acts) return;
    unchecked(run, codes::unknown_value, where,
              "the effect of writing " + program::parameter_name(*run.traits, n) + " is not known");
}

}  // namespace obrys::interp
