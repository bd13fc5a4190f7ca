#pragma once
/// Machines from their texts. File format: docs/machine-file.md.

#include <optional>
#include <string>
#include <vector>

#include "shop/machine.hpp"

namespace obrys::shop {

/// Reads a machine text. Always gives a machine: what was wrong is in `diagnostics` and keeps its default.
[[nodiscard]] Machine read_machine(std::uint32_t file, const base::Sources& sources, base::Diagnostics& diagnostics);

/// The shipped machines of folder machines/, built in: "lathe-generic", "fv25cnc-a" …; nothing for another name.
[[nodiscard]] std::optional<Machine> shipped_machine(const std::string& name);
[[nodiscard]] std::vector<std::string> shipped_machine_names();

}  // namespace obrys::shop
