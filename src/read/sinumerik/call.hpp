#pragma once
/// Calls: NAME, NAME(…), L123 P3, MCALL, CALL, PCALL, and the procedures of the control.

#include "dialect/sinumerik/tables.hpp"
#include "read/sinumerik/state.hpp"

namespace obrys::read::sinumerik {

/// A call by name; the name is [from, to), arguments and P= follow.
void read_call(State& s, const char* from, const char* to);
/// A cycle of the control itself, with or without arguments.
void read_control_cycle(State& s, const dialect::sinumerik::Entry& entry, std::size_t length);
void read_mcall(State& s, const char* from);
void read_indirect_call(State& s, const char* from);
/// EXTCALL "path", EXTCALL("path").
void read_external_call(State& s, const char* from);
void read_path_call(State& s, const char* from);
void read_procedure(State& s, program::Procedure procedure, std::size_t length);

}  // namespace obrys::read::sinumerik
