#pragma once
/// Test side only: cutter locations read, with everything that belongs to them.

#include <cmath>
#include <string>

#include "base/diagnostic.hpp"
#include "program/read_text_testing.hpp"
#include "read/apt/read.hpp"

namespace obrys::read::apt::testing {

struct Reading : program::testing::ReadText {
  explicit Reading(std::string text, std::string name = "test.apt") {
    file = sources.add(std::move(name), std::move(text));
    unit = read(file, sources, names, diagnostics);
  }
  [[nodiscard]] std::string tree() const { return tree_of(unit); }
  [[nodiscard]] std::string messages() const { return all_placed(); }
  [[nodiscard]] std::string problems() const {
    return program::testing::problems_of(unit);
  }

  program::Unit unit;
};

/// The literals of the last statement with this code, else NaN.
inline double value(const Reading &r, program::Code code) {
  const auto last = static_cast<std::uint32_t>(r.unit.statements.size() - 1);
  for (std::uint32_t i = r.unit.statements[last].first;
       i < r.unit.words_end(last); ++i)
    if (program::code_of(r.unit.words[i]) == code)
      return r.unit.literal(r.unit.words[i]);
  return NAN;
}
inline bool has_modal(const Reading &r, program::Modal m) {
  for (const program::Word &w : r.unit.words)
    if (program::code_of(w) == program::Code::modal &&
        program::modal_of(w) == m)
      return true;
  return false;
}

} // namespace obrys::read::apt::testing
