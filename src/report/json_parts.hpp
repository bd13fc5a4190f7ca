#pragma once
/// What the writers of JSON have in common. Private to the folder: it brings the whole of the JSON library along.

#include <cmath>
#include <nlohmann/json.hpp>

namespace obrys::report {

using Json = nlohmann::ordered_json;

/// A number, or null where it is not known.
[[nodiscard]] inline Json number_or_null(double v) { return std::isfinite(v) ? Json(v) : Json(nullptr); }

}  // namespace obrys::report
