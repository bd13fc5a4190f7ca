#pragma once
/// Codes of what speaks against cutting data and forces. Those of checks stand in base/codes.hpp; none of these comes
/// from a check.

#include <string_view>

namespace obrys::sim::cutting::codes {

inline constexpr std::string_view feed_differs = "feed-differs-from-cutting-data";
inline constexpr std::string_view spindle_power = "spindle-power";
inline constexpr std::string_view spindle_torque = "spindle-torque";
inline constexpr std::string_view chip_too_thin = "chip-too-thin";
inline constexpr std::string_view chip_too_thick = "chip-too-thick";

}  // namespace obrys::sim::cutting::codes
