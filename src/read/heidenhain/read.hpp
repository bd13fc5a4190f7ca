#pragma once
/// HEIDENHAIN Klartext (.H) and DIN/ISO (.I) -> program tree. Semantics and sources: docs/dialects/heidenhain.md.

#include <vector>

#include "base/diagnostic.hpp"
#include "base/source.hpp"
#include "program/names.hpp"
#include "program/unit.hpp"

namespace obrys::read::heidenhain {

/// Reads the whole text; it always becomes one unit. What cannot be read is a `syntax` diagnostic with its place and
/// stays in the tree as a word that is not run; the rest is read all the same.
[[nodiscard]] program::Unit read(std::uint32_t file, const base::Sources& sources, program::Names& names,
                                 base::Diagnostics& diagnostics);

/// As above, for DIN/ISO (`%NAME G71 *` … `N99999999 %NAME G71 *`): the same program gives a tree of the same meaning.
[[nodiscard]] program::Unit read_iso(std::uint32_t file, const base::Sources& sources, program::Names& names,
                                     base::Diagnostics& diagnostics);

/// How much a text looks like Klartext, or like DIN/ISO: 0 (not at all) to 100.
[[nodiscard]] int likelihood(std::string_view text, std::string_view file_name,
                             std::vector<std::string>* signs = nullptr);
[[nodiscard]] int iso_likelihood(std::string_view text, std::string_view file_name,
                                 std::vector<std::string>* signs = nullptr);

}  // namespace obrys::read::heidenhain
