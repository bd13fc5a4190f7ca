#pragma once
/// Where loadable modules lie: libraries beside the program that are not wanted by everyone.

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace obrys::driver {

/// Folders in which modules are looked for, the first one first: those that the environment names in OBRYS_MODULES
/// (separated by colons) and no others, else lib/obrys beside the folder of the running program.
[[nodiscard]] std::vector<std::filesystem::path> module_folders();

/// The file of a module, e.g. "step"; nothing where there is none.
[[nodiscard]] std::optional<std::filesystem::path> find_module(const std::string& name);

}  // namespace obrys::driver
