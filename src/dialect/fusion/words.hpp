#pragma once
/// What the numbers of the records are called.

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>

namespace obrys::dialect::fusion {

/// What a move is for, by the upper half of its flags: in the order in which the file says their feeds (`movement:…`).
inline constexpr std::array<std::string_view, 16> movements{
    "rapid",       "lead-in", "cutting", "lead-out", "transition", "direct",  "ramp-helix", "ramp-profile",
    "ramp-zigzag", "ramp",    "plunge",  "predrill", "extended",   "reduced", "finish",     "high-feed",
};

/// Bits of the lower half.
struct Flag {
    std::uint32_t bit = 0;
    std::string_view name;
};
/// `on-curve`: the point is one of many that stand for a curve; what else it says is not known, and no post asks.
inline constexpr std::array flag_names{Flag{0x1, "first"}, Flag{0x2, "last"}, Flag{0x8, "on-curve"}, Flag{0x80, "left"},
                                       Flag{0x100, "right"}};

/// By its number; empty: not known. In the order in which Autodesk's declarations for posts list them; 2, 12, 13, 38
/// and 39 stand in files.
[[nodiscard]] std::string_view command_name(std::uint32_t number);

struct Coolant {
    std::string_view name;  ///< as the parameter operation:tool_coolant says it; its place is its number
    bool flood = false, mist = false;
    std::string_view beyond{};  ///< what of it the stream has no word for
};
inline constexpr std::array coolants{
    Coolant{"disabled"},
    Coolant{"flood", true},
    Coolant{"mist", false, true},
    Coolant{"tool", false, false, "coolant through the tool"},
    Coolant{"air", false, false, "air"},
    Coolant{"air through tool", false, false, "air through the tool"},
    Coolant{"suction", false, false, "suction"},
    Coolant{"flood mist", true, true},
    Coolant{"flood tool", true, false, "coolant through the tool"},
};
[[nodiscard]] const Coolant* find_coolant(std::string_view name);

/// Parameters without effect on the path outside of cycles, which describe the operation, the stock or the document.
[[nodiscard]] bool describes(std::string_view parameter);

}  // namespace obrys::dialect::fusion
