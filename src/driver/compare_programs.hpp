#pragma once
/// Two programs, jobs or CL streams, run and held against each other.

#include "cl/recording.hpp"
#include "compare/compare.hpp"
#include "driver/session.hpp"

namespace obrys::driver {

/// Runs a session's program and keeps its stream.
[[nodiscard]] cl::Recording recording_of(Session& session);

/// Runs the program or the stream of a session once more, in a session of its own; false where it cannot be opened.
[[nodiscard]] bool run_anew(const Session& session, const Request& request, cl::Sink sink);

/// Runs both step by step, so that memory does not grow with their moves. Sessions of programs or of streams, opened.
[[nodiscard]] compare::Result compare_sessions(Session& a, Session& b, compare::Tolerance tolerance);
/// The same of a stream that was kept and a session that is run.
[[nodiscard]] compare::Result compare_with(const cl::Recording& a, Session& b, const compare::Tolerance& tolerance);

/// Of a place of A at which nobody knows whether both do the same.
void warn_of(Session& a, const compare::Difference& where, std::string text, std::string remedy);
/// That one says which position the rotary axes take for a plane, and the other leaves it to its control; to A.
void complain_of_turns(Session& a, const compare::Result& result);

/// Whether the control joins moves as far as speed needs until a program says otherwise.
[[nodiscard]] bool joins_freely(std::string_view control);

/// Blocks of the session's programs that stop at their end alone (G9): the stream has no such stop, so that nobody
/// compares them.
[[nodiscard]] std::size_t block_stops(const Session& session);

}  // namespace obrys::driver
