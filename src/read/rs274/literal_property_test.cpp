#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cstdlib>

#include "base/number_testing.hpp"
#include "read/rs274/reading.hpp"

namespace obrys::read::rs274 {

using testing::Reading;

namespace {

using base::testing::number_text;

constexpr std::string_view letters = "XYZABCUVWIJKR";

} // namespace

RC_GTEST_PROP(Rs274Literal, BlocksReadBackToTheirValues, ()) {
  const auto numbers = *rc::gen::resize(
      12, rc::gen::nonEmpty(
              rc::gen::container<std::vector<std::string>>(number_text())));
  std::string line = "N10 ";
  const std::size_t n = std::min(numbers.size(), letters.size());
  for (std::size_t i = 0; i < n; ++i)
    line += letters[i] + numbers[i] +
            std::string(static_cast<std::size_t>(*rc::gen::inRange(0, 3)), ' ');
  const Reading r(line + "\nM2\n");
  RC_ASSERT(r.messages() == "");
  RC_ASSERT(r.unit().statements.size() == 2u);
  for (std::size_t i = 0; i < n; ++i)
    RC_ASSERT(r.unit().literal(r.unit().words[i]) ==
              std::strtod(numbers[i].c_str(), nullptr));
}

/// The fast way for plain blocks and the full reader give the same words.
RC_GTEST_PROP(Rs274Literal, BothWaysOfReadingAgree, ()) {
  std::string line;
  const int g = *rc::gen::inRange(-1, 4);
  if (g >= 0)
    line += "G" + std::to_string(g) + " ";
  std::string used;
  for (const char c : *rc::gen::container<std::string>(rc::gen::elementOf(
           std::string("XYZABCUVWF") + (g < 2 ? "" : "IJKR")))) {
    if (used.find(c) != std::string::npos)
      continue;
    used += c;
    const std::string n = *number_text();
    line += c + (c == 'F' && n[0] == '-' ? n.substr(1) : n) + " ";
  }
  RC_PRE(!line.empty() && line.size() < 240); // longer ones are refused
  const Reading fast(line + "\nM2\n");
  const Reading full(line + ";\nM2\n"); // a comment needs the full reader
  RC_ASSERT(fast.messages() == full.messages());
  RC_ASSERT(fast.tree() == full.tree());
}

} // namespace obrys::read::rs274
