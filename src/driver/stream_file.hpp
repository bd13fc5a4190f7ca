#pragma once
/// CL streams in their text form, in the place of programs.

#include <optional>
#include <string>

#include "cl/text.hpp"
#include "driver/session.hpp"

namespace obrys::driver {

/// Whether the file is a CL stream in its text form.
[[nodiscard]] bool is_stream(const std::string& file);
/// Loads one in the place of a program, with the machine that the request names; false, with what is wrong in the
/// session's diagnostics, where it cannot be read. Session::main stays null.
bool open_stream(const Request& request, Session& session);
/// The records of a session: of its program, which is run, or of its stream.
interp::Outcome stream_of(Session& session, cl::Sink sink);

}  // namespace obrys::driver
