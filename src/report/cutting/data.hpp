#pragma once
/// Cutting data as text and JSON. What is not known is said, and null.

#include <string>
#include <vector>

#include "shop/material.hpp"
#include "sim/cutting/data.hpp"

namespace obrys::report::cutting {

struct DataSubject {
    sim::cutting::Asked asked;
    sim::cutting::Data data;
    std::string machine;  ///< empty: none was given
};
[[nodiscard]] std::string as_text(const DataSubject& subject);
[[nodiscard]] std::string as_json(const DataSubject& subject);

/// Materials that can be named, with where their values come from.
[[nodiscard]] std::string materials_as_text(const std::vector<shop::WorkMaterial>& all);
[[nodiscard]] std::string materials_as_json(const std::vector<shop::WorkMaterial>& all);

}  // namespace obrys::report::cutting
