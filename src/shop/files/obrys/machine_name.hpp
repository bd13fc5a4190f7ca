#pragma once
/// Names of machines as a job or a call gives them: of a shipped one, or of a machine file.

#include <string>

namespace obrys::shop {

/// A machine file: the name ends in .toml or leads into a folder.
[[nodiscard]] bool names_machine_file(const std::string& name);

/// The complaint about a name that no shipped machine has, and what to do about it.
[[nodiscard]] std::string no_shipped_machine(const std::string& name);
[[nodiscard]] std::string machine_name_remedy(const std::string& name);

}  // namespace obrys::shop
