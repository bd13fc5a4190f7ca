#include "driver/loadable.hpp"

#include <algorithm>
#include <cstdlib>
#include <string_view>

namespace obrys::driver {

namespace fs = std::filesystem;

std::vector<fs::path> module_folders() {
    if (const char* said = std::getenv("OBRYS_MODULES"); said != nullptr && *said != '\0') {
        std::vector<fs::path> out;
        std::string_view rest(said);
        while (!rest.empty()) {
            const std::string_view one = rest.substr(0, rest.find(':'));
            if (!one.empty()) out.emplace_back(one);
            rest.remove_prefix(std::min(rest.size(), one.size() + 1));
        }
        return out;
    }
    std::error_code error;
    const fs::path program = fs::read_symlink("/proc/self/exe", error);
    if (error) return {};
    return {program.parent_path().parent_path() / "lib" / "obrys"};
}

std::optional<fs::path> find_module(const std::string& name) {
    std::error_code error;
    for (const fs::path& folder : module_folders()) {
        const fs::path file = folder / ("libobrys-" + name + ".so");
        if (fs::is_regular_file(file, error)) return fs::absolute(file, error);
    }
    return std::nullopt;
}

}  // namespace obrys::driver
