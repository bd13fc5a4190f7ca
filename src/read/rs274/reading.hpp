#pragma once
/// Test side only: a text read, with everything that belongs to it.

#include <string>
#include <vector>

#include "base/diagnostic.hpp"
#include "program/read_text_testing.hpp"
#include "read/rs274/read.hpp"

namespace obrys::read::rs274::testing {

using Reader = std::vector<program::Unit> (*)(std::uint32_t,
                                              const base::Sources &,
                                              program::Names &,
                                              base::Diagnostics &);

struct Reading : program::testing::ReadText {
  explicit Reading(std::string text, std::string name = "test.ngc",
                   Reader reader = read_linuxcnc) {
    file = sources.add(std::move(name), std::move(text),
                       base::BlockNumbers::n_word);
    units = reader(file, sources, names, diagnostics);
  }
  [[nodiscard]] const program::Unit &unit(std::size_t i = 0) const {
    return units[i];
  }
  [[nodiscard]] std::string tree(std::size_t i = 0) const {
    return tree_of(units[i]);
  }
  [[nodiscard]] std::string messages() const { return rendered(); }

  std::vector<program::Unit> units;
};

/// The only statement's text form, without its number; complaints instead where
/// there are any.
inline std::string one(const std::string &line) {
  const Reading r(line + "\n");
  if (!r.first_message().empty())
    return r.first_message();
  return r.unit().statements.size() == 1
             ? program::testing::TreeText(r.unit(), r.names).statement(0)
             : r.tree();
}

/// A modal word as TreeText shows it.
inline std::string m(program::Modal modal, int number = 0) {
  return "m" + std::to_string(static_cast<int>(modal)) +
         (number != 0 ? "." + std::to_string(number) : "");
}

} // namespace obrys::read::rs274::testing
