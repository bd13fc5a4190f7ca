#pragma once
/// Contours that a job does not write as points: run from a program, or derived from the part.

#include "check/result.hpp"
#include "check/setup.hpp"
#include "driver/session.hpp"

namespace obrys::driver {

/// Fills part and allowance of the session. A path in the job is relative to the job file.
void resolve_contours(Session& session, const fs::path& job_path);

/// The job's clamps as bodies of revolution; complains about those that are none.
[[nodiscard]] std::vector<check::TurnedClamp> turned_clamps(Session& session);

}  // namespace obrys::driver
