#pragma once
/// Test side only: a text of any control run to its stream.

#include <string>
#include <vector>

#include "cl/verify.hpp"
#include "driver/bare_run_testing.hpp"
#include "driver/control.hpp"

namespace obrys::driver::testing {

struct AnyRun {
  std::string moves; ///< one a line, without places
  std::string messages;
  std::string faults; ///< rules of the stream that it breaks
  std::vector<cl::Record> records;
};

inline AnyRun run_for(std::string_view control_name, const std::string &text) {
  const Control &control = *find_control(control_name);
  BareRun bare;
  const Language &language = language_of(control, text, "TEST");
  const auto file = bare.sources.add("TEST", text, language.numbers);
  bare.machine.kind = shop::MachineKind::mill;
  const auto units = language.read(file, bare.sources, bare.names,
                                   bare.diagnostics, &bare.machine);
  AnyRun out;
  base::Diagnostics broken;
  cl::Verifier verifier(broken);
  (void)bare.run(units.at(0), [&](const cl::Record &r) {
    verifier(r);
    out.records.push_back(r);
    if (cl::is_move(r.step))
      out.moves += placeless(r);
  });
  verifier.finish();
  for (const base::Diagnostic &d : broken.all())
    out.faults += d.text + "\n";
  out.messages = bare.messages();
  return out;
}

} // namespace obrys::driver::testing
