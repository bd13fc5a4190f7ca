#pragma once
/// A JSON text as plain values, each with its place. The JSON library stays behind it.

#include <optional>

#include "shop/files/document.hpp"

namespace obrys::shop {

/// The whole text; null values are left out. An error with its place (code job-file), and nothing, where it is no JSON,
/// is nested deeper than 64 or has more than two million values.
[[nodiscard]] std::optional<Value> parse_json(std::uint32_t file, const base::Sources& sources,
                                              base::Diagnostics& diagnostics);

}  // namespace obrys::shop
