#pragma once
/// Rows of figures as the texts of this folder have them.

#include <nlohmann/json_fwd.hpp>
#include <string>

namespace obrys::report::cutting {

/// With so many digits that count; "?" where it is not known.
[[nodiscard]] std::string figure(double value, int digits = 4);
/// "  name            12.3 unit  remark", ended.
[[nodiscard]] std::string row(const std::string& name, const std::string& value, const std::string& unit,
                              const std::string& remark = {});
/// Width characters at least; `right`: blanks in front.
[[nodiscard]] std::string padded(std::string text, std::size_t width, bool right = false);
/// As JSON has it, to twelve digits: null where it is not known.
[[nodiscard]] nlohmann::ordered_json number(double value);

}  // namespace obrys::report::cutting
