#pragma once
/// Parts of what is told of a time. Private to report/time.

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "report/time/time.hpp"

namespace obrys::report::time {

[[nodiscard]] std::string seconds(double s);
[[nodiscard]] std::string percent(double part, double all);
[[nodiscard]] std::string_view name_of(sim::time::Cause c);
[[nodiscard]] sim::time::Cause largest(const sim::time::Seconds& s);

struct Line {
    std::uint32_t file = 0, line = 0, begin = 0;  ///< begin: of its first block
    double all = 0;
    sim::time::Seconds seconds{};
};
/// Blocks of one line together, the slowest first, no more than `most`.
[[nodiscard]] std::vector<Line> slow_lines(const sim::time::Times& t, const base::Sources& sources, std::size_t most);

/// How the program's lines lie beside the tolerance, and what others would cost or save.
void put_tolerances(std::string& out, const Subject& s, const base::Sources& sources);
[[nodiscard]] nlohmann::ordered_json tolerances_json(const Subject& s, const base::Sources& sources);

}  // namespace obrys::report::time
