#include "shop/solid.hpp"

#include "base/text.hpp"

namespace obrys::shop {

bool is_step_name(std::string_view path) {
    const std::size_t dot = path.rfind('.');
    if (dot == std::string_view::npos) return false;
    const std::string_view end = path.substr(dot + 1);
    return base::equals_ignoring_case(end, "step") || base::equals_ignoring_case(end, "stp");
}

}  // namespace obrys::shop
