#pragma once
/// For controls whose words mean what the state in force says (the same letter is a coordinate, a chamfer or a number of
/// repeats): what the reader took to be in force where it read a piece of text, and what the piece changes. The run may
/// come to the piece by another way than the text, with another state: then the piece is read anew.

#include <array>
#include <bit>
#include <cstdint>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "base/diagnostic.hpp"
#include "base/source.hpp"
#include "program/names.hpp"

namespace obrys::program {

struct Unit;

inline constexpr std::size_t mode_count = 24;
/// Values whose meaning is the reader's own.
using Modes = std::array<std::int32_t, mode_count>;
/// A bit for each of them.
using ModeSet = std::uint32_t;

/// How a piece of text depends on modes.
struct ModeUse {
    std::uint32_t before = 0, after = 0;  ///< in ModeTable::states: as it was read, and behind it
    ModeSet relied = 0;                   ///< what its words mean depends on these
    ModeSet written = 0;                  ///< it sets these
    std::uint8_t piece = 0;               ///< which of the block's pieces it is
    bool whole = false;                   ///< its statements are one piece; else each is a piece of its own
    bool operator==(const ModeUse&) const = default;
};
/// Statements [first, last).
struct ModeSpan {
    std::uint32_t first = 0, last = 0;
    std::uint32_t use = 0;  ///< in ModeTable::uses
};

/// A piece of a block, read anew.
struct PieceRead {
    std::unique_ptr<const Unit> unit;  ///< null: there is no such piece
    std::uint32_t first = 0;           ///< statement with which it begins; the unit ends with the piece
    base::Diagnostics said;            ///< by its reader, about this reading
};

class ReadAgain {
public:
    ReadAgain() = default;
    ReadAgain(const ReadAgain&) = delete;
    ReadAgain& operator=(const ReadAgain&) = delete;
    virtual ~ReadAgain() = default;
    /// The piece of `unit` that begins with `statement`, as its control reads it while `modes` are in force.
    [[nodiscard]] virtual PieceRead read(const Unit& unit, std::uint32_t statement, const ModeUse& use,
                                         const Modes& modes, const base::Sources& sources, Names& names,
                                         base::Diagnostics& diagnostics) const = 0;
    /// Two of the modes by which they differ in the control's words: "stands in the text behind G80, is run in G81".
    [[nodiscard]] virtual std::string difference(const Modes& text, const Modes& run, ModeSet among) const = 0;
};

/// All pieces of a unit that depend on modes or change them.
struct ModeTable {
    Modes begin{};  ///< in which a run begins
    std::vector<Modes> states;
    std::vector<ModeUse> uses;
    std::vector<ModeSpan> spans;  ///< by rising statements
    std::shared_ptr<const ReadAgain> reader;
};

/// Bits of the modes among `set` whose values differ.
[[nodiscard]] inline ModeSet different(const Modes& a, const Modes& b, ModeSet set) {
    ModeSet found = 0;
    for (; set != 0; set &= set - 1) {
        const auto i = static_cast<std::size_t>(std::countr_zero(set));
        if (a[i] != b[i]) found |= set & (~set + 1);
    }
    return found;
}

}  // namespace obrys::program
