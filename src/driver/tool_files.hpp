#pragma once
/// The tools of a job: its own, those of the files that it or the call names.

#include "driver/session.hpp"

namespace obrys::driver {

/// `base_path`: of the job, whose files lie beside it.
void load_tools(Session& s, const Request& request, const fs::path& base_path);

}  // namespace obrys::driver
