#include "shop/files/obrys/machine_name.hpp"

#include "base/text.hpp"
#include "shop/files/obrys/machine_file.hpp"
#include "shop/nearest.hpp"

namespace obrys::shop {

bool names_machine_file(const std::string& name) {
    return base::to_upper(name).ends_with(".TOML") || name.find_first_of("/\\") != std::string::npos;
}

std::string no_shipped_machine(const std::string& name) { return "there is no shipped machine \"" + name + "\""; }

std::string machine_name_remedy(const std::string& name) {
    return words_remedy(name, shipped_machine_names(), "shipped") + "; the name of a machine file ends in .toml";
}

}  // namespace obrys::shop
