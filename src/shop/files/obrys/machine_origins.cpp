#include "shop/files/obrys/machine_origins.hpp"

#include <algorithm>
#include <array>

#include "base/codes.hpp"
#include "base/text.hpp"
#include "shop/nearest.hpp"

namespace obrys::shop {
namespace {

constexpr std::array<std::string_view, 3> axis_keys{"rapid", "acceleration", "jerk"};

std::vector<std::string> timed_values(const Machine& machine) {
    std::vector<std::string> names{"tool_change_time", "max_feed", "rapid", "spindle.max"};
    for (const char* key : {"acceleration", "jerk", "tolerance", "corner", "block_time", "look_ahead", "spindle_time",
                            "servo_gain", "window", "strobe_time"})
        names.push_back("motion." + std::string(key));
    for (const std::string_view key : axis_keys) {
        names.push_back("axis." + std::string(key));
        for (const MachineAxis& a : machine.axes) names.push_back("axis." + a.name + "." + std::string(key));
    }
    return names;
}

/// Whether the file says the value of this name itself.
bool is_said(Section& file, const std::string& name) {
    const std::size_t dot = name.find('.'), last = name.rfind('.');
    if (dot == std::string::npos) return file.has(name);
    const std::string key = name.substr(last + 1);
    if (!name.starts_with("axis.")) {
        const Entry* table = file.sub_table(name.substr(0, dot));
        return table != nullptr && find(table->value, key) != nullptr;
    }
    const std::string axis = dot == last ? "" : name.substr(dot + 1, last - dot - 1);
    const auto says = [&](const Value* v) {
        const Entry* of = find(*v, "name");
        return find(*v, key) != nullptr && of != nullptr &&
               (axis.empty() || base::equals_ignoring_case(of->value.text, axis));
    };
    const std::vector<const Value*> axes = file.tables("axis");
    return std::any_of(axes.begin(), axes.end(), says);
}

}  // namespace

void read_origins(Section& file, Machine& machine) {
    for (const MachineAxis& a : machine.axes)
        if (const std::string name = "axis." + a.name + ".rapid"; !is_said(file, name))
            machine.origins[name] = "assumed";
    const Entry* e = file.sub_table("origin");
    if (!e) return;
    Section s(e->value, "[origin]", file.diagnostics());
    const std::vector<std::string> names = timed_values(machine);
    for (const Entry& origin : e->value.entries) {
        const auto name = std::find_if(names.begin(), names.end(),
                                       [&](const std::string& n) { return base::equals_ignoring_case(n, origin.key); });
        if (name == names.end()) {
            const std::string near = nearest(origin.key, names);
            s.error(base::codes::job_file, origin.where,
                    "'" + origin.key + "' is no value of a machine that decides times",
                    near.empty() ? "\"motion.jerk\", \"axis.X.rapid\", \"axis.rapid\" (of all axes), …"
                                 : "did you mean \"" + near + "\"?");
        } else if (!is_said(file, *name)) {
            s.error(base::codes::job_file, origin.where,
                    "'" + origin.key + "' has an origin, but the file does not say its value");
        } else if (const auto text = s.text(origin.key)) {
            machine.origins[*name] = *text;
        }
    }
}

}  // namespace obrys::shop
