#pragma once
/// The blank of a program while its two corners are read. Private to read/heidenhain.

#include <limits>

#include "program/unit.hpp"

namespace obrys::read::heidenhain {

/// The unit's blank; a new one has no corner yet: NaN.
inline program::Blank& blank_of(program::Unit& unit) {
    if (unit.blank) return *unit.blank;
    program::Blank& blank = unit.blank.emplace();
    blank.min.fill(std::numeric_limits<double>::quiet_NaN());
    blank.max = blank.min;
    return blank;
}

}  // namespace obrys::read::heidenhain
