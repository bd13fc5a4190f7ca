#pragma once
/// The two languages' block loops. Private to the folder.

#include "format/heidenhain/format.hpp"

namespace obrys::format::heidenhain {

[[nodiscard]] Formatted formatted_klartext(std::string_view text, const Options& options);
[[nodiscard]] Formatted formatted_iso(std::string_view text, const Options& options);

}  // namespace obrys::format::heidenhain
