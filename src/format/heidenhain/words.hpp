#pragma once
/// Words of Klartext blocks: path words, tool words, generic words. Private to the folder.
/// Each function writes what is left on the line and returns false where something is not understood.

#include <string>

#include "format/heidenhain/scan.hpp"

namespace obrys::format::heidenhain {

enum class WordKind : std::uint8_t {
    path,       ///< L C CT CP …, STOP, axes alone
    circle,     ///< CR: its R is a radius with a sign
    corner,     ///< CHF, RND: R and a plain number are unsigned
    tool_call,  ///< X Y Z alone are the tool axis; S; DL DR DR2
    tool_definition,
    blank_form,  ///< BLK FORM
};

/// Words known one by one: glued ones are separated, `X 10` becomes X+10, `F MAX` FMAX.
[[nodiscard]] bool known_words(Scan& in, WordKind kind, std::string& out);
/// Words that only blanks separate (FK, APPR, DEP, LN, SPL, PLANE): upper case, signs of axes, `F MAX`.
[[nodiscard]] bool generic_words(Scan& in, Decimal decimal, std::string& out);

}  // namespace obrys::format::heidenhain
