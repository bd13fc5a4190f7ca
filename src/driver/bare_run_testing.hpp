#pragma once
/// Test side only: what a run needs besides its program, all of it empty at
/// first.

#include <string>
#include <string_view>
#include <vector>

#include "cl/text.hpp"
#include "interp/flow/machine.hpp"
#include "interp/interp.hpp"

namespace obrys::driver::testing {

inline constexpr auto no_program =
    [](std::string_view) -> const program::Unit * { return nullptr; };

struct BareRun {
  base::Sources sources;
  base::Diagnostics diagnostics;
  program::Names names;
  shop::Machine machine;
  std::vector<shop::Tool> tools;
  std::vector<shop::Override> overrides;
  std::vector<int> skip;
  std::vector<const program::Unit *> definitions;
  shop::GivenValues variables;
  shop::Budgets budgets;
  cl::CallStacks stacks;

  interp::Outcome run(const program::Unit &main, cl::Sink sink,
                      base::FunctionRef<const program::Unit *(std::string_view)>
                          find = no_program) {
    const interp::Environment environment{sources,     names,    machine, tools,
                                          overrides,   budgets,  skip,    find,
                                          definitions, variables};
    return interp::run(main, environment, stacks, sink, diagnostics);
  }
  /// What was complained about, one a line.
  [[nodiscard]] std::string messages() const {
    std::string all;
    for (const base::Diagnostic &d : diagnostics.all())
      all += d.text + "\n";
    return all;
  }
};

/// A record without its place.
inline std::string placeless(const cl::Record &r) {
  const std::string line = cl::to_text(r);
  return line.substr(0, line.find(" @")) + "\n";
}

} // namespace obrys::driver::testing
