#pragma once
/// What becomes of what a program says when it is written for another control.

#include <cstdint>
#include <string_view>

namespace obrys::base {

enum class Fate : std::uint8_t {
    mapped,    ///< the control has it and is told so
    expanded,  ///< it is there by its moves, or in other words, or taken for granted
    lost,      ///< it is not there
};

[[nodiscard]] constexpr std::string_view name_of(Fate fate) {
    return fate == Fate::mapped ? "mapped" : fate == Fate::expanded ? "expanded" : "lost";
}

}  // namespace obrys::base
