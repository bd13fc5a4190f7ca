#pragma once
/// Matching of IF … ENDIF, WHILE … ENDWHILE and the like while they are read.

#include "read/sinumerik/state.hpp"

namespace obrys::read::sinumerik {

/// Opens if_, while_, repeat_ or loop_ with its condition (no_expr where it has none).
void open_branch(State& s, program::StatementKind kind, program::ExprId condition, const char* from);
void open_for(State& s, program::For loop, const char* from);
/// Opens a structure whose head could not be read: its body is not run.
void open_broken(State& s, program::StatementKind kind, const char* from);
[[nodiscard]] program::ExprId add_boolean(State& s, bool value, const char* from);
void read_else(State& s, const char* from);
/// Closes with endif, endwhile, until, endloop or endfor.
void close_structure(State& s, program::StatementKind kind, program::ExprId condition, const char* from);
/// At the unit's end: complains about what is still open and closes it, so that the rest can be run.
void close_all(State& s);

}  // namespace obrys::read::sinumerik
