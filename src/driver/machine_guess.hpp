#pragma once
/// What kind of machine a program alone is for, where neither the call nor the job names one, and whether X words may
/// be taken by it: a lathe's X words are diameters, a mill's are not.

#include <string>
#include <vector>

#include "base/source.hpp"
#include "program/unit.hpp"

namespace obrys::driver {

struct MachineGuess {
    bool turning = false;
    std::vector<base::Span> signs;    ///< the program's own words that speak for it
    std::vector<base::Span> against;  ///< those that speak for the other kind
    /// The first X word whose meaning follows from the guess alone: nothing proves the kind, and no DIAMON or DIAMOF
    /// stands before it. length 0: there is none.
    base::Span doubtful{};
};

[[nodiscard]] MachineGuess guess_machine(const program::Unit& unit);
/// "G18 (line 2), LIMS=3000 (line 4)": the first of such words, each as the program writes it, where it stands first.
/// Their text may have been laid aside: this is for what is said.
[[nodiscard]] std::string list_of_signs(const std::vector<base::Span>& places, const base::Sources& sources);

}  // namespace obrys::driver
