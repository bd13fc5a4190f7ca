#pragma once
/// RS-274 programs, one reader for all variants: text -> program trees.

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "base/diagnostic.hpp"
#include "base/source.hpp"
#include "program/names.hpp"
#include "program/unit.hpp"

namespace obrys::read::rs274 {

/// Reads a LinuxCNC program: the main program first (its name is the file's, upper case, without suffix), then one unit
/// for each subprogram the text defines: `o100 sub` is "O100", `o<foo> sub` is "O<FOO>", `O1234` … `M99` is "O1234".
/// Errors go to `diagnostics` (codes syntax, unclosed) and spoil only their block.
[[nodiscard]] std::vector<program::Unit> read_linuxcnc(std::uint32_t file, const base::Sources& sources,
                                                       program::Names& names, base::Diagnostics& diagnostics);

/// How likely a text is a LinuxCNC program, 0 … 100; the file name's suffix counts too.
[[nodiscard]] int linuxcnc_likelihood(std::string_view text, std::string_view file_name,
                                      std::vector<std::string>* signs = nullptr);

}  // namespace obrys::read::rs274
