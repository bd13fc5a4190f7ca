#pragma once
/// What every report is made of.

#include <string>
#include <utility>
#include <vector>

#include "base/source.hpp"
#include "check/group.hpp"
#include "check/result.hpp"
#include "check/setup.hpp"
#include "cl/stacks.hpp"

namespace obrys::report {

struct Subject {
    const base::Sources& sources;
    const check::Result& result;
    const check::Setup& setup;
    const cl::CallStacks& stacks;
    std::string program;     ///< path as the user wrote it
    std::string control;     ///< "sinumerik-840d"; empty: not known
    std::string version;     ///< of obrys
    std::string date;        ///< as it is to be shown; empty: no date, so that equal runs give equal reports
    std::string root = {};   ///< absolute folder, a slash at its end, from which paths in logs count; empty: not said
    std::string input = {};  ///< what the check was asked for: the job, or the program itself
    std::string here = {};   ///< absolute folder from which relative names of sources count; empty: as the root
};

/// A place in a source text, counted from 1, for people and machines.
struct Place {
    std::string file;  ///< UTF-8; empty: nowhere
    std::uint32_t line = 0, column = 0, end_line = 0, end_column = 0;
    std::optional<std::uint32_t> block;
    std::string text;  ///< the line, UTF-8, blanks off both ends
};
[[nodiscard]] Place place(const base::Sources& sources, const base::Span& span);

/// "1 finding", "2 findings"
[[nodiscard]] std::string count_of(std::uint64_t n, const std::string& one);
/// The verdict in one line of plain words: "6 findings", "not fully checked: 2 things were not checked; 6 findings".
[[nodiscard]] std::string verdict_line(const check::Result& result);

/// How a key of an amount reads: "depth_x_mm" is "depth along X" in "mm".
struct AmountWords {
    std::string label, unit;
};
[[nodiscard]] AmountWords amount_words(std::string_view key);

/// "40 passes, worst 2.479 mm, first move 12"; empty where the group is one finding.
[[nodiscard]] std::string passes_line(const Subject& subject, const check::Group& group);
/// The places of a group's members: of each file its lines, increasing.
[[nodiscard]] std::vector<std::pair<std::string, std::vector<std::uint32_t>>> lines_of(const Subject& subject,
                                                                                       const check::Group& group);

/// Indices of the groups, the most dangerous ones first: by code, then by depth.
[[nodiscard]] std::vector<std::size_t> by_danger(const check::Result& result, const std::vector<check::Group>& groups);

}  // namespace obrys::report
