#pragma once
/// SINUMERIK 840D programs: text -> program tree.

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "base/diagnostic.hpp"
#include "base/source.hpp"
#include "program/names.hpp"
#include "program/unit.hpp"

namespace obrys::read::sinumerik {

/// Reads one source text: one unit, or one for each program of an archive (`%_N_NAME_SPF`). Errors go to `diagnostics`
/// (codes syntax, unclosed) and spoil only their block; words that are not run become problems of their unit.
[[nodiscard]] std::vector<program::Unit> read(std::uint32_t file, const base::Sources& sources, program::Names& names,
                                              base::Diagnostics& diagnostics);

/// Definitions of global user data or macros, by the file's name (as the control reserves them) or by what it defines;
/// other makers' files end in .DEF, too.
[[nodiscard]] bool is_definition_file(std::string_view text, std::string_view upper_name);

/// In capitals: a word of the control, which names nothing else.
[[nodiscard]] bool is_own_word(std::string_view upper);

/// How likely a text is a SINUMERIK program, 0 … 100; the file name's suffix counts too.
[[nodiscard]] int likelihood(std::string_view text, std::string_view file_name,
                             std::vector<std::string>* signs = nullptr);

}  // namespace obrys::read::sinumerik
