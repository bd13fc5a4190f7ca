#include "shop/material.hpp"

#include "base/text.hpp"
#include "shop/nearest.hpp"

namespace obrys::shop {

const WorkMaterial* find_material(const std::vector<WorkMaterial>& all, const std::string& name) {
    for (const WorkMaterial& m : all) {
        if (base::equals_ignoring_case(m.name, name)) return &m;
        for (const std::string& other : m.names)
            if (base::equals_ignoring_case(other, name)) return &m;
    }
    return nullptr;
}

std::string material_remedy(const std::vector<WorkMaterial>& all, const std::string& name) {
    std::vector<std::string> words;
    for (const WorkMaterial& m : all) {
        words.push_back(m.name);
        words.insert(words.end(), m.names.begin(), m.names.end());
    }
    const std::string near = nearest(name, words);
    return (near.empty() ? "" : "did you mean \"" + near + "\"? ") +
           std::string("obrys data --list prints all of them");
}

}  // namespace obrys::shop
