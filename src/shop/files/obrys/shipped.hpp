#pragma once
/// The texts of the folder machines/, put into the program when it is built. Private to this room.

#include <span>
#include <string_view>

namespace obrys::shop {

struct ShippedText {
    std::string_view name, text;
};

[[nodiscard]] std::span<const ShippedText> shipped_texts();

}  // namespace obrys::shop
