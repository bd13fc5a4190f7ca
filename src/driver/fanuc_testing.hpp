#pragma once
/// Test side only: FANUC and Haas programs from text to stream.

#include <string>
#include <vector>

#include "base/number.hpp"
#include "driver/bare_run_testing.hpp"
#include "read/rs274/fanuc/read.hpp"

namespace obrys::driver::testing {

struct Ran {
  std::string moves; ///< one a line, without places
  std::string messages;
  std::vector<cl::Record> records;
  interp::Ending ending = interp::Ending::regular;
};

inline Ran run(const std::string &text,
               const read::rs274::FanucOptions &options = {},
               bool haas = false) {
  BareRun bare;
  const auto file =
      bare.sources.add("TEST.NC", text, base::BlockNumbers::n_word);
  const auto units =
      haas ? read::rs274::read_haas(file, bare.sources, bare.names,
                                    bare.diagnostics, options)
           : read::rs274::read_fanuc(file, bare.sources, bare.names,
                                     bare.diagnostics, options);
  if (options.machine == dialect::rs274::FanucMachine::lathe)
    bare.machine.kind = shop::MachineKind::lathe;
  const auto find = [&](std::string_view name) -> const program::Unit * {
    for (const program::Unit &u : units)
      if (u.name == name)
        return &u;
    return nullptr;
  };
  Ran out;
  const auto take = [&](const cl::Record &r) {
    out.records.push_back(r);
    if (cl::is_move(r.step))
      out.moves += placeless(r);
  };
  out.ending = bare.run(units.at(0), take, find).ending;
  out.messages = bare.messages();
  return out;
}

} // namespace obrys::driver::testing
