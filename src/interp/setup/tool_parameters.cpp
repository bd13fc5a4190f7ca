/// $TC_DPn written by the program.

#include <algorithm>
#include <cmath>

#include "base/codes.hpp"
#include "base/whole.hpp"
#include "interp/setup/setup.hpp"

namespace obrys::interp {

namespace codes = base::codes;

namespace {

/// What $TC_DP6 and the like say about the shape; as in a TOA file, geometry and wear add up.
void take_shape(shop::Tool& t) {
    const auto sum = [&](std::initializer_list<int> numbers) {
        double s = 0;
        for (const int n : numbers)
            if (const auto p = t.parameters.find(n); p != t.parameters.end()) s += p->second;
        return s;
    };
    const double radius = sum({6, 15}), type = sum({1});
    t.length = sum({3, 12, 21});
    if (type >= 500 && type < 600) {
        if (t.kind == shop::ToolKind::other && !(type >= 520 && type < 540)) t.kind = shop::ToolKind::turning;
        if (const auto p = t.parameters.find(2); p != t.parameters.end())
            if (const auto n = base::whole<int>(p->second, 1, 9)) t.orientation = *n;
    }
    if (t.kind == shop::ToolKind::turning)
        t.nose_radius = std::max(0.0, radius);
    else if (t.kind == shop::ToolKind::groove)
        t.corner_radius = std::max(0.0, radius);
    else
        t.radius = radius;
}

/// Of turning tools; 0: none is given.
bool has_position_of_no_kind(const shop::Tool& t) {
    const auto type = t.parameters.find(1), position = t.parameters.find(2);
    return type != t.parameters.end() && type->second >= 500 && type->second < 600 && position != t.parameters.end() &&
           !base::whole<int>(position->second, 0, 9);
}

}  // namespace

void write_tool_parameter(Telling& run, double number, double edge, int n, double value) {
    const auto known_t = base::cut<std::uint32_t>(number, 1), known_d = base::cut<std::uint32_t>(edge, 1, 32'000);
    if (std::isnan(number + edge + value))
        return unchecked(run, codes::unknown_value, run.here(),
                         "the tool data written here depend on a value that is not known");
    if (!known_t || !known_d)
        return alarm(run, codes::index_range, run.here(),
                     "there is no tool T" + printed(Value::real(number)) + " with an edge D" +
                         printed(Value::real(edge)) + " whose data could be written");
    const std::uint32_t t = *known_t, d = *known_d;
    auto found = std::find_if(run.tools.begin(), run.tools.end(),
                              [&](const shop::Tool& x) { return x.number == t && x.edge == d; });
    if (found == run.tools.end()) {
        found = add_tool(run, t);
        found->edge = d;
    }
    for (const int k : {1, 2, 3, 6})  // what the job said by other words stays beside the written parameter
        if (const auto v = shop::parameter(*found, k); v && *v != 0) found->parameters.emplace(k, *v);
    found->parameters[n] = value;
    take_shape(*found);
    cl::ToolData data{t, d, {}, {}};
    if (n == 3) data.length = value;
    if (n == 6) data.radius = value;
    emit(run, data);
    if (n <= 2 && has_position_of_no_kind(*found))
        unchecked(run, codes::unknown_value, run.here(),
                  "the cutting edge position ($TC_DP2) of a turning tool is a whole number from 1 to 9");
    if (run.env.machine.kind == shop::MachineKind::mill) compare_with_job(run, *found);
    run.tool.data = find_tool(run, run.tool);
}

}  // namespace obrys::interp
