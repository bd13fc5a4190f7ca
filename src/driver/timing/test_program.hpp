#pragma once
/// A program whose times show how a machine moves: rapids of three lengths, zigzags at three feeds, circles.

#include <string>

namespace obrys::driver {

/// In the words of LinuxCNC, for translation. `size`: mm of each axis that it needs; `feed`: the highest, mm/min.
[[nodiscard]] std::string test_program(double size, double feed);

}  // namespace obrys::driver
