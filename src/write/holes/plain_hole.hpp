#pragma once
/// A hole as any control's cycle says it, and the cycles that say it. Private to this room.

#include <cstdint>
#include <optional>
#include <vector>

#include "write/holes/same_hole.hpp"

namespace obrys::write {

inline constexpr double same_length = 1e-9;  ///< mm

enum class Way : std::uint8_t { drill, peck, chip_break, feed_out, tap_floating, tap_rigid, tap_chip_break };

/// A hole, whoever says it.
struct Hole {
    Way way = Way::drill;
    std::optional<double> surface;
    double top = 0;     ///< where feed begins
    double bottom = 0;  ///< where it ends
    double end = 0;     ///< where the tool stands behind it
    double infeed = 0;
    double gap = 0;               ///< above the last infeed, where the next begins; the way back where chips are broken
    double dwell = 0;             ///< at the bottom, s
    double feed = 0;              ///< mm/min
    double pitch = 0;             ///< of a thread
    double direction = 0;         ///< of the spindle where a tap goes in: 1 clockwise, -1 counter-clockwise
    std::optional<double> speed;  ///< of a tap, where the cycle says its own, 1/min
};

/// By a retract plane and a bottom.
[[nodiscard]] HoleWay as_canned(const cl::Cycle& from, const Hole& hole);
/// By a surface, a clearance and a depth; none where no cycle says it all.
[[nodiscard]] std::vector<HoleWay> as_depths(const cl::Cycle& from, const Hole& hole);
[[nodiscard]] HoleWay as_tap_chip_breaking(const cl::Cycle& from, const Hole& hole);

}  // namespace obrys::write
