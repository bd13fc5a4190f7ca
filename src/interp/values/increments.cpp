#include "interp/values/values.hpp"

namespace obrys::interp {

double increments_of_unit(const Reckoning& run) {
    if (!run.traits->counts_increments) return 0;
    const double per_mm = run.env.machine.control.increments_per_mm.value_or(run.traits->increments_per_mm);
    return run.modal.inch_geometry ? 10 * per_mm : per_mm;
}

}  // namespace obrys::interp
