#pragma once
/// Jumps that make loops and branches, for a control that has no jumps. Private to rewrite.

#include <cstdint>
#include <map>
#include <optional>
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
};

struct Structured {
    struct Region {
        std::uint32_t begin = 0, end = 0;      ///< statements; `end` is behind the last
        bool loop = false, endless = false;    ///< else a branch
        std::uint32_t jump = 0;                ///< that makes it
        std::optional<std::uint32_t> other{};  ///< the jump that is its ELSE
        bool own = false;                      ///< of the program, which says its begin and end itself
    };
    struct Jump {
        JumpRole role = JumpRole::none;
        std::size_t region = 0;
    };
    std::vector<Region> regions;
    std::map<std::uint32_t, Jump> jumps;  ///< by their statements
};

/// Nothing where the program's jumps make no loops and branches that lie within each other, or are computed.
[[nodiscard]] std::optional<Structured> structured(const program::Unit& unit, const std::vector<Held>& held,
                                                   const program::Names& names, const base::Sources& sources);

/// The jump's condition always holds.
[[nodiscard]] bool is_always(const program::Unit& unit, const program::Jump& jump);

}  // namespace obrys::rewrite
