#pragma once
/// Autodesk's intermediate CL files, as Fusion hands them to its postprocessors: read from their listing.
/// docs/dialects/fusion.md.

#include <string>
#include <string_view>
#include <vector>

#include "base/diagnostic.hpp"
#include "program/names.hpp"
#include "program/unit.hpp"

namespace obrys::read::fusion {

/// The text is a listing (listing.hpp).
[[nodiscard]] program::Unit read(std::uint32_t file, const base::Sources& sources, program::Names& names,
                                 base::Diagnostics& diagnostics);
/// 0 or 100: whether the text is a listing; `signs`: its first word.
[[nodiscard]] int likelihood(std::string_view text, std::string_view file_name,
                             std::vector<std::string>* signs = nullptr);

}  // namespace obrys::read::fusion
