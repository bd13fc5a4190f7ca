#pragma once
/// Programmable frames: what a statement changes of them. Private to rewrite.

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "cl/cycle.hpp"
#include "program/unit.hpp"
#include "rewrite/held.hpp"

namespace obrys::rewrite {

/// Parts of the programmed frame: shift along X, Y and Z, then rotation in the plane, mirror image, scaling.
inline constexpr std::array frame_modes{Mode::shift_x, Mode::shift_y, Mode::shift_z,
                                        Mode::turn,    Mode::mirror,  Mode::scale};

/// The parts that the statement gives a value, and with `ended` those that it ends besides.
[[nodiscard]] std::vector<Mode> frame_parts_of(const program::Unit& unit, std::uint32_t statement, bool ended);

inline constexpr std::array shift_modes{Mode::shift_x, Mode::shift_y, Mode::shift_z};
/// 0: X.
[[nodiscard]] std::optional<std::size_t> axis_of_role(cl::CycleRole role);

}  // namespace obrys::rewrite
