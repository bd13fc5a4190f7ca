#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cstdlib>

#include "base/number_testing.hpp"
#include "read/heidenhain/reading.hpp"

namespace obrys::read::heidenhain {

using testing::Reading;

namespace {

rc::Gen<std::string> number_text() { return base::testing::number_text(true); }

/// Words of a plain block, some of which only the full reader takes, and some
/// that nobody takes.
rc::Gen<std::string> word_text() {
  const auto axis = rc::gen::apply(
      [](char letter, const std::string &n) { return letter + n; },
      rc::gen::elementOf(std::string("XYZABCF")), number_text());
  const auto other = rc::gen::element<std::string>(
      "R0", "FMAX", "RL", "M3", "M99", "IX+1", "F MAX", "x1", "Y", "F", "R",
      "X+Q5", "~", "X 5", "K1", "R01", "FMAXX", "U+1");
  return rc::gen::weightedOneOf<std::string>({{5, axis}, {2, other}});
}

double value_of(std::string text) {
  std::replace(text.begin(), text.end(), ',', '.');
  return std::strtod(text.c_str(), nullptr);
}

} // namespace

RC_GTEST_PROP(KlartextLiteral, BlocksReadBackToTheirValues, ()) {
  const auto numbers = *rc::gen::nonEmpty(
      rc::gen::container<std::vector<std::string>>(number_text()));
  const auto letters = *rc::gen::container<std::vector<char>>(
      numbers.size(), rc::gen::elementOf(std::string("XYZABCF")));
  std::string line = "10 L";
  for (std::size_t i = 0; i < numbers.size(); ++i)
    line += std::string(" ") + letters[i] + numbers[i];
  const Reading r(line + "\n");
  RC_ASSERT(r.messages() == "");
  RC_ASSERT(r.unit.statements.size() == 1u);
  RC_ASSERT(r.unit.words.size() == numbers.size() + 1);
  for (std::size_t i = 0; i < numbers.size(); ++i)
    RC_ASSERT(r.unit.literal(r.unit.words[i + 1]) == value_of(numbers[i]));
}

/// The fast way for plain blocks and the full reader give the same words,
/// places and complaints. A block whose number is preceded by the skip sign,
/// and one that ends with a comment, need the full reader.
RC_GTEST_PROP(KlartextLiteral, BothWaysOfReadingAgree, ()) {
  const auto words = *rc::gen::container<std::vector<std::string>>(word_text());
  const auto gap = *rc::gen::element<std::string>(" ", "  ", "\t", " \r ");
  const auto ends = *rc::gen::element<std::string>("\n", "\r\n", " \r\n", "");
  RC_PRE((words.empty() ||
          words.back() !=
              "~")); // at the line's end it means that the block goes on
  std::string line = "1 M5\n10 L"; // a text with a line end: a carriage return
                                   // alone is none then
  for (const std::string &w : words)
    line += gap + w;
  const Reading fast(line + ends);
  const Reading full(line + " ;" + ends);
  RC_ASSERT(full.tree() == fast.tree());
  RC_ASSERT(full.codes() == fast.codes());
  RC_ASSERT(full.unit.statements.size() == fast.unit.statements.size());
  for (std::size_t s = 0; s < fast.unit.statements.size(); ++s) {
    RC_ASSERT(full.unit.statements[s].begin == fast.unit.statements[s].begin);
    RC_ASSERT(full.unit.statements[s].flags == fast.unit.statements[s].flags);
  }
  for (std::size_t w = 2; w < fast.unit.words.size();
       ++w) { // the motion itself stands at the L, or at its block
    RC_ASSERT(full.unit.words[w].code == fast.unit.words[w].code);
    if (program::code_of(fast.unit.words[w]) == program::Code::unknown)
      continue;
    RC_ASSERT(full.unit.words[w].offset == fast.unit.words[w].offset);
    RC_ASSERT(full.unit.words[w].length == fast.unit.words[w].length);
  }
}

} // namespace obrys::read::heidenhain
