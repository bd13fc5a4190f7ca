/// Datums selected.

#include "interp/setup/setup.hpp"

namespace obrys::interp {

namespace {

/// A zero offset that is kept in parameters.
void select_kept_datum(Telling& run, std::uint32_t number) {
    if (run.modal.datum == number) return hear(run, heard::SameZero{});
    flush_path(run);
    run.modal.datum = number;
    run.offsets.length_judged = false;
    load_datum(run);
    take_tip(run);
    hear(run, zero_in_force(run));
    update_frame(run);
}

}  // namespace

void set_datum(Telling& run, std::uint32_t number) {
    if (run.modal.datum != number) run.datum_complained = false;
    if (!run.modal.datum_said) run.told.current = false;
    run.modal.datum_said = true;
    if (keeps_offsets(run)) return select_kept_datum(run, number);
    if (run.modal.datum == number) return;
    flush_path(run);
    run.modal.datum = number;
    if (!run.moved && run.reference_datum == 500) run.reference_datum = number;
    update_frame(run);
}

}  // namespace obrys::interp
