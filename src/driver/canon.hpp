#pragma once
/// A run as LinuxCNC's canonical calls, as rs274 -g prints them.

#include <string>

#include "driver/session.hpp"

namespace obrys::driver {

/// Interprets a session that was opened for it (Request::canon); `also` gets every record, too.
[[nodiscard]] std::string canon_of(Session& session, cl::Sink also);

}  // namespace obrys::driver
