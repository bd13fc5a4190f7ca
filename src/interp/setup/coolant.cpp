/// Coolant.

#include "interp/setup/setup.hpp"

namespace obrys::interp {

using program::ControlValue;

void coolant(Telling& run, int m) {
    run.coolant_on = m != 9;
    run.mist = m == 9 ? false : run.mist || m == 7;
    run.flood = m == 9 ? false : run.flood || m == 8;
    run.modal.mist_said = run.modal.mist_said || m != 8;
    run.modal.flood_said = run.modal.flood_said || m != 7;
    control_sets(run, {ControlValue::coolant_state});
    emit(run, cl::Coolant{run.flood, run.mist});
}

}  // namespace obrys::interp
