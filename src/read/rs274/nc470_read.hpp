#pragma once
/// NC 470 programs, as post nc-470 writes them: text -> program tree. What is read: docs/dialects/nc-470.md.

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
[[nodiscard]] std::vector<program::Unit> read_nc470(std::uint32_t file, const base::Sources& sources,
                                                    program::Names& names, base::Diagnostics& diagnostics);

/// 0: nothing in its text tells it from others.
[[nodiscard]] int nc470_likelihood(std::string_view text, std::string_view file_name,
                                   std::vector<std::string>* signs = nullptr);

}  // namespace obrys::read::rs274
