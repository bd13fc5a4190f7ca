#pragma once
/// Two programs, jobs or CL streams, run and held against each other.

#include "compare/compare.hpp"
#include "driver/session.hpp"

namespace obrys::driver {

/// What a session's program makes the machine do.
[[nodiscard]] compare::Path path_of(Session& session, double same_place);

/// Whether the file is a CL stream in its text form.
[[nodiscard]] bool is_stream(const std::string& file);
/// Loads one in the place of a program; false, with what is wrong in the session's diagnostics, where it cannot be
/// read.
bool open_stream(const std::string& file, Session& session);

/// Runs both step by step, so that memory does not grow with their moves. Sessions of programs or of streams, opened.
[[nodiscard]] compare::Result compare_sessions(Session& a, Session& b, compare::Tolerance tolerance);

}  // namespace obrys::driver
