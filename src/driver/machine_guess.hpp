#pragma once
/// What kind of machine a program alone is for, where neither the call nor the job names one, and whether X words may
/// be taken by it: a lathe's X words are diameters, a mill's are not.

#include <string>

#include "base/source.hpp"
#include "program/unit.hpp"

namespace obrys::driver {

struct MachineGuess {
    bool turning = false;
    std::string signs;    ///< the words that speak for it: "G18, LIMS="; empty: none does
    std::string against;  ///< the words that speak for the other kind; empty: none does
    /// The first X word whose meaning follows from the guess alone: nothing proves the kind, and no DIAMON or DIAMOF
    /// stands before it. length 0: there is none.
    base::Span doubtful{};
};

[[nodiscard]] MachineGuess guess_machine(const program::Unit& unit);

}  // namespace obrys::driver
