#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cstdlib>

#include "base/number_testing.hpp"
#include "read/sinumerik/reading.hpp"

namespace obrys::read::sinumerik {

using testing::Reading;

using base::testing::number_text;

RC_GTEST_PROP(SinumerikLiteral, BlocksReadBackToTheirValues, ()) {
  const auto numbers = *rc::gen::nonEmpty(
      rc::gen::container<std::vector<std::string>>(number_text()));
  const auto letters = *rc::gen::container<std::vector<char>>(
      numbers.size(), rc::gen::elementOf(std::string("XYZABCUVWIJKFSxyz")));
  const auto gaps = *rc::gen::container<std::vector<int>>(
      numbers.size(), rc::gen::inRange(0, 3));
  std::string line = "N10 ";
  for (std::size_t i = 0; i < numbers.size(); ++i)
    line += letters[i] + numbers[i] +
            std::string(static_cast<std::size_t>(gaps[i]), ' ');
  const Reading r(line + "\n");
  RC_ASSERT(r.messages() == "");
  RC_ASSERT(r.unit().statements.size() == 1u);
  RC_ASSERT(r.unit().words.size() == numbers.size());
  for (std::size_t i = 0; i < numbers.size(); ++i)
    RC_ASSERT(r.unit().literal(r.unit().words[i]) ==
              std::strtod(numbers[i].c_str(), nullptr));
}

/// The fast way for plain blocks and the full reader give the same words.
RC_GTEST_PROP(SinumerikLiteral, BothWaysOfReadingAgree, ()) {
  const auto numbers = *rc::gen::nonEmpty(
      rc::gen::container<std::vector<std::string>>(number_text()));
  std::string line;
  for (const std::string &n : numbers)
    line += "Y" + n + " ";
  const Reading fast(line + "\n");
  const Reading full(
      line + ";\nDEF REAL A1\n" + line +
      "\n"); // a comment, and a name like a word: both need the full reader
  const std::string expected = fast.tree();
  RC_ASSERT(full.tree().substr(0, expected.size()) == expected);
  RC_ASSERT(full.tree().ends_with(expected.substr(1)));
}

} // namespace obrys::read::sinumerik
