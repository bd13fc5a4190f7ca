#include "shop/given.hpp"

#include "base/text.hpp"

namespace obrys::shop {

std::string given_key(std::string_view written) {
    std::string key;
    for (const char c : written)
        if (c != ' ' && c != '\t') key += c;
    return base::to_upper(key);
}

}  // namespace obrys::shop
