#include "shop/files/obrys/tool_file.hpp"
#include "shop/files/obrys/tables.hpp"

namespace obrys::shop {

std::vector<Tool> read_tools(std::uint32_t file, const base::Sources& sources, base::Diagnostics& diagnostics) {
    std::vector<Tool> tools;
    const auto root = parse_toml(file, sources, diagnostics);
    if (!root) return tools;
    base::Diagnostics found;
    Section s(*root, "the tool file", found);
    read_tool_tables(s, tools);
    s.finish_file(diagnostics);
    return tools;
}

}  // namespace obrys::shop
