#pragma once
/// A run as LinuxCNC's canonical calls, as rs274 -g prints them.

#include <functional>
#include <string_view>

#include "driver/session.hpp"

namespace obrys::driver {

/// Interprets a session and listens; opened with Request::stand_alone the calls are those of rs274. `write` gets the
/// calls line by line, `also` every record. `configured`: by a configuration of its own, where the interpreter ends
/// otherwise.
interp::Outcome print_canon(Session& session, const std::function<void(std::string_view)>& write, bool configured,
                            cl::Sink also);

}  // namespace obrys::driver
