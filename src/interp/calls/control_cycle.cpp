/// Cycles that the control itself has and calls like programs; one of the user with that name counts before them
/// (SINUMERIK search path: the program's folder, subprograms, then the cycles of user, builder and control).

#include <cmath>

#include "base/codes.hpp"
#include "interp/calls/calls.hpp"

namespace obrys::interp {

namespace codes = base::codes;
using program::Call;
using program::ControlCycle;

namespace {

void not_run(Saying& run, const Call& call, const std::string& why) {
    const program::Problem& p = run.unit().problems[call.problem];
    unchecked(run, codes::unsupported, p.where, p.text + " is not run: " + why);
}

/// An argument as a number; 0 where it is left out, nothing where it is none or not known.
std::optional<double> plain(Reckoning& run, const Call& call, std::size_t i) {
    if (i >= call.arguments.size() || call.arguments[i] == program::no_expr) return 0;
    const Value v = evaluate(run, call.arguments[i]);
    if (run.stopped || !v.is_number() || std::isnan(v.number)) return std::nullopt;
    return v.number;
}

/// CYCLE832(tolerance, mode, …): nothing moves. Without arguments and with tolerance 0 it is switched off.
void path_tolerance(Reckoning& run, const Call& call) {
    const auto tolerance = plain(run, call, 0);
    if (run.stopped) return;
    if (!tolerance) return unchecked(run, codes::unknown_value, call.where, "the tolerance of this cycle is not known");
    run.modal.tolerance_by = "CYCLE832";
    run.modal.tolerance_cycle = std::abs(*tolerance) * length_unit(run.modal);
}

/// CYCLE800(_FR,_TC,_ST,_MODE,_X0,_Y0,_Z0,_A,_B,_C,_X1,_Y1,_Z1,_DIR,…) as far as it turns and shifts nothing: it ends
/// the tilted plane and, where it does not add to it (_ST), the programmed frame.
void swivel(Telling& run, const Call& call) {
    constexpr std::size_t retract = 0, status = 2, first = 4, last = 12;
    const std::string_view why = "it tilts the working plane";
    for (std::size_t i = first; i <= last && !run.stopped; ++i)
        if (const auto v = plain(run, call, i); !v || *v != 0) return not_run(run, call, std::string(why));
    const auto away = plain(run, call, retract), kind = plain(run, call, status);
    if (run.stopped) return;
    if (!away || *away != 0) return not_run(run, call, "it retracts the tool first to a position of the machine");
    if (!kind || std::fmod(*kind, 10) != 0) return not_run(run, call, "it adds to the tilted plane in force");
    if (run.modal.programmed == geom::Frame{}) return;
    assume(run, call.where, "this cycle ends the programmed frame too (TRANS, ROT, SCALE, MIRROR)",
           "write the frame behind it");
    run.modal.programmed = {};
    update_frame(run);
}

}  // namespace

void control_cycle(Calling& run, const Call& call) {
    if (call.kind == program::CallKind::modal) run.modal_call = {};
    switch (call.control_cycle) {
        case ControlCycle::path_tolerance: return path_tolerance(run, call);
        case ControlCycle::swivel: return swivel(run, call);
        default: return not_run(run, call, run.unit().problems[call.problem].reason);
    }
}

}  // namespace obrys::interp
