#pragma once
/// What the parts of the Acramatic reader share: the modes that say what letters mean, and the table of cycle
/// parameters as the text has left it. Programs of this control are read from top to bottom: jumps, subprograms and
/// expressions of it are not known and not read. Private to the folder.

#include <array>
#include <optional>

#include "dialect/rs274/acramatic.hpp"
#include "read/rs274/state.hpp"

namespace obrys::read::rs274 {

using dialect::rs274::AcramaticCycle;
using dialect::rs274::AcramaticParameter;

struct TableValue {
    std::optional<Value> value;
    /// Written since the last cycle was cancelled. Lengths stay in the table; how long dwells of earlier cycles hold is
    /// not documented.
    bool fresh = false;
    bool told = false;  ///< that it is not known has been said
};

/// What moves a block of coordinates without a G code of its own.
enum class Moving : std::uint8_t {
    unsaid,    ///< nothing yet
    straight,  ///< G0, G1
    arc,
    cycle,
    lost  ///< a cycle that is not run
};

struct AcramaticState : State {
    using State::State;
    Moving moving = Moving::unsaid;
    int tenths = 0;  ///< G number * 10 of the cycle in force
    AcramaticCycle cycle = AcramaticCycle::drill;
    bool breaks = false;  ///< the rigid tap in force goes back after each infeed
    bool incremental = false, inch = false, other_plane = false;
    std::array<TableValue, static_cast<std::size_t>(AcramaticParameter::count)> table{};

    [[nodiscard]] TableValue& entry(AcramaticParameter p) { return table[static_cast<std::size_t>(p)]; }
};

/// A line that writes the table: `[$CYCLE_PARAMS(2)NAME] = value`, which begins here.
void read_table_line(AcramaticState& s);
/// acramatic_block.cpp: the words of a block, which begin here, into the tree.
void read_acramatic_block(AcramaticState& s);
/// The words of a block that drills or taps: those of the tree's cycle in their place.
void cycle_block(AcramaticState& s);
/// Complains about the first word with a value whose letter is none of `letters`.
void refuse_other_letters(State& s, std::uint64_t letters, std::string_view user);
/// Something that is run otherwise than it may be.
void note_assumption(State& s, std::uint32_t begin, std::uint32_t end, std::string text, std::string remedy);

}  // namespace obrys::read::rs274
