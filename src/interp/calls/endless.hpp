#pragma once
/// Loops that cannot end, found in the tree: what their conditions ask for is changed by nothing within them.

#include <optional>
#include <string>

#include "program/names.hpp"
#include "program/unit.hpp"

namespace obrys::interp {

/// Statements that run again and again: the last one goes back to the first.
struct Loop {
    std::uint32_t first = 0, last = 0;
};

struct Endless {
    std::string why;              ///< "nothing in it changes R1"
    std::string remedy;           ///< where to look
    std::uint32_t condition = 0;  ///< the statement that asks whether it goes on
};

/// Nothing where the loop may end: something within it changes what its conditions ask for, or might.
[[nodiscard]] std::optional<Endless> why_endless(const program::Unit& unit, const Loop& loop,
                                                 const program::Names& names);

}  // namespace obrys::interp
