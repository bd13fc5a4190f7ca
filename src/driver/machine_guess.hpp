#pragma once
/// What kind of machine a program alone is for, where neither the call nor the job names one, and whether X words may
/// be taken by it: a lathe's X words are diameters, a mill's are not.

#include <string>

#include "base/source.hpp"
#include "program/unit.hpp"

namespace obrys::driver {

struct MachineGuess {
    bool turning = false;
    /// The program's own words that speak for it, with their lines: "G18, LIMS=3000 (line 2)"; empty: none does.
    std::string signs;
    std::string against;  ///< those that speak for the other kind; empty: none does
    /// The first X word whose meaning follows from the guess alone: nothing proves the kind, and no DIAMON or DIAMOF
    /// stands before it. length 0: there is none.
    base::Span doubtful{};
};

[[nodiscard]] MachineGuess guess_machine(const program::Unit& unit, const base::Sources& sources);

}  // namespace obrys::driver
