#pragma once
/// Recorded runs (CSV): a table of programs with their seconds, and traces of places over time.

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "base/diagnostic.hpp"
#include "base/source.hpp"

namespace obrys::driver {

/// A line of the table. Columns: program, seconds, and of what part of the program: tool; first, last (lines); trace.
struct Run {
    std::string program;
    double seconds = 0;                        ///< 0: the trace says them
    std::optional<std::uint32_t> tool;         ///< with this tool alone
    std::optional<std::uint32_t> first, last;  ///< of these lines of the program alone, both counted
    std::string trace;                         ///< a file; empty: none
    base::Span where, where_trace;
};
/// Separated by commas, or by semicolons (then numbers may have decimal commas). Nothing after a complaint.
[[nodiscard]] std::optional<std::vector<Run>> read_runs(std::uint32_t file, const base::Sources& sources,
                                                        base::Diagnostics& diagnostics);

/// What a trace shows of each of X, Y and Z, at the least: it sees no more than its samples do.
struct Trace {
    double seconds = 0;
    std::array<double, 3> speed{};         ///< mm/s over two samples
    std::array<double, 3> acceleration{};  ///< mm/s2 between such
    std::size_t samples = 0;
};
/// t,x,y,z[,f]: seconds and mm. Nothing after a complaint.
[[nodiscard]] std::optional<Trace> read_trace(std::uint32_t file, const base::Sources& sources,
                                              base::Diagnostics& diagnostics);

}  // namespace obrys::driver
