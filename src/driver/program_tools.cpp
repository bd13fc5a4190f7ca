#include "driver/program_tools.hpp"

#include <algorithm>
#include <optional>

#include "base/codes.hpp"
#include "base/whole.hpp"

namespace obrys::driver {

using program::Code;

namespace {

/// One definition; nothing where it is none, or has a value that only the run knows.
std::optional<shop::Tool> defined_here(const program::Unit& unit, std::uint32_t index) {
    const program::Statement& s = unit.statements[index];
    shop::Tool tool;
    bool number = false, radius = false;
    const double mm = unit.inch ? 25.4 : 1;
    for (std::uint32_t i = s.first; i < unit.words_end(index); ++i) {
        const program::Word& w = unit.words[i];
        const Code code = program::code_of(w);
        if (code != Code::tool && code != Code::tool_length && code != Code::tool_radius) continue;
        if (!program::is_literal(w)) return std::nullopt;
        const double v = unit.literal(w);
        if (code == Code::tool) {
            const auto n = base::cut<std::uint32_t>(v, 1, 32767);
            number = n.has_value();
            tool.number = n.value_or(0);
        } else if (code == Code::tool_length) {
            tool.length = v * mm;
        } else {
            radius = true;
            tool.radius = v * mm;
            tool.has_no_radius = v == 0;
        }
    }
    if (!number || !radius) return std::nullopt;
    tool.where = unit.span(s);
    return tool;
}

}  // namespace

std::vector<shop::Tool> program_tools(const program::Unit& unit, const std::vector<shop::Tool>& listed,
                                      base::Diagnostics& diagnostics) {
    std::vector<shop::Tool> found;
    std::vector<std::uint32_t> changed;  // defined again as another tool: which one is meant only the run knows
    const auto same_number = [](std::uint32_t n) { return [n](const shop::Tool& t) { return t.number == n; }; };
    for (const std::uint32_t i : unit.tool_definitions) {
        const auto tool = defined_here(unit, i);
        if (!tool || std::any_of(listed.begin(), listed.end(), same_number(tool->number))) continue;
        const auto before = std::find_if(found.begin(), found.end(), same_number(tool->number));
        if (before == found.end())
            found.push_back(*tool);
        else if (before->radius != tool->radius || before->length != tool->length)
            changed.push_back(tool->number);
    }
    std::erase_if(found, [&](const shop::Tool& t) {
        return std::find(changed.begin(), changed.end(), t.number) != changed.end();
    });
    for (const shop::Tool& t : found)
        diagnostics.add(
            {base::Severity::note,
             base::codes::assumption,
             t.where,
             "no tool list has T" + std::to_string(t.number) + ": length and radius of the program are taken",
             {},
             {},
             {}});
    return found;
}

}  // namespace obrys::driver
