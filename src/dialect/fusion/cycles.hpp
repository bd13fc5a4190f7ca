#pragma once
/// Cycles of the intermediate file, and what they may say.

#include <cstdint>
#include <string_view>

namespace obrys::dialect::fusion {

/// The first eight are canned cycles, in the order of Traits::canned.
enum class Hole : std::uint8_t {
    drill,
    peck,
    chip_break,
    tap_rigid,
    tap_floating,
    bore_feed,
    bore_stop,
    bore_orient,
    // Written as moves.
    break_through,
    guided,
    thread_turning,
    not_run,
};

struct CycleWord {
    std::string_view name;  ///< the end of the name in the file
    Hole hole = Hole::drill;
    std::string_view note{};  ///< of what is not run: why
};
[[nodiscard]] const CycleWord* find_cycle(std::string_view name);

/// A number that cycles of holes and threads say and that is looked at, or says nothing of the path.
[[nodiscard]] bool is_known_value(std::string_view name);

}  // namespace obrys::dialect::fusion
