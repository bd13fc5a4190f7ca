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
        send_plain(run, run.record);
}

void flush_path(Run& run) {
    if (run.capture == nullptr && run.path->active()) run.path->flush(run);
}

cl::Axis axis_record(std::string_view name, double to, bool is_rotary, bool counted) {
    cl::Axis axis;
    for (std::size_t i = 0; i < name.size() && i + 1 < axis.name.size(); ++i) axis.name[i] = name[i];
    axis.to = to;
    axis.rotary = is_rotary;
    axis.counted = counted;
    return axis;
}

geom::Vec3 stream_origin(const Run& run) {
    constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
    geom::Vec3 origin{unknown, unknown, unknown};
    const auto& known = run.env.machine.datums;
    if (const auto found = known.find(run.reference_datum); found != known.end())
        origin = found->second;
    else if (run.reference_datum == program::no_datum && run.traits->datum.none_is_machine_zero && !known.empty())
        origin = {};  // the machine's own zero
    if (run.env.machine.datum_rotations.contains(run.reference_datum)) origin.x = origin.y = unknown;
    return origin;
}

void emit_datum(Run& run) {
    if (run.datum_emitted) return;
    run.datum_emitted = true;
    emit(run, cl::Datum{run.reference_datum, stream_origin(run)});
}

}  // namespace obrys::interp
