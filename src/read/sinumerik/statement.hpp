#pragma once
/// Statements that begin with a word of their own: control structures, jumps, definitions, frames.

#include "dialect/sinumerik/tables.hpp"
#include "read/sinumerik/state.hpp"

namespace obrys::read::sinumerik {

/// Reads one statement whose first word (`length` bytes) stands at the cursor.
void read_statement(State& s, dialect::sinumerik::Keyword keyword, std::size_t length);
void read_frame(State& s, const dialect::sinumerik::Entry& entry, std::size_t length);

// jump.cpp: the cursor stands behind the first word, which begins at `from`
void read_jump(State& s, dialect::sinumerik::Keyword keyword, program::ExprId condition, const char* from);
/// A GOTO word at the cursor, and its length; nothing where another word stands.
struct JumpWord {
    dialect::sinumerik::Keyword keyword;
    std::size_t length = 0;
};
[[nodiscard]] JumpWord jump_word(State& s);
void read_case(State& s, const char* from);
/// REPEAT label …; false where no label stands behind REPEAT, so that it opens a loop.
bool read_section(State& s, bool one_block, const char* from);

// declaration.cpp
void read_def(State& s, const char* from);
void read_proc(State& s, const char* from);
void read_extern(State& s, const char* from);

// macro.cpp
void read_define(State& s, const char* from);
/// The line with its macros replaced; false where none of them occurs. Complains where they nest without end.
bool expand(State& s, Expanded& out);

}  // namespace obrys::read::sinumerik
