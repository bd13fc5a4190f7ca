#include "driver/first_tool.hpp"

#include <algorithm>
#include <string>

#include "base/codes.hpp"

namespace obrys::driver {

using program::Code;

namespace {

/// T, TOOL CALL, TOOL DEF, M6, M61 Q: a word that has to do with which tool is in use.
bool word_selects_tool(const program::Unit& unit, const program::Word& w) {
    const Code code = unit.address(w);
    if (code == Code::tool || code == Code::tool_change || code == Code::tool_definition) return true;
    if (code != Code::m) return false;
    if (!program::is_literal(w)) return true;
    const double number = unit.literal(w);
    return number == 6 || (number != 0 && number == unit.traits->tool_number_function);
}

}  // namespace

bool selects_tool(const program::Unit& unit) {
    return std::any_of(unit.words.begin(), unit.words.end(),
                       [&](const program::Word& w) { return word_selects_tool(unit, w); });
}

std::uint32_t first_tool(const shop::Job& job, const program::Unit& main, base::Diagnostics& diagnostics) {
    if (job.first_tool != 0 || job.tools.empty()) return job.first_tool;
    const std::uint32_t only = job.tools.front().number;
    const bool one =
        std::all_of(job.tools.begin(), job.tools.end(), [only](const shop::Tool& t) { return t.number == only; });
    if (!one || only == 0 || selects_tool(main)) return 0;
    diagnostics.add(
        {base::Severity::note,
         base::codes::assumption,
         base::Span{main.file, 0, 0},
         "no block selects a tool: T" + std::to_string(only) + ", the only one given, is taken to be in use",
         "say so in the job: first_tool = " + std::to_string(only),
         {},
         {}});
    return only;
}

void number_offsets(bool edge_is_offset_number, std::vector<shop::Tool>& tools) {
    if (!edge_is_offset_number) return;
    for (shop::Tool& t : tools)
        if (!t.edge_given && t.number != 0) t.edge = t.number;
}

}  // namespace obrys::driver
