#pragma once
/// Which modes hold before each statement, whatever way a run comes to it: what the text of a block alone does not say.

#include <array>
#include <cstdint>
#include <functional>
#include <map>
#include <vector>

#include "rewrite/graph.hpp"

namespace obrys::rewrite {

enum class Mode : std::uint8_t {
    motion,    ///< a program::Modal
    plane,     ///< 17 … 19
    distance,  ///< 1: increments
    across,    ///< 1: X words are diameters
    feed,      ///< 1: per revolution
    surface,   ///< 1: constant cutting speed
    tool,      ///< number of that in the spindle; 0: none
    prepared,  ///< number of that which waits for M6; 0: none
    length,    ///< 1: a length is compensated by a word
    side,      ///< 1: so is the radius
    radius,    ///< D
    // The statement that says it, as `place_number`.
    cycle,    ///< that a call runs
    contour,  ///< that a cycle works on
    pole,
    shift_x,  ///< parts of the programmed frame, all in order
    shift_y,
    shift_z,
    turn,
    mirror,
    scale,
    count,
};
inline constexpr int never_there = -2;  ///< no run comes here
inline constexpr int several = -1;      ///< it depends on the way

inline constexpr int nowhere = -3;  ///< no way that leads here says it

struct Held {
    Held() { of.fill(never_there); }
    std::array<int, static_cast<std::size_t>(Mode::count)> of;
    [[nodiscard]] int operator[](Mode m) const { return of[static_cast<std::size_t>(m)]; }
    int& operator[](Mode m) { return of[static_cast<std::size_t>(m)]; }
    bool operator==(const Held&) const = default;
};

/// A statement of one of the programs as a number; `several` where there are too many for that.
[[nodiscard]] int place_number(std::size_t program, std::uint32_t statement);
struct StatementPlace {
    std::size_t program;
    std::uint32_t statement;
};
[[nodiscard]] StatementPlace place_of(int number);

/// The program of a call, or null.
using Callee = std::function<const program::Unit*(const program::Unit&, const program::Call&)>;

/// What else counts beside the words.
struct Surroundings {
    bool tools_wait = false;  ///< T waits for M6
    Callee callee;
};

/// By program and statement; one more than it has statements: at its end.
using HeldModes = std::map<const program::Unit*, std::vector<Held>>;
[[nodiscard]] HeldModes held_modes(const std::vector<const program::Unit*>& programs, const Held& start,
                                   const std::map<const program::Unit*, Graph>& graphs, const Surroundings& around);

}  // namespace obrys::rewrite
