#pragma once
/// The controls whose programs can be read, one entry each: this table is all that ties a reader to the rest.

#include <span>
#include <string_view>
#include <vector>

#include "base/diagnostic.hpp"
#include "program/names.hpp"
#include "program/unit.hpp"

namespace obrys::driver {

struct Control {
    std::string_view name;  ///< of --control and of the job's `control`
    base::BlockNumbers numbers = base::BlockNumbers::none;
    /// Upper case, with the point. Subprograms are looked for in this order where two files have one name.
    std::span<const std::string_view> program_suffixes, definition_suffixes;
    std::vector<program::Unit> (*read)(std::uint32_t file, const base::Sources&, program::Names&, base::Diagnostics&);
    int (*likelihood)(std::string_view text, std::string_view file_name);  ///< 0 to 100
};

[[nodiscard]] std::span<const Control> all_controls();
[[nodiscard]] const Control* find_control(std::string_view name);

struct Guess {
    const Control* control = nullptr;
    int likelihood = 0;
};
/// The control for which the text was most likely written.
[[nodiscard]] Guess guess_control(std::string_view text, std::string_view file_name);

}  // namespace obrys::driver
