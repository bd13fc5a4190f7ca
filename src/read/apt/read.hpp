#pragma once
/// Cutter locations as APT text, the language between CAM systems and their postprocessors. docs/dialects/apt-cl.md.

#include <string>
#include <string_view>
#include <vector>

#include "base/diagnostic.hpp"
#include "program/names.hpp"
#include "program/unit.hpp"

namespace obrys::read::apt {

[[nodiscard]] program::Unit read(std::uint32_t file, const base::Sources& sources, program::Names& names,
                                 base::Diagnostics& diagnostics);
/// 0 to 100: how likely the text holds cutter locations; `signs`: its words that say so.
[[nodiscard]] int likelihood(std::string_view text, std::string_view file_name,
                             std::vector<std::string>* signs = nullptr);

}  // namespace obrys::read::apt
