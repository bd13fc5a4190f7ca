/// Records out of the run.

#include <limits>

#include "base/codes.hpp"
#include "interp/path_stage.hpp"

namespace obrys::interp {

void emit(Run& run, cl::Step step) {
    run.record.step = std::move(step);
    run.record.from = run.here();
    run.record.stack = run.top().stack;
    if (run.path->active() && !cl::is_move(run.record.step)) run.path->hold(run.record);
    else run.sink(run.record);
}

void flush_path(Run& run) {
    if (run.path->active()) run.path->flush(run);
}

void emit_datum(Run& run) {
    if (run.emitted_datum == run.modal.datum) return;
    run.emitted_datum = run.modal.datum;
    constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
    cl::Datum d{run.modal.datum, {unknown, unknown, unknown}};
    if (const auto known = run.env.machine.datums.find(run.modal.datum); known != run.env.machine.datums.end()) d.origin = known->second;
    else if (run.modal.datum == 500 && !run.env.machine.datums.empty()) d.origin = {};  // the machine's own zero
    emit(run, d);
}

}  // namespace obrys::interp
