#pragma once
/// What a Klartext block is by its first words, and how its lines are written then. Private to the folder.

#include <optional>
#include <string>
#include <string_view>

#include "format/heidenhain/words.hpp"

namespace obrys::format::heidenhain {

enum class Shape : std::uint8_t {
    words,    ///< words known one by one
    generic,  ///< words that blanks separate
    formula,
    function,  ///< FN
    cycle,     ///< CYCL DEF, TCH PROBE: parameters on the lines behind
    names,     ///< SEL, PATTERN …: blanks only
    kept,      ///< BEGIN PGM, END PGM: the whole line stays
};

struct Block {
    Shape shape = Shape::names;
    WordKind words = WordKind::path;
};

/// The code of a block's first line, without number; nothing where it is not understood.
[[nodiscard]] std::optional<std::string> opening_line(std::string_view code, Decimal decimal, Block& block);
/// A line behind `~`.
[[nodiscard]] std::optional<std::string> further_line(std::string_view code, Decimal decimal, const Block& block);
/// Q200=2 Q201=-20: lines of a cycle.
[[nodiscard]] std::optional<std::string> cycle_line(std::string_view code, Decimal decimal);
/// `Q200=`: such a line behind CYCL DEF may belong to the cycle.
[[nodiscard]] bool is_cycle_line(std::string_view code);
/// The line's first word is a word of a cycle's definition: CYCL, CYCLE, TCH.
[[nodiscard]] bool opens_cycle(std::string_view code);

// --- formula.cpp
[[nodiscard]] bool formula_words(Scan& in, std::string& out);
/// What stands behind FN; nothing where it is not understood.
[[nodiscard]] std::optional<std::string> function_block(Scan& in, Decimal decimal);

}  // namespace obrys::format::heidenhain
