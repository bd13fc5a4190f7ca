#pragma once
/// [set] and --set, held to the programs of the run.

#include "driver/session.hpp"

namespace obrys::driver {

/// After the run: a parameter that no program uses is an error (exit code 2), one of which no constant was replaced is
/// said.
void check_overrides(Session& session, const interp::Outcome& outcome);

}  // namespace obrys::driver
