#pragma once
/// The straight path: `12 L X+1.5 Y-2 Z+0 F800 M8` and nothing else. Most blocks of long programs are of this kind.

#include "read/heidenhain/state.hpp"

namespace obrys::read::heidenhain {

/// Reads the block where it is of this kind and leaves the scanner at its line's end; else nothing happens.
bool read_literal_block(State& s);

}  // namespace obrys::read::heidenhain
