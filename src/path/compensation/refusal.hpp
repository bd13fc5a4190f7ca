#pragma once
/// The words in which a control with Method::held_move refuses a move.

#include <string>

#include "path/setting.hpp"

namespace obrys::path {

/// LinuxCNC 2.9's own wording, word for word, so that a user finds it in its documents; empty for Refusal::none.
/// Lengths in it are divided by `unit`, the mm of the program's unit.
[[nodiscard]] std::string message(const Fault& fault, double unit = 1);

}  // namespace obrys::path
