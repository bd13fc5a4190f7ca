#pragma once
/// Two programs, jobs or CL streams, run and held against each other.

#include "compare/compare.hpp"
#include "driver/session.hpp"

namespace obrys::driver {

/// What a session's program makes the machine do. A file that begins as the text form of the CL stream is read as that.
[[nodiscard]] compare::Path path_of(Session& session, double same_place);

/// Whether the file is a CL stream in its text form.
[[nodiscard]] bool is_stream(const std::string& file);
/// Reads one; false, with what is wrong in the session's diagnostics, where it cannot be read.
bool read_stream(const std::string& file, Session& session, compare::Path& path);

}  // namespace obrys::driver
