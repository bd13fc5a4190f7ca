#pragma once
/// Words of a block: addresses with and without `=`, modal words, assignments.

#include "dialect/sinumerik/tables.hpp"
#include "read/sinumerik/state.hpp"

namespace obrys::read::sinumerik {

/// An address of one letter, or an axis or address with a number (X1=, S2=). The cursor stands on the letter.
void read_address(State& s);
/// A word of the tables that belongs into a block.
void read_table_word(State& s, const dialect::sinumerik::Entry& entry, std::size_t length);
/// `variable = value`; the cursor stands on the variable.
void read_assignment(State& s);
/// `= value` behind an address whose word begins at `from`.
void read_value(State& s, program::Code code, const char* from);
/// `AX1=value`: a machine axis by the control's own name, of so many bytes.
void read_machine_axis(State& s, std::size_t length);
/// Number of a word that has no meaning of its own here, as an unknown word.
void read_unknown(State& s, std::string_view reason = {});
/// Moves over `[…]`, `(…)` and `=value` behind a word that is not run.
void skip_operand(State& s);
/// Moves to the end of the line's text, its comment left out.
void skip_line(State& s);

}  // namespace obrys::read::sinumerik
