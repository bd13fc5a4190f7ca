// Any bytes are read as Klartext without crash; every span lies inside the text and every number inside its table; and
// what was read is run within its budget, whatever it says.
#include <cstddef>
#include <cstdint>
#include <string>
#include <variant>

#include "check_unit.hpp"
#include "interp/flow/machine.hpp"
#include "interp/interp.hpp"
#include "read/heidenhain/read.hpp"

using namespace obrys;

namespace {

/// The program calls itself under any name.
void run(const program::Unit& unit, const base::Sources& sources, program::Names& names) {
    const shop::Machine machine;
    const std::vector<shop::Tool> tools;
    const std::vector<shop::Override> overrides;
    const std::vector<int> skip_levels;
    const std::vector<const program::Unit*> definitions;
    const shop::GivenValues variables;
    shop::Budgets budgets;
    budgets.blocks = 2000;
    budgets.seconds = 2;
    const auto find = [&](std::string_view) { return &unit; };
    cl::CallStacks stacks;
    base::Diagnostics diagnostics;
    const auto sink = [&](const cl::Record&) {};
    const interp::Environment environment{sources, names,       machine, tools,       overrides,
                                          budgets, skip_levels, find,    definitions, variables};
    (void)interp::run(unit, environment, stacks, sink, diagnostics);
    for (const base::Diagnostic& d : diagnostics.all()) {
        if (d.where.file < sources.size()) fuzz::check_span(d.where, sources[d.where.file].text.size());
        (void)base::render(d, sources);
    }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    base::Sources sources;
    const auto file = sources.add("FUZZ.H", std::string(data, data + size), base::BlockNumbers::leading);
    program::Names names;
    base::Diagnostics diagnostics;
    const program::Unit unit = read::heidenhain::read(file, sources, names, diagnostics);
    const std::size_t length = sources[file].text.size();
    fuzz::check_unit(unit, length);
    for (const base::Diagnostic& d : diagnostics.all())
        fuzz::check_span(d.where, length), (void)base::render(d, sources);
    const int score = read::heidenhain::likelihood(sources[file].text, "FUZZ.H");
    fuzz::require(score >= 0 && score <= 100);
    run(unit, sources, names);
    return 0;
}
