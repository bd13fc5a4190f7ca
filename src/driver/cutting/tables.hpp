#pragma once
/// Machines and materials that a call names. Nothing after a complaint.

#include <optional>
#include <string>
#include <vector>

#include "base/diagnostic.hpp"
#include "base/source.hpp"
#include "driver/storage.hpp"
#include "shop/machine.hpp"
#include "shop/material.hpp"

namespace obrys::driver::cutting {

/// What was read, and what was wrong with it.
struct Texts {
    base::Sources sources;
    base::Diagnostics diagnostics;
};

/// A shipped machine, or a machine file.
[[nodiscard]] std::optional<shop::Machine> machine_named(const std::string& name, Texts& texts);

/// Of the text that names it; complaints about a file that cannot be read are there.
struct MaterialFile {
    fs::path path;
    base::Span where;
};
/// Those of the files, and the shipped ones behind them.
[[nodiscard]] std::vector<shop::WorkMaterial> materials(const std::vector<MaterialFile>& files, const Storage& storage,
                                                        base::Sources& sources, base::Diagnostics& diagnostics);
/// The same of files that a call names.
[[nodiscard]] std::optional<std::vector<shop::WorkMaterial>> materials(const std::vector<std::string>& files,
                                                                       Texts& texts);
/// One of them; the complaint is at `where`.
[[nodiscard]] const shop::WorkMaterial* material_named(const std::string& name,
                                                       const std::vector<shop::WorkMaterial>& all,
                                                       base::Diagnostics& diagnostics, const base::Span& where);

/// The number of a file's text; nothing after a complaint.
[[nodiscard]] std::optional<std::uint32_t> text_of(const std::string& path, Texts& texts);

}  // namespace obrys::driver::cutting
