#pragma once
/// Words of the DIN/ISO cycles that have no Q numbers: `G83 P01 2 P02 -20`, `G73 H+30`. Sources: thesis 2010 on the FV
/// 25 CNC A, appendix 1; HEIDENHAIN ISO Programming User's Manuals, iTNC 530 (340 49x, list of addresses: F with G04
/// and G72, H with G73, S with G36, T with G62) and TNC 360/407, chapter "Cycles". The P numbers of G74 … G86 and G56 …
/// G59 follow the order in which Klartext asks for the same values; no page with all of them was at hand.

#include <span>
#include <string_view>

#include "program/cycle.hpp"

namespace obrys::dialect::heidenhain {

struct IsoCycleWord {
    int g = 0;
    std::string_view word;  ///< letter, or P and two digits
    program::CycleRole role = program::CycleRole::depth;
};

/// Nothing where the cycle has no such word.
[[nodiscard]] const IsoCycleWord* find_iso_word(int g, std::string_view word);
/// By G code.
[[nodiscard]] std::span<const IsoCycleWord> all_iso_words();

/// Sense of rotation that the G code itself says: +1 counter-clockwise (DR+), -1 clockwise (DR-), 0 none.
[[nodiscard]] int iso_direction(int g);

}  // namespace obrys::dialect::heidenhain
