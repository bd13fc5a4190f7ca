#pragma once
/// Jumps that make loops and branches, for a control that has no jumps. Private to rewrite.

#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <vector>

#include "base/source.hpp"
#include "program/names.hpp"
#include "program/unit.hpp"
#include "rewrite/held.hpp"

namespace obrys::rewrite {

/// What a jump is.
enum class JumpRole : std::uint8_t {
    none,      ///< to the next statement
    branch,    ///< passes by what follows: IF its condition does not hold
    other,     ///< the end of a branch with an ELSE
    again,     ///< the end of a loop that goes on while its condition holds
    end_loop,  ///< the end of a loop without one
    leave,     ///< out of the innermost loop
    repeat,    ///< the end of a part that is done some more times (CALL LBL REP)
    tail,      ///< to a few statements with which the program ends: they are done where it stands
};

struct Structured {
    struct Region {
        std::uint32_t begin = 0, end = 0;      ///< statements; `end` is behind the last
        bool loop = false, endless = false;    ///< else a branch
        std::uint32_t jump = 0;                ///< that makes it
        std::optional<std::uint32_t> other{};  ///< the jump that is its ELSE
        bool counted = false;                  ///< a loop that ends behind so many passes
        bool own = false;                      ///< of the program, which says its begin and end itself
    };
    struct Jump {
        JumpRole role = JumpRole::none;
        std::size_t region = 0;
    };
    std::vector<Region> regions;
    std::map<std::uint32_t, Jump> jumps;                    ///< by their statements
    std::map<std::uint32_t, std::uint32_t> tails;           ///< their first and last statements
    std::map<std::uint32_t, std::uint32_t> tails_of_jumps;  ///< first statements, by the jumps
    std::set<std::uint32_t> only_jumped_to;                 ///< statements of tails to which nothing else leads
};

/// Nothing where the program's jumps make no loops and branches that lie within each other, or are computed.
[[nodiscard]] std::optional<Structured> structured(const program::Unit& unit, const std::vector<Held>& held,
                                                   const program::Names& names, const base::Sources& sources);

/// The jump's condition always holds.
[[nodiscard]] bool is_always(const program::Unit& unit, const program::Jump& jump);

}  // namespace obrys::rewrite
