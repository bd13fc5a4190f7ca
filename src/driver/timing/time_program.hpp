#pragma once
/// Programs timed on a machine, and on others like it, in one run.

#include <span>
#include <vector>

#include "driver/session.hpp"
#include "sim/time/timer.hpp"

namespace obrys::driver {

/// The session's machine under its program's control.
[[nodiscard]] sim::time::Dynamics dynamics_of(const Session& session);

/// A machine to time on, and what is to be kept of it.
struct Timing {
    sim::time::Dynamics dynamics;
    sim::time::TimerOptions options;
};
struct Timed {
    sim::time::Times times;
    sim::time::SpeedCurve curve;
    std::vector<sim::time::ToleranceUse> tolerances;
};
/// Runs the session's program; one result a machine. How the run went: exit_code_of_run.
[[nodiscard]] std::vector<Timed> time_program(Session& session, std::span<const Timing> timings);

/// Why what was timed is not all of the program, by the run's exit code; empty: it is.
[[nodiscard]] std::string not_whole(int code);

}  // namespace obrys::driver
