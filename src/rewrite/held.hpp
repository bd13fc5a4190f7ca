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
    count,
};
inline constexpr int never_there = -2;  ///< no run comes here
inline constexpr int several = -1;      ///< it depends on the way

struct Held {
    std::array<int, static_cast<std::size_t>(Mode::count)> of{never_there, never_there, never_there,
                                                              never_there, never_there, never_there};
    [[nodiscard]] int operator[](Mode m) const { return of[static_cast<std::size_t>(m)]; }
    int& operator[](Mode m) { return of[static_cast<std::size_t>(m)]; }
    bool operator==(const Held&) const = default;
};

/// The program of a call, or null.
using Callee = std::function<const program::Unit*(const program::Unit&, const program::Call&)>;

/// By program and statement; one more than it has statements: at its end.
using HeldModes = std::map<const program::Unit*, std::vector<Held>>;
[[nodiscard]] HeldModes held_modes(const std::vector<const program::Unit*>& programs, const Held& start,
                                   const std::map<const program::Unit*, Graph>& graphs, const Callee& callee);

}  // namespace obrys::rewrite
