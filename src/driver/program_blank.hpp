#pragma once
/// The stock that a program states itself (BLK FORM), for a job that names none.

#include <optional>

#include "base/diagnostic.hpp"
#include "program/unit.hpp"
#include "shop/solid.hpp"

namespace obrys::driver {

/// A box in mm in the program's first coordinates, with a note that it is taken; nothing where the program states none,
/// or none with two corners (a complaint, code unknown-value).
[[nodiscard]] std::optional<shop::Stock> program_blank(const program::Unit& unit, base::Diagnostics& diagnostics);

}  // namespace obrys::driver
