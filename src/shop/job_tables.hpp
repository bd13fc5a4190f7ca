#pragma once
/// Tables of the job file that have a file of their own. Private to shop.

#include "shop/given.hpp"
#include "shop/section.hpp"

namespace obrys::shop {

/// [variables] (given.cpp).
[[nodiscard]] GivenValues read_variables(Section& file);

}  // namespace obrys::shop
