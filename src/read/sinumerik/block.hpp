#pragma once
/// Lines: what stands in front of a block, its words and statements, and the fast way for plain motion blocks.

#include "read/sinumerik/state.hpp"

namespace obrys::read::sinumerik {

/// Reads one line; the cursor covers it.
void read_line(State& s);

/// Reads the line at `p` if it is a plain block: a block number, then letters with literals, then a comment; or a
/// comment alone, which leaves nothing in the tree. Returns the line's end, or nothing where the line needs the full
/// reader. The text must end with a byte that is no letter and no digit.
[[nodiscard]] const char* read_literal_block(State& s, const char* p, const char* end);

/// Takes a label for each block number, so that jumps to N numbers find them.
void label_block_numbers(State& s);

}  // namespace obrys::read::sinumerik
