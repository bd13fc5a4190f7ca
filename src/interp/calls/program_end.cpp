/// M0 … M2, M30, M99: what a block does behind its motion.

#include "base/codes.hpp"
#include "interp/calls/calls.hpp"

namespace obrys::interp {

namespace codes = base::codes;

namespace {

cl::Stop end_by(const Saying& run, int m) {
    return {cl::StopKind::end, m == run.traits->pallet_end, m == run.traits->end_that_stays};
}

/// M2 and M30 return from a called program, or end the run where the control says so.
void end_of_program(Calling& run, int m) {
    const bool called = run.calls.size() > 1;
    const std::string word = "M" + std::to_string(m);
    say_blocks_behind(run, word);
    if (!called || run.unit().traits->may_end_anywhere) say_callers_rest(run, word);
    if (called && run.unit().traits->may_end_anywhere) {
        hear_end(run, m);
        emit(run, end_by(run, m));
        run.stopped = true;
        return;
    }
    if (called && run.unit().traits->end_stops_all) {
        alarm(run, codes::program_alarm, run.here(),
              "the called program " + run.unit().name + " ends the whole run here with M" + std::to_string(m) +
                  (run.last_message.empty() ? "" : ": " + run.last_message));
        return;
    }
    if (!called) hear_end(run, m);
    // What was cancelled behind the last move is not to hold for the next program.
    if (!called && !run.told.parts.empty()) emit_frame(run);
    if (!called) emit(run, end_by(run, m));
    leave(run);
}

}  // namespace

void after_motion(Calling& run) {
    if (!run.block.behind.empty()) modes_behind_motion(run);
    if (run.block.stops_run) {
        run.spindle.doubtful = true;
        emit(run, cl::Stop{cl::StopKind::program});
    }
    if (run.block.m.empty()) return;
    std::vector<int> functions = run.block.m;
    // The end comes last, wherever it stands in the block.
    std::stable_partition(functions.begin(), functions.end(), [](int m) { return m != 2 && m != 30 && m != 17; });
    for (const int m : functions) {
        if (run.stopped) return;
        stop_function(run, m, false);
        if (m != 0 && m == run.traits->pallet_stop) {
            emit(run, cl::Stop{cl::StopKind::program, true});
        } else if (m == 0 || m == 1) {
            emit(run, cl::Stop{m == 0 ? cl::StopKind::program : cl::StopKind::optional});
        } else if (m == 2 || m == 30 || m == 17) {
            flush_path(run);
            end_of_program(run, m);
            return;
        }
    }
}

}  // namespace obrys::interp
