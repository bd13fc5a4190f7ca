#pragma once
/// Test side only: a text of any control run to its stream.

#include <string>
#include <vector>

#include "cl/text.hpp"
#include "cl/verify.hpp"
#include "driver/control.hpp"
#include "interp/flow/machine.hpp"
#include "interp/interp.hpp"

namespace obrys::driver::testing {

struct AnyRun {
    std::string moves;  ///< one a line, without places
    std::string messages;
    std::string faults;  ///< rules of the stream that it breaks
    std::vector<cl::Record> records;
};

inline AnyRun run_for(std::string_view control_name, const std::string& text) {
    const Control& control = *find_control(control_name);
    base::Sources sources;
    base::Diagnostics diagnostics;
    program::Names names;
    const Language& language = language_of(control, text, "TEST");
    const auto file = sources.add("TEST", text, language.numbers);
    shop::Machine machine;
    machine.kind = shop::MachineKind::mill;
    const auto units = language.read(file, sources, names, diagnostics, &machine);
    const std::vector<shop::Tool> tools;
    const std::vector<shop::Override> overrides;
    const std::vector<int> skip;
    const std::vector<const program::Unit*> definitions;
    const shop::GivenValues variables;
    const shop::Budgets budgets;
    const auto find = [](std::string_view) -> const program::Unit* { return nullptr; };
    const interp::Environment environment{sources, names, machine, tools,       overrides,
                                          budgets, skip,  find,    definitions, variables};
    cl::CallStacks stacks;
    AnyRun out;
    base::Diagnostics broken;
    cl::Verifier verifier(broken);
    const auto sink = [&](const cl::Record& r) {
        verifier(r);
        out.records.push_back(r);
        if (!cl::is_move(r.step)) return;
        const std::string line = cl::to_text(r);
        out.moves += line.substr(0, line.find(" @")) + "\n";
    };
    (void)interp::run(units.at(0), environment, stacks, sink, diagnostics);
    verifier.finish();
    for (const base::Diagnostic& d : broken.all()) out.faults += d.text + "\n";
    for (const base::Diagnostic& d : diagnostics.all()) out.messages += d.text + "\n";
    return out;
}

}  // namespace obrys::driver::testing
