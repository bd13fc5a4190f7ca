#pragma once
/// The text of the folder materials/, put into the program when it is built. Private to this room.

#include <string_view>

namespace obrys::shop {

[[nodiscard]] std::string_view shipped_material_text();

}  // namespace obrys::shop
