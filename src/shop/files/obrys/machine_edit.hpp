#pragma once
/// A machine file with other values, everything else as it was written.

#include <optional>
#include <span>
#include <string>

#include "base/diagnostic.hpp"
#include "base/source.hpp"

namespace obrys::shop {

struct NewValue {
    std::string name;   ///< "tool_change_time", "motion.jerk", "axis.X.rapid"
    std::string value;  ///< as TOML has it
    std::string origin;
};

/// Values in the place of those that stand there, or added, each with its origin. Nothing where the text is not TOML.
[[nodiscard]] std::optional<std::string> with_values(std::uint32_t file, const base::Sources& sources,
                                                     std::span<const NewValue> values);

}  // namespace obrys::shop
