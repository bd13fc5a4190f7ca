/// Brackets of cycles in the stream: what they say, where they begin and end (docs/cl-stream.md, "Cycles").

#include <algorithm>
#include <array>
#include <cmath>

#include "cycles/names.hpp"
#include "interp/stream/path_stage.hpp"
#include "interp/stream/stream.hpp"

namespace obrys::interp {

namespace {

/// (u, v, w) of the working plane -> frame of the stream.
geom::Frame plane_frame(const Reckoning& run) {
    const PlaneAxes a = plane_axes(run.modal.plane);
    geom::Frame in_program;
    in_program.linear = {};
    const std::array<int, 3> axes{a.u, a.v, a.w};
    for (std::size_t column = 0; column < 3; ++column)
        in_program.linear[3 * static_cast<std::size_t>(axes[column]) + column] = 1;
    return run.frame * in_program;
}

/// The last word on each role, in the order in which they are named first.
CycleValues said_once(const cycles::Demand& demand) {
    CycleValues out;
    for (const cl::CycleValue& v : demand.values)
        if (std::none_of(out.begin(), out.end(), [&](const cl::CycleValue& o) { return o.role == v.role; }))
            out.push_back({v.role, demand.get(v.role)});
    for (cl::CycleValue& v : out)  // feeds may be rapid; beyond all numbers nothing is known
        if (std::isinf(v.value) && v.role != cl::CycleRole::feed_position && v.role != cl::CycleRole::feed_retract)
            v.value = NAN;
    return out;
}

}  // namespace

void begin_bracket(Telling& run, const cycles::Demand& demand, std::string_view name, const WayOfCall& calling,
                   std::vector<cl::CycleParameter> written) {
    emit_frame(run);
    cl::Cycle cycle{demand.kind, plane_frame(run), said_once(demand), std::string(name), std::move(written)};
    if (*run.told.cycle != cycle) run.told.cycle = std::move(cycle);  // the holes of a series share one
    // Behind elements that are held back by compensation it is not known yet where the tool stands.
    const geom::Vec3 place = run.path->holds() ? geom::Vec3{NAN, NAN, NAN} : run.sent;
    ++run.told.open_cycles;
    emit(run, cl::CycleBegin{run.told.cycle, place, calling.call, calling.pass, calling.passes});
}

void end_bracket(Telling& run) {
    if (run.told.open_cycles == 0 || run.capture != nullptr) return;
    --run.told.open_cycles;
    emit(run, cl::CycleEnd{});
}

}  // namespace obrys::interp
