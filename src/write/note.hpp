#pragma once
/// What becomes of what the stream says, in the text.

#include <string>

#include "cl/record.hpp"

namespace obrys::write {

enum class Fate : std::uint8_t {
    mapped,    ///< the control has it and is told so
    expanded,  ///< it is there by its moves, or by other words
    lost       ///< it is not there
};

/// A cycle, a special function or a call of the program, and what became of it.
struct Note {
    Fate fate = Fate::lost;
    std::string what;
    base::Span from;
    cl::StackId stack = 0;
    std::uint64_t line = 0;  ///< of the text, counted from 1: the one that says it, or follows
    std::string file{};      ///< that holds the line; empty: that of the program
};

}  // namespace obrys::write
