#pragma once
/// Test side only: a text that a reader has read, and what it said of it.

#include <string>
#include <vector>

#include "base/diagnostic.hpp"
#include "program/tree_text_testing.hpp"

namespace obrys::program::testing {

struct ReadText {
  base::Sources sources;
  program::Names names;
  base::Diagnostics diagnostics;
  std::uint32_t file = 0;

  /// All complaints as they are printed.
  [[nodiscard]] std::string rendered() const {
    std::string out;
    for (const base::Diagnostic &d : diagnostics.all())
      out += base::render(d, sources);
    return out;
  }
  /// line:column text of a complaint.
  [[nodiscard]] std::string placed(const base::Diagnostic &d) const {
    const base::Position at = sources.position(d.where);
    return std::to_string(at.line) + ":" + std::to_string(at.column) + " " +
           d.text;
  }
  /// The same of all complaints, one a line.
  [[nodiscard]] std::string all_placed() const {
    std::string out;
    for (const base::Diagnostic &d : diagnostics.all())
      out += placed(d) + "\n";
    return out;
  }
  /// Of the first complaint; empty where there is none.
  [[nodiscard]] std::string first_message() const {
    return diagnostics.all().empty() ? std::string()
                                     : placed(diagnostics.all().front());
  }
  [[nodiscard]] std::vector<std::string> codes() const {
    std::vector<std::string> out;
    for (const base::Diagnostic &d : diagnostics.all())
      out.emplace_back(d.code);
    return out;
  }
  [[nodiscard]] std::string tree_of(const program::Unit &unit) const {
    return TreeText(unit, names).all();
  }
  [[nodiscard]] std::string word_of(const program::Unit &unit,
                                    std::uint32_t statement,
                                    std::uint32_t word) const {
    const auto &s = unit.statements[statement];
    return std::string(sources.text(unit.span(s, unit.words[s.first + word])));
  }
};

/// What is known and not run, with the reason, one a line.
inline std::string problems_of(const program::Unit &unit) {
  std::string out;
  for (const program::Problem &p : unit.problems)
    out += p.text + ": " + p.reason + "\n";
  return out;
}

} // namespace obrys::program::testing
