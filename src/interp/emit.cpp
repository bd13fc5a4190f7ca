/// Records out of the run.

#include <limits>

#include "base/codes.hpp"
#include "interp/contour_cycle.hpp"
#include "interp/path_stage.hpp"

namespace obrys::interp {

void emit(Run& run, cl::Step step) {
    if (run.capture != nullptr) return;
    run.record.step = std::move(step);
    run.record.from = run.along != nullptr ? run.along->where : run.here();
    run.record.stack = run.along != nullptr ? run.along->stack : run.top().stack;
    if (run.path->active() && !cl::is_move(run.record.step))
        run.path->hold(run.record);
    else
        run.sink(run.record);
}

void flush_path(Run& run) {
    if (run.capture == nullptr && run.path->active()) run.path->flush(run);
}

void emit_datum(Run& run) {
    if (run.datum_emitted) return;
    run.datum_emitted = true;
    constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
    cl::Datum d{run.reference_datum, {unknown, unknown, unknown}};
    const auto& known = run.env.machine.datums;
    if (const auto found = known.find(run.reference_datum); found != known.end())
        d.origin = found->second;
    else if (run.reference_datum == program::no_datum && run.traits->datum.none_is_machine_zero && !known.empty())
        d.origin = {};  // the machine's own zero
    if (run.env.machine.datum_rotations.contains(run.reference_datum)) d.origin.x = d.origin.y = unknown;
    emit(run, d);
}

}  // namespace obrys::interp
