#pragma once
/// Blocks and statements in their order: where a run comes together. Private to interp.

#include "interp/cycles/cycles.hpp"

namespace obrys::interp {

// --- begin.cpp
/// What machine, job and program say before the first block (begin.cpp).
void begin(Calling&, const Unit& main);

// --- interp.cpp
void step(RunState&);  ///< the next statement of the program

// --- flow.cpp
void run_statement(Cycling&, const program::Statement&, std::uint32_t index);

// --- block.cpp
/// True where it moved and has come to its end.
bool run_block(Cycling&, const program::Statement&, std::uint32_t index);

// --- motion.cpp
[[nodiscard]] bool motion(Cycling&);  ///< true where the block moved
/// The way to where the words of the block lead, straight or by an arc, and nothing else that they may mean.
[[nodiscard]] bool path_motion(Moving&);

// --- special.cpp
/// A block with data of its own (special.cpp).
void run_special(Cycling&, const program::Statement&, std::uint32_t index);

// --- read_again.cpp
/// The statement was read in another state than the run's, and has been run as it is read in this one; else what it
/// sets is in force.
[[nodiscard]] bool runs_read_again(RunState&, std::uint32_t index);

}  // namespace obrys::interp
