/// Datums selected.

#include "interp/setup/setup.hpp"

namespace obrys::interp {

using cl::SettingKind;

namespace {

/// A zero offset that is kept in parameters.
void select_kept_datum(Telling& run, std::uint32_t number) {
    const int place = static_cast<int>(place_of_datum(number));
    if (run.modal.datum == number) return tell(run, SettingKind::datum_kept, place);
    flush_path(run);
    run.modal.datum = number;
    run.offsets.length_judged = false;
    load_datum(run);
    take_tip(run);
    tell(run, SettingKind::datum, place, run.offsets.datum);
    tell(run, SettingKind::shift, 0, run.offsets.shift);
    tell(run, SettingKind::datum_rotation, 0, {run.offsets.rotation});
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
