#pragma once
/// Contours that a job does not write as points: run from a program, or derived from the part.

#include "driver/session.hpp"

namespace obrys::driver {

/// Fills part and allowance of the session. A path in the job is relative to the job file.
void resolve_contours(Session& session, const fs::path& job_path);

}  // namespace obrys::driver
