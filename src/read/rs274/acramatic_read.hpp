#pragma once
/// Acramatic 2100 programs: text -> program tree. What is read, and what is not: docs/dialects/acramatic.md.

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "base/diagnostic.hpp"
#include "base/source.hpp"
#include "program/names.hpp"
#include "program/unit.hpp"

namespace obrys::read::rs274 {

/// One program: its name is the file's, upper case, without suffix. Errors go to `diagnostics` (code syntax) and spoil
/// only their block.
[[nodiscard]] std::vector<program::Unit> read_acramatic(std::uint32_t file, const base::Sources& sources,
                                                        program::Names& names, base::Diagnostics& diagnostics);

/// How likely a text is an Acramatic 2100 program, 0 … 100.
[[nodiscard]] int acramatic_likelihood(std::string_view text, std::string_view file_name,
                                       std::vector<std::string>* signs = nullptr);

}  // namespace obrys::read::rs274
