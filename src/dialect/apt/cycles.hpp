#pragma once
/// Hole cycles of CYCLE/… and the couplets (word and number) that say their sizes.

#include <cstdint>
#include <string_view>

#include "program/traits.hpp"

namespace obrys::dialect::apt {

/// Rows of Traits::canned.
enum class Hole : std::uint8_t { drill, peck, chip_break, tap_rigid, tap_floating, feed_out, bore_stop };

struct HoleWord {
    std::string_view name;
    Hole hole = Hole::drill;
};
[[nodiscard]] const HoleWord* find_hole(std::string_view upper);

/// What a number of a cycle says. Lengths count from the point of GOTO along the tool.
enum class HoleValue : std::uint8_t {
    depth,         ///< below the point, whatever its sign
    rapid_to,      ///< System::rapid_to
    clearance,     ///< above the point
    retract,       ///< above the point, behind the hole
    dwell,         ///< s
    first_step,    ///< of pecks
    step,          ///< of the pecks behind the first, or of all
    back,          ///< of a chip break
    feed_minute,   ///< in mm
    feed_turn,     ///< in mm
    inch_minute,   ///< in inches
    inch_turn,     ///< in inches
    plain_minute,  ///< in the text's unit
    plain_turn,    ///< in the text's unit
    threads_inch,  ///< of a tap
    pitch,         ///< of a tap, in the text's unit
    none,          ///< no effect on the path
};
struct Couplet {
    std::string_view name;
    HoleValue value = HoleValue::depth;
    bool alone = false;  ///< no number goes with it
};
[[nodiscard]] const Couplet* find_couplet(std::string_view upper);

}  // namespace obrys::dialect::apt
