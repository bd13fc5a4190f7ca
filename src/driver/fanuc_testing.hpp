#pragma once
/// Test side only: FANUC and Haas programs from text to stream.

#include <string>
#include <vector>

#include "base/number.hpp"
#include "cl/text.hpp"
#include "interp/flow/machine.hpp"
#include "interp/interp.hpp"
#include "read/rs274/fanuc_read.hpp"

namespace obrys::driver::testing {

struct Ran {
    std::string moves;  ///< one a line, without places
    std::string messages;
    std::vector<cl::Record> records;
    interp::Ending ending = interp::Ending::regular;
};

inline Ran run(const std::string& text, const read::rs274::FanucOptions& options = {}, bool haas = false) {
    base::Sources sources;
    base::Diagnostics diagnostics;
    program::Names names;
    const auto file = sources.add("TEST.NC", text, base::BlockNumbers::n_word);
    const auto units = haas ? read::rs274::read_haas(file, sources, names, diagnostics, options)
                            : read::rs274::read_fanuc(file, sources, names, diagnostics, options);
    shop::Machine machine;
    if (options.machine == dialect::rs274::FanucMachine::lathe) machine.kind = shop::MachineKind::lathe;
    const std::vector<shop::Tool> tools;
    const std::vector<shop::Override> overrides;
    const std::vector<int> skip;
    const std::vector<const program::Unit*> definitions;
    const shop::GivenValues variables;
    const shop::Budgets budgets;
    const auto find = [&](std::string_view name) -> const program::Unit* {
        for (const program::Unit& u : units)
            if (u.name == name) return &u;
        return nullptr;
    };
    const interp::Environment environment{sources, names, machine, tools,       overrides,
                                          budgets, skip,  find,    definitions, variables};
    cl::CallStacks stacks;
    Ran out;
    out.ending = interp::run(
                     units.at(0), environment, stacks,
                     [&](const cl::Record& r) {
                         out.records.push_back(r);
                         if (!cl::is_move(r.step)) return;
                         const std::string line = cl::to_text(r);
                         out.moves += line.substr(0, line.find(" @")) + "\n";
                     },
                     diagnostics)
                     .ending;
    for (const base::Diagnostic& d : diagnostics.all()) out.messages += d.text + "\n";
    return out;
}

}  // namespace obrys::driver::testing
