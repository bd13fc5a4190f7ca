#pragma once
/// Findings with one cause are one thing to mend: the passes of a loop over one line, the moves of one holder that is
/// too short. Every report shows groups; what each move did stands behind them.

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "check/result.hpp"

namespace obrys::check {

/// Findings of one cause. Never empty.
struct Group {
    std::vector<std::size_t> members;         ///< indices of Result::findings, increasing
    std::size_t worst = 0;                    ///< index of the one with the largest amount: it speaks for the group
    std::uint64_t times = 0;                  ///< members and those that are only counted
    bool known = false;                       ///< the baseline has it already
    std::optional<std::uint64_t> first_move;  ///< number of the first move among them
};

/// The groups in the order of their first members.
[[nodiscard]] std::vector<Group> groups_of(const Result& result);

/// Whether anything is found that the baseline does not know.
[[nodiscard]] bool finds_new(const Result& result);

/// Findings with equal keys belong together: code and Finding::cause, or code, source text and call sites.
[[nodiscard]] std::string cause_key(const Finding& f);

/// Where the findings of a group come up: their one line, or all lines of their cause. None where that is not known.
[[nodiscard]] std::vector<Site> sites_of(const Result& result, const Group& group);

/// Places that belong to a group: those of its worst, or, of what is no move, those of all.
[[nodiscard]] std::vector<base::Related> related_of(const Result& result, const Group& group);

/// The amount that says how bad a finding is: depth, height, excess; null where it has none.
[[nodiscard]] const Amount* chief_amount(const Finding& f);
/// Whether `a` is worse than `b` of the same cause.
[[nodiscard]] bool is_worse(const Finding& a, const Finding& b);

}  // namespace obrys::check
