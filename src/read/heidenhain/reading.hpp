#pragma once
/// Test side only: a Klartext read, with everything that belongs to it.

#include <string>
#include <vector>

#include "base/diagnostic.hpp"
#include "program/read_text_testing.hpp"
#include "read/heidenhain/read.hpp"

namespace obrys::read::heidenhain::testing {

struct Reading : program::testing::ReadText {
  explicit Reading(std::string text, std::string name = "TEST.H") {
    file = sources.add(std::move(name), std::move(text),
                       base::BlockNumbers::leading);
    unit = read(file, sources, names, diagnostics);
  }
  [[nodiscard]] std::string tree() const { return tree_of(unit); }
  [[nodiscard]] std::string messages() const { return rendered(); }
  [[nodiscard]] std::string text_of(std::uint32_t statement,
                                    std::uint32_t word) const {
    return word_of(unit, statement, word);
  }

  program::Unit unit;
};

/// The only statement's text form, without its number; complaints instead where
/// there are any, all statements where there are more.
inline std::string one(const std::string &line) {
  const Reading r(line);
  if (!r.diagnostics.all().empty())
    return r.messages();
  return r.unit.statements.size() == 1
             ? program::testing::TreeText(r.unit, r.names).statement(0)
             : r.tree();
}

/// The first complaint's text alone; empty where there is none.
inline std::string complaint(const std::string &text) {
  const Reading r(text);
  return r.diagnostics.all().empty() ? "" : r.diagnostics.all().front().text;
}

/// A word as TreeText prints it.
inline std::string modal(program::Modal m, int number = 0) {
  return "m" + std::to_string(static_cast<int>(m)) +
         (number != 0 ? "." + std::to_string(number) : "");
}

/// A function as TreeText shows it.
inline std::string f(program::Function name, const std::string &arguments) {
  return "f" + std::to_string(static_cast<int>(name)) + "(" + arguments + ")";
}

} // namespace obrys::read::heidenhain::testing
