#pragma once
/// Tables of the job file that have a file of their own. Private to this room.

#include "shop/files/section.hpp"
#include "shop/given.hpp"

namespace obrys::shop {

/// [variables] (variables.cpp).
[[nodiscard]] GivenValues read_variables(Section& file);

}  // namespace obrys::shop
