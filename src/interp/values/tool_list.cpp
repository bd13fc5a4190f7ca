/// Tools of the list: found, added, put into the spindle.

#include <algorithm>
#include <cmath>

#include "base/codes.hpp"
#include "base/text.hpp"
#include "cl/unknown_tool.hpp"
#include "interp/values/nose_of_tool.hpp"
#include "interp/values/values.hpp"

namespace obrys::interp {

namespace codes = base::codes;

const shop::Tool* find_tool(const Reckoning& run, const ToolState& t) {
    if (t.number == cl::unknown_tool) return nullptr;
    for (const shop::Tool& tool : run.tools) {
        const bool same =
            t.number != 0 ? tool.number == t.number : !t.name.empty() && base::equals_ignoring_case(tool.name, t.name);
        if (same && (tool.edge == t.edge || t.edge == 0)) return &tool;
    }
    return nullptr;
}

void tool_into_spindle(Reckoning& run) {
    run.tool.number = run.tool.prepared;
    run.tool.name = run.tool.prepared_name;
    run.tool.waiting = false;
    run.tool.known = run.tool.edge_known = run.tool.number != cl::unknown_tool;
    if (run.tool.number == 0) {  // T="NAME": the list may know its number
        ToolState any = run.tool;
        any.edge = 0;
        if (const shop::Tool* known = find_tool(run, any)) run.tool.number = known->number;
    }
    run.tool.edge = run.tool.prepared_edge;
}

std::vector<shop::Tool>::iterator add_tool(Reckoning& run, std::uint32_t number) {
    const auto added = run.tools.insert(run.tools.end(), shop::Tool{});
    added->number = number;
    added->where = run.here();
    run.tool.data = find_tool(run, run.tool);  // the list may have moved
    return added;
}

bool is_listed(const Reckoning& run, double number) {
    return std::any_of(run.tools.begin(), run.tools.end(), [&](const shop::Tool& t) { return t.number == number; });
}

void take_offset_radius(Reckoning& run, double number) {
    const auto known = std::find_if(run.tools.begin(), run.tools.end(),
                                    [&](const shop::Tool& t) { return t.number == number && number > 0; });
    const auto radius = known != run.tools.end() ? compensation_radius(*known) : std::nullopt;
    if (known != run.tools.end() && !radius)
        unchecked(run, codes::unknown_value, run.here(),
                  "D" + printed(Value::real(number)) +
                      " names a tool whose radius is not known: the contour is run without compensation",
                  "give the tool with its radius in the job");
    if (known != run.tools.end()) {
        run.modal.compensation_radius = radius.value_or(0);
        run.modal.compensation_orientation = table_orientation(*known).value_or(-1);
    } else if (std::isnan(number))
        unchecked(run, codes::unknown_value, run.here(),
                  "which tool offset D is meant depends on a value that is not known");
    else if (number == 0)
        run.modal.compensation_radius = 0;
    else if (!run.tools.empty())
        alarm(run, codes::tool_missing, run.here(), "D" + printed(Value::real(number)) + " is not in the tool table");
}

}  // namespace obrys::interp
