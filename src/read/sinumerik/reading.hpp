#pragma once
/// Test side only: a text read, with everything that belongs to it.

#include <string>
#include <vector>

#include "base/diagnostic.hpp"
#include "program/read_text_testing.hpp"
#include "read/sinumerik/read.hpp"

namespace obrys::read::sinumerik::testing {

struct Reading : program::testing::ReadText {
  explicit Reading(std::string text, std::string name = "TEST.MPF") {
    file = sources.add(std::move(name), std::move(text),
                       base::BlockNumbers::n_word);
    units = read(file, sources, names, diagnostics);
  }
  [[nodiscard]] const program::Unit &unit() const { return units.front(); }
  [[nodiscard]] std::string tree(std::size_t i = 0) const {
    return tree_of(units[i]);
  }
  [[nodiscard]] std::string messages() const { return rendered(); }
  [[nodiscard]] std::string text_of(std::uint32_t statement,
                                    std::uint32_t word) const {
    return word_of(unit(), statement, word);
  }

  std::vector<program::Unit> units;
};

/// The only statement's text form, without its number; complaints instead where
/// there are any.
inline std::string one(const std::string &line) {
  const Reading r(line);
  if (!r.diagnostics.all().empty())
    return r.messages();
  return r.unit().statements.size() == 1
             ? program::testing::TreeText(r.unit(), r.names).statement(0)
             : r.tree();
}

} // namespace obrys::read::sinumerik::testing
