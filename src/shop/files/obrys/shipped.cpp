#include "shop/files/obrys/shipped.hpp"

#include <cassert>

#include "shop/files/obrys/machine_file.hpp"

namespace obrys::shop {

std::optional<Machine> shipped_machine(const std::string& name) {
    for (const ShippedText& t : shipped_texts()) {
        if (t.name != name) continue;
        base::Sources sources;
        base::Diagnostics diagnostics;
        Machine machine = read_machine(sources.add(name, std::string(t.text)), sources, diagnostics);
        assert(!diagnostics.has_errors());
        return machine;
    }
    return std::nullopt;
}

std::vector<std::string> shipped_machine_names() {
    std::vector<std::string> out;
    for (const ShippedText& t : shipped_texts()) out.emplace_back(t.name);
    return out;
}

}  // namespace obrys::shop
