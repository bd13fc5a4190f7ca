#pragma once
/// Where the tip of a turning insert lies as seen from the centre of its nose.

#include <array>

#include "base/whole.hpp"

namespace obrys::shop {

/// Tool::orientation, 1 to 9, as controls of the RS-274 family count it (Q of LinuxCNC's tool table, T of FANUC's
/// offsets), and the other way round: each counts a mirrored picture of the other. 0, which says none: 3.
[[nodiscard]] constexpr int mirrored_orientation(int orientation) {
    constexpr std::array mirrored{3, 4, 3, 2, 1, 5, 8, 7, 6, 9};
    return mirrored[base::clipped<std::size_t>(orientation, 0, mirrored.size() - 1)];
}

}  // namespace obrys::shop
